//! Exact sums of replicas: pictures of one scene with other seeds, added on one machine or many.
//!
//! A pixel value `x` counts as the integer `k = x·2⁸⁰`, rounded once. For each pixel and channel a film of sums
//! holds `Σk` and `Σk²`. Sums of integers are associative, so their bits are the same for any division into parts,
//! any order of the parts, and any machine.
//!
//! The mean of replicas is not one picture with more samples. Both have the same expected value, but one large set of
//! stratified samples varies less than the mean of many small sets.

mod audit;
mod file;
mod header;
mod merge;
mod number;
mod scene;
mod seeds;

use std::fmt;

use groundtruth::film::Film;
use groundtruth::rgb::Rgb;

pub use audit::audit;
pub use file::{FileError, SumsFile};
pub use header::{Header, Made};
pub use merge::{Contradiction, MergeError, Plan};
pub use number::{ChannelSums, U256, fixed};
pub use scene::scene_digest;
pub use seeds::Seeds;

/// The sums of all replicas of a picture so far.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Sums {
    /// What they are of; its number of values that are not finite is that of the list.
    header: Header,
    /// Three channels a pixel, row by row from the top left.
    channels: Vec<ChannelSums>,
    /// Ascending. These values count as 0 in the sums.
    not_finite: Vec<NotFinite>,
}

/// A channel of a replica that is NaN or infinite.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct NotFinite {
    /// The seed of the replica.
    pub seed: u64,
    /// Three times the index of the pixel, plus that of the channel.
    pub channel: u64,
    /// The bits of the value.
    pub bits: u64,
}

impl NotFinite {
    fn new(seed: u64, channel: u64, x: f64) -> Self {
        // one NaN for all: its sign and payload depend on the machine
        let bits = if x.is_nan() { f64::NAN } else { x }.to_bits();
        Self { seed, channel, bits }
    }

    /// Those of the three channels of a pixel.
    fn of(values: [f64; 3], [x, y]: [u32; 2], width: u32, seed: u64) -> impl Iterator<Item = Self> {
        let first = 3 * (u64::from(y) * u64::from(width) + u64::from(x));
        let entries = (first..).zip(values).filter(|(_, value)| !value.is_finite());
        entries.map(move |(channel, value)| Self::new(seed, channel, value))
    }

    /// Column and row, from the top left.
    pub fn pixel(&self, width: u32) -> [u32; 2] {
        place(self.channel, width).0
    }
}

/// Sums that do not fit: `|Σx|` reached 2⁴⁷ (about 1.4e14), or `Σx²` reached 2⁹⁶.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Overflow {
    /// Column and row, from the top left.
    pub pixel: [u32; 2],
    /// 0 to 2: red, green, blue.
    pub channel: usize,
}

impl std::error::Error for Overflow {}

impl fmt::Display for Overflow {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let ([x, y], channel) = (self.pixel, ["red", "green", "blue"][self.channel]);
        write!(f, "pixel {x}, {y}: the sum of the {channel} channel reaches 2^47")
    }
}

/// Column and row of the pixel of a channel, and which of its three it is.
fn place(channel: u64, width: u32) -> ([u32; 2], usize) {
    let (pixel, width) = (channel / 3, u64::from(width));
    ([(pixel % width) as u32, (pixel / width) as u32], (channel % 3) as usize)
}

impl Sums {
    /// The sums of no replica.
    pub fn new(header: Header) -> Self {
        let header = Header { seeds: Seeds::default(), not_finite: 0, ..header };
        let channels = vec![ChannelSums::default(); number_of_channels(header.size) as usize];
        Self { header, channels, not_finite: Vec::new() }
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

    /// Three channels a pixel, row by row from the top left.
    pub fn channels(&self) -> &[ChannelSums] {
        &self.channels
    }

    /// The values that are NaN or infinite, ascending by seed and pixel.
    pub fn not_finite(&self) -> &[NotFinite] {
        &self.not_finite
    }

    /// Adds the replica of a seed that was not added before.
    ///
    /// # Errors
    /// The sums of a pixel do not fit; they hold a part of the replica then, and must not be used.
    pub fn add(&mut self, film: &Film, seed: u64) -> Result<(), Overflow> {
        assert_eq!([film.width(), film.height()], self.header.size, "a replica has the same size");
        let values = film.pixels().iter().flat_map(|pixel| pixel.to_array());
        let width = self.header.size[0];
        for (index, (sums, x)) in self.channels.iter_mut().zip(values).enumerate() {
            if x.is_finite() {
                let next = ChannelSums::of(x).and_then(|one| sums.checked_add(one));
                *sums = next.ok_or_else(|| overflow(index, width))?;
            } else {
                self.not_finite.push(NotFinite::new(seed, index as u64, x));
            }
        }
        self.not_finite.sort_unstable();
        self.count(&Seeds::range(seed, 1).expect("one seed fits"));
        Ok(())
    }

    fn count(&mut self, seeds: &Seeds) {
        self.header.seeds = self.header.seeds.union(seeds);
        self.header.not_finite = self.not_finite.len() as u64;
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
        let mut film = (n > 1).then(|| self.film(|sums| sums.standard_error(n)))?;
        for entry in &self.not_finite {
            replace_channel(&mut film, entry.channel, |_| f64::NAN);
        }
        Some(film)
    }

    fn film(&self, value: impl Fn(ChannelSums) -> f64) -> Film {
        let [width, height] = self.header.size;
        let mut film = Film::new(width, height);
        for (pixel, sums) in self.channels.chunks_exact(3).enumerate() {
            let (at, _) = place(3 * pixel as u64, width);
            film.set(at, Rgb::new(value(sums[0]), value(sums[1]), value(sums[2])));
        }
        for entry in &self.not_finite {
            replace_channel(&mut film, entry.channel, |sum| sum + f64::from_bits(entry.bits));
        }
        film
    }
}

fn replace_channel(film: &mut Film, channel: u64, change: impl Fn(f64) -> f64) {
    let (at, which) = place(channel, film.width());
    let mut values = film.get(at).to_array();
    values[which] = change(values[which]);
    let [r, g, b] = values;
    film.set(at, Rgb::new(r, g, b));
}

fn overflow(index: usize, width: u32) -> Overflow {
    let (pixel, channel) = place(index as u64, width);
    Overflow { pixel, channel }
}

/// Three for each pixel.
fn number_of_channels([width, height]: [u32; 2]) -> u64 {
    3 * u64::from(width) * u64::from(height)
}
