//! Exact sums of replicas: pictures of one scene with other seeds, added on one machine or many.
//!
//! A pixel value `x` counts as the integer `k = x·2⁸⁰`, rounded once. For each pixel and channel a film of sums
//! holds `Σk` and `Σk²`. Sums of integers are associative, so their bits are the same for any division into parts,
//! any order of the parts, and any machine.
//!
//! The mean of replicas is not one picture with more samples. Both have the same expected value, but one large set of
//! stratified samples varies less than the mean of many small sets.

mod file;
mod header;
mod merge;
mod number;
mod scene;
mod seeds;

use groundtruth::film::Film;
use groundtruth::rgb::Rgb;

pub use file::FileError;
pub use header::{Header, Made};
pub use merge::{Contradiction, MergeError, Merged, merged};
pub use number::{ChannelSums, U256, fixed};
pub use scene::scene_digest;
pub use seeds::Seeds;

/// The sums of all replicas of a picture so far.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Sums {
    header: Header,
    /// Three channels a pixel, row by row from the top left.
    channels: Vec<ChannelSums>,
}

/// Sums that do not fit: `|Σx|` reached 2⁴⁷ (about 1.4e14), or `Σx²` reached 2⁹⁶.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("pixel {}, {}: the sum of the {} channel reaches 2^47", pixel[0], pixel[1], ["red", "green", "blue"][*channel])]
pub struct Overflow {
    /// Column and row, from the top left.
    pub pixel: [u32; 2],
    /// 0 to 2: red, green, blue.
    pub channel: usize,
}

impl Sums {
    /// The sums of no replica.
    pub fn new(header: Header) -> Self {
        let header = Header { seeds: Seeds::default(), ..header };
        let channels = vec![ChannelSums::default(); header.channels()];
        Self { header, channels }
    }

    /// What they are of.
    pub fn header(&self) -> &Header {
        &self.header
    }

    /// Changes which seeds all parts together have, and by which arguments the scene is selected.
    #[must_use]
    pub fn asked(mut self, wanted: Seeds, arguments: Vec<String>) -> Self {
        self.header.wanted = wanted;
        self.header.arguments = arguments;
        self
    }

    /// The pixels (column and row from the top left) with a value that is NaN or infinite.
    pub fn not_finite(&self) -> impl Iterator<Item = [u32; 2]> {
        let pixels = self.channels.chunks_exact(3).enumerate();
        let wrong = pixels.filter(|(_, sums)| sums.iter().any(|channel| channel.others != 0));
        wrong.map(|(pixel, _)| self.place(pixel))
    }

    /// Adds the replica of a seed that was not added before.
    ///
    /// # Errors
    /// The sums of a pixel do not fit; they hold a part of the replica then, and must not be used.
    pub fn add(&mut self, film: &Film, seed: u64) -> Result<(), Overflow> {
        assert_eq!([film.width(), film.height()], self.header.size, "a replica has the same size");
        let values = film.pixels().iter().flat_map(|pixel| pixel.to_array());
        self.add_each(values.map(ChannelSums::of))?;
        let seed = Seeds::range(seed, 1).expect("one seed fits");
        self.header.seeds = self.header.seeds.union(&seed);
        Ok(())
    }

    /// Adds sums to those of each channel; `None` if they do not fit by themselves.
    fn add_each(
        &mut self,
        more: impl Iterator<Item = Option<ChannelSums>>,
    ) -> Result<(), Overflow> {
        for (index, more) in more.enumerate() {
            let sum = more.and_then(|more| self.channels[index].checked_add(more));
            let overflow = || Overflow { pixel: self.place(index / 3), channel: index % 3 };
            self.channels[index] = sum.ok_or_else(overflow)?;
        }
        Ok(())
    }

    /// The mean of the replicas, each channel rounded once. A channel of which a replica is NaN or infinite is the
    /// floating-point sum of these values.
    pub fn mean(&self) -> Film {
        let n = self.header.seeds.count();
        self.film(|sums| sums.mean(n))
    }

    /// The standard error of the mean, from the differences between the replicas; `None` for fewer than two. NaN
    /// where a replica is NaN or infinite.
    pub fn standard_error(&self) -> Option<Film> {
        let n = self.header.seeds.count();
        (n > 1).then(|| self.film(|sums| sums.standard_error(n)))
    }

    fn film(&self, value: impl Fn(ChannelSums) -> f64) -> Film {
        let [width, height] = self.header.size;
        let mut film = Film::new(width, height);
        for (pixel, sums) in self.channels.chunks_exact(3).enumerate() {
            film.set(self.place(pixel), Rgb::new(value(sums[0]), value(sums[1]), value(sums[2])));
        }
        film
    }

    /// Column and row of a pixel, by its index.
    fn place(&self, pixel: usize) -> [u32; 2] {
        let width = self.header.size[0] as usize;
        [pixel % width, pixel / width].map(|along| along as u32)
    }
}
