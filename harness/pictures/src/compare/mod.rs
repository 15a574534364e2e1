//! Two pictures compared: what differs, where, and which simple change explains it.
//!
//! Values are compared as radiance. An 8-bit value stands for all radiance that is rounded or truncated to it,
//! so that a difference within that interval is none. NaN is the worst difference and equals nothing.

mod affected;
mod change;
mod differences;
mod fitted;
mod half_pixel;
mod hypotheses;
mod noise;
mod page;
pub mod pair;
mod picture;
mod regions;
mod text;

use serde::Serialize;

pub use affected::{Affected, article};
pub use change::Change;
pub use differences::Differences;
pub use fitted::{NoPair, fit};
pub use half_pixel::{half_pixel_directions, half_pixel_shifts, half_pixel_words, shift};
pub use hypotheses::{Hypothesis, changes_that_explain, decodings, distance_of, spread};
pub use noise::{has_noise, noise_note, some_pixels};
pub use page::page;
pub use picture::{Decoded, Picture, Transfer};
pub use regions::Region;

/// Values of a picture that are no radiance.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Unusual {
    /// NaN.
    pub nan: u64,
    /// Infinite.
    pub infinite: u64,
    /// Negative.
    pub negative: u64,
}

/// How two pictures of one size compare. `a` is what `b` is held against: differences are `b − a`, and percentages are of
/// `a`. In lists of two, `a` is the first.
#[derive(Clone, Debug, Serialize)]
pub struct Comparison {
    /// What the pictures are called: `ours` and `yours`, if one is that of a scene.
    pub names: [String; 2],
    /// Columns and rows.
    pub size: [u32; 2],
    /// The relative difference up to which channels are equal.
    pub tolerance: f64,
    /// Of each picture.
    pub unusual: [Unusual; 2],
    /// The mean radiance of each picture, over pixels in which both are finite.
    pub means: [[f64; 3]; 2],
    /// The root mean square of the differences of channels, over the same pixels.
    pub root_mean_square: f64,
    /// The number of pixels that differ.
    pub differing: u64,
    /// The connected regions of differing pixels, the largest first; at most ten.
    pub regions: Vec<Region>,
    /// The region with the largest difference, which may be smaller than those.
    pub worst: Option<Region>,
    /// The changes that explain the difference.
    pub explained_by: Vec<Hypothesis>,
    /// What differs most: an object of a scene, or the second picture.
    pub affected: Option<Affected>,
    /// Whether objects are known.
    #[serde(skip)]
    pub are_objects_known: bool,
    /// The known mistakes with which the scene has the other picture, in words; several if it cannot tell them apart.
    pub known_mistakes: Vec<String>,
    /// Of a JPEG that differs from a scene by no more than its compression, by how many steps of 1/255 that changes the mean
    /// of a block of 16 × 16 pixels.
    pub loss: Option<f64>,
    /// What else to know about the difference, in sentences.
    pub notes: Vec<String>,
}

/// Pictures of two sizes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("the sizes differ: {}×{} and {}×{}; render or crop one to the size of the other",
    .0[0], .0[1], .1[0], .1[1])]
pub struct SizesDiffer(pub [u32; 2], pub [u32; 2]);

impl Comparison {
    /// Compares two pictures; channels that are within `tolerance`, relative to the larger, are equal.
    ///
    /// # Errors
    /// If their sizes differ.
    pub fn of(a: &Picture, b: &Picture, tolerance: f64) -> Result<Self, SizesDiffer> {
        Self::named(["A", "B"], [a, b], tolerance)
    }

    /// The same of pictures with these names.
    ///
    /// # Errors
    /// As [`Comparison::of`].
    pub fn named(
        names: [&str; 2],
        [a, b]: [&Picture; 2],
        tolerance: f64,
    ) -> Result<Self, SizesDiffer> {
        if a.size != b.size {
            return Err(SizesDiffer(a.size, b.size));
        }
        let both = [a, b].map(Decoded::new);
        let [a, b] = &both;
        let pixels = a.picture.values.iter().zip(&b.picture.values);
        let differs: Vec<bool> = pixels
            .map(|(x, y)| x.iter().zip(y).any(|(x, y)| !is_equal(a, b, (*x, *y), tolerance)))
            .collect();
        let differing = differs.iter().filter(|differs| **differs).count() as u64;
        let (means, root_mean_square) = statistics(a, b);
        let count = differs.len();
        let whole = (&[(names[1].into(), count as u32)][..], &vec![0; count][..]);
        let (regions, worst) = regions::largest_and_worst(a, b, &differs);
        let explained_by =
            if differing > 0 { hypotheses::explaining(names, a, b) } else { Vec::new() };
        Ok(Self {
            names: names.map(str::to_owned),
            size: a.picture.size,
            tolerance,
            unusual: [unusual(a.picture), unusual(b.picture)],
            means,
            root_mean_square,
            differing,
            regions,
            worst,
            explained_by,
            affected: text::affected(&both, tolerance, whole),
            are_objects_known: false,
            known_mistakes: Vec::new(),
            loss: None,
            notes: Vec::new(),
        })
    }

    /// Whether no pixel differs.
    pub fn is_same(&self) -> bool {
        self.differing == 0
    }

    /// The largest regions, and the one with the largest difference if it is none of them.
    pub fn listed(&self) -> impl Iterator<Item = &Region> {
        // by pixel: values may be NaN
        let is_listed = |it: &Region| self.regions.iter().any(|region| region.worst == it.worst);
        self.regions.iter().chain(self.worst.iter().filter(move |worst| !is_listed(worst)))
    }
}

/// Whether two stored values may stand for the same radiance.
fn is_equal(a: &Decoded<'_>, b: &Decoded<'_>, (x, y): (f32, f32), tolerance: f64) -> bool {
    if x.is_nan() || y.is_nan() {
        return false;
    }
    let ([low_a, high_a], [low_b, high_b]) = (a.interval(x), b.interval(y));
    let apart = (low_a - high_b).max(low_b - high_a).max(0.0);
    // infinite ones are equal if they are the same
    f64::from(x) == f64::from(y) && a.picture.step == b.picture.step
        || apart <= tolerance * low_a.abs().max(low_b.abs())
}

fn unusual(picture: &Picture) -> Unusual {
    let mut unusual = Unusual::default();
    for value in picture.values.as_flattened() {
        unusual.nan += u64::from(value.is_nan());
        unusual.infinite += u64::from(value.is_infinite());
        unusual.negative += u64::from(*value < 0.0);
    }
    unusual
}

/// The radiances of both pictures in each pixel in which both are finite.
fn finite<'a>(a: &'a Decoded<'_>, b: &'a Decoded<'_>) -> impl Iterator<Item = [[f64; 3]; 2]> + 'a {
    let both = (0..a.picture.values.len()).map(|index| [a.at(index), b.at(index)]);
    both.filter(|colors| colors.as_flattened().iter().all(|value| value.is_finite()))
}

fn statistics(a: &Decoded<'_>, b: &Decoded<'_>) -> ([[f64; 3]; 2], f64) {
    let (mut sums, mut squares, mut count) = ([[0.0; 3]; 2], 0.0, 0.0_f64);
    for colors in finite(a, b) {
        count += 1.0;
        for channel in 0..3 {
            let [x, y] = [colors[0][channel], colors[1][channel]];
            sums[0][channel] += x;
            sums[1][channel] += y;
            squares += (x - y) * (x - y);
        }
    }
    let count = count.max(1.0);
    (sums.map(|sum| sum.map(|sum| sum / count)), (squares / (3.0 * count)).sqrt())
}

/// The largest difference of a channel; infinite for NaN, and for infinities that are not the same.
fn difference([x, y]: [[f64; 3]; 2]) -> f64 {
    let of = |(x, y): (f64, f64)| {
        let apart = (x - y).abs();
        if x == y {
            0.0
        } else if apart.is_nan() {
            f64::INFINITY
        } else {
            apart
        }
    };
    x.into_iter().zip(y).map(of).fold(0.0, f64::max)
}
