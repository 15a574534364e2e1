//! Which ways of storing values a picture leaves open: ours are put through each, and theirs must be like them.

use std::collections::BTreeMap;

use groundtruth::film::Film;
use groundtruth::rgb::Rgb;
use rayon::prelude::*;

use super::areas::BACKGROUND;
use super::{Area, Areas, Stored};
use pictures::compare::{Picture, Transfer, spread};

/// About so many pixels are held against all ways, and so many against those that are left.
const PIXELS: [usize; 2] = [1 << 10, 1 << 14];

/// A way is left open if it is no farther off than the nearest by so many standard deviations.
const DEVIATIONS: f64 = 4.0;

/// So many ways are left open at most.
const MOST: usize = 6;

/// The ways of storing that the values of a picture leave open, the likeliest first; of ways that store our pictures
/// alike, the first. `films` are some of ours.
///
/// The squares of the differences of their integers from the mean of ours are least for the way that was used, whatever
/// the noise is: the mean has the least squares. Of two ways, the differences of the squares in all pixels have a mean and a
/// variance, which say whether one is farther off by more than chance.
pub fn plausible(candidates: &[Stored], theirs: &Picture, films: &[Film]) -> Vec<Stored> {
    let mut open = candidates.to_vec();
    for most in PIXELS {
        if open.len() > 1 {
            let pixels = tried(&films[0], most);
            open = nearest(&open, theirs, films, &pixels);
        }
    }
    open.truncate(MOST);
    open
}

/// The ways to read a picture, one for each usual way to encode radiance if nothing says which it is: in each, the
/// likeliest rounding. A grey or coloured background rules out the ways in which it would have another value.
pub(super) fn readings(
    candidates: &[Stored],
    theirs: &Picture,
    films: &[Film],
    areas: &Areas,
) -> Vec<Stored> {
    let of_transfers = candidates.chunk_by(|a, b| a.transfer() == b.transfer());
    let usual = of_transfers.filter(|its| its[0].transfer() != Some(Transfer::Gamma(RARE)));
    let all: Vec<Stored> = usual.map(|its| plausible(its, theirs, films)[0]).collect();
    let Some((ours, theirs)) = background(theirs, &films[0], areas) else { return all };
    let is_it = |it: &&Stored| {
        let integers = it.integers(ours);
        // truncated by one program, rounded by the other
        integers.is_some_and(|its| its.iter().zip(&theirs).all(|(a, b)| (a - b).abs() <= 1.0))
    };
    let settled: Vec<Stored> = all.iter().filter(is_it).copied().collect();
    if settled.is_empty() { all } else { settled }
}

/// This gamma is seldom used, and near that of 2.2: it explains no mistake that that one does not.
const RARE: f64 = 2.4;

/// The colour of the background, and its most usual integers in the other picture; `None` if it is black, beyond white, or
/// not the same everywhere.
fn background(theirs: &Picture, ours: &Film, areas: &Areas) -> Option<(Rgb, [f64; 3])> {
    let object = areas.objects.iter().position(|(name, _)| &**name == BACKGROUND)?;
    let pixels = areas.pixels(Area::Object(object));
    let color = ours.pixels()[*pixels.first()?];
    let count = |of: &dyn Fn(usize) -> bool| pixels.iter().filter(|pixel| of(**pixel)).count();
    // those at its edge show something else, too
    let is_one = 2 * count(&|pixel| ours.pixels()[pixel] == color) > pixels.len();
    let is_between = color.to_array().iter().any(|value| (0.02..0.98).contains(value));
    let step = theirs.step.filter(|_| is_one && is_between)?;
    let mut counts: BTreeMap<[u32; 3], usize> = BTreeMap::new();
    for pixel in &pixels {
        let integers = theirs.values[*pixel].map(|value| (f64::from(value) / step).round() as u32);
        *counts.entry(integers).or_default() += 1;
    }
    let (most, _) = counts.into_iter().max_by_key(|(_, count)| *count)?;
    Some((color, most.map(f64::from)))
}

/// About so many pixels, evenly spread, and as many of those in which ours is brighter than display values can be.
fn tried(film: &Film, most: usize) -> Vec<usize> {
    let colors = film.pixels();
    let bright: Vec<usize> = (0..colors.len()).filter(|pixel| colors[*pixel].max() > 1.0).collect();
    let bright = spread(bright.len(), most).map(|at| bright[at]);
    let mut pixels: Vec<usize> = spread(colors.len(), most).chain(bright).collect();
    pixels.sort_unstable();
    pixels.dedup();
    pixels
}

/// One way, and what comes of it.
struct Held {
    stored: Stored,
    /// The mean of the integers of ours, for each pixel that is tried.
    means: Vec<[f64; 3]>,
    /// The squares of the differences from them, for each pixel.
    squares: Vec<f64>,
    total: f64,
}

/// Those that are about as near as the nearest, which is the first.
fn nearest(open: &[Stored], theirs: &Picture, films: &[Film], pixels: &[usize]) -> Vec<Stored> {
    let mut all: Vec<Held> =
        open.par_iter().filter_map(|stored| Held::of(*stored, theirs, films, pixels)).collect();
    // of equal ones, the first remains the first
    all.sort_by(|a, b| a.total.total_cmp(&b.total));
    let mut left: Vec<&Held> = Vec::new();
    for held in &all {
        let is_new = left.iter().all(|other| other.means != held.means);
        if is_new && left.first().is_none_or(|best| !held.is_farther_than(best)) {
            left.push(held);
        }
    }
    if left.is_empty() { open.to_vec() } else { left.iter().map(|held| held.stored).collect() }
}

impl Held {
    /// `None` for values that are no integers.
    fn of(stored: Stored, theirs: &Picture, films: &[Film], pixels: &[usize]) -> Option<Self> {
        let step = theirs.step?;
        let mean = |pixel: usize| {
            let mut sums = [0.0; 3];
            for film in films {
                let integers = stored.integers(film.pixels()[pixel])?;
                sums = [0, 1, 2].map(|channel| sums[channel] + integers[channel]);
            }
            Some(sums.map(|sum| sum / films.len() as f64))
        };
        let means = pixels.iter().map(|pixel| mean(*pixel)).collect::<Option<Vec<[f64; 3]>>>()?;
        let squares_of = |(pixel, mean): (&usize, &[f64; 3])| {
            let integers = theirs.values[*pixel].map(|value| f64::from(value) / step);
            let apart = integers.into_iter().zip(mean).map(|(integer, mean)| integer - mean);
            // a changed picture has values that are no numbers at its edge
            apart.filter(|apart| apart.is_finite()).map(|apart| apart * apart).sum::<f64>()
        };
        let squares: Vec<f64> = pixels.iter().zip(&means).map(squares_of).collect();
        let total = squares.iter().sum();
        Some(Self { stored, means, squares, total })
    }

    /// Whether it is farther off than another by more than chance.
    fn is_farther_than(&self, other: &Self) -> bool {
        let count = self.squares.len() as f64;
        let mean = (self.total - other.total) / count;
        let apart = self.squares.iter().zip(&other.squares).map(|(a, b)| a - b - mean);
        let variance = apart.map(|apart| apart * apart).sum::<f64>();
        self.total - other.total > DEVIATIONS * variance.sqrt()
    }
}
