//! Two pictures compared: to the last bit, up to drift, or with a tolerance.

use std::collections::HashSet;

use groundtruth::film::Film;

/// How a picture compares with the one that was expected.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Comparison {
    /// The same bits.
    Same,
    /// Every channel of every pixel is within [`DRIFT`], as after a change of the order of sums.
    Drift,
    /// A larger difference.
    Changed,
}

/// The largest relative difference of a channel that is still drift: about eight times the
/// distance between neighbouring numbers of single precision.
pub const DRIFT: f64 = 1e-6;

/// Compares two pictures as files store them, in single precision.
pub fn verdict(expected: &Film, got: &Film) -> Comparison {
    if !same_size(expected, got) {
        return Comparison::Changed;
    }
    let channels = || expected.to_f32().zip(got.to_f32()).flat_map(|(a, b)| a.into_iter().zip(b));
    if channels().all(|(a, b)| a.to_bits() == b.to_bits()) {
        Comparison::Same
    } else if channels().all(|(a, b)| a.to_bits() == b.to_bits() || within(a, b, DRIFT, 0.0)) {
        Comparison::Drift
    } else {
        Comparison::Changed
    }
}

fn same_size(a: &Film, b: &Film) -> bool {
    (a.width(), a.height()) == (b.width(), b.height())
}

/// `|a − b| ≤ relative · max(|a|, |b|)`, with the maximum at least `floor`; false for NaN.
fn within(a: f32, b: f32, relative: f64, floor: f64) -> bool {
    let (a, b) = (f64::from(a), f64::from(b));
    (a - b).abs() <= relative * a.abs().max(b.abs()).max(floor)
}

/// A pixel in which two pictures differ.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DifferingPixel {
    /// x right and y down, from 0.
    pub pixel: [u32; 2],
    /// The expected colour.
    pub expected: [f32; 3],
    /// The actual colour.
    pub got: [f32; 3],
    /// The largest absolute difference of a channel; infinite if it is NaN.
    pub size: f64,
}

/// The pixels whose bits differ, the largest difference first. Both pictures have the same size.
pub fn differences(expected: &Film, got: &Film) -> Vec<DifferingPixel> {
    let mut all = Vec::new();
    for (i, (a, b)) in expected.to_f32().zip(got.to_f32()).enumerate() {
        if a.map(f32::to_bits) != b.map(f32::to_bits) {
            let channel = |c: usize| (f64::from(a[c]) - f64::from(b[c])).abs();
            let channels = [channel(0), channel(1), channel(2)];
            let not_a_number = channels.iter().any(|c| c.is_nan());
            let size = channels.into_iter().fold(0.0, f64::max);
            let i = i as u32;
            all.push(DifferingPixel {
                pixel: [i % expected.width(), i / expected.width()],
                expected: a,
                got: b,
                size: if not_a_number { f64::INFINITY } else { size },
            });
        }
    }
    all.sort_by(|a, b| b.size.total_cmp(&a.size));
    all
}

/// The allowed difference between pictures of different programs.
///
/// "99 % of the pixels agree" would accept a wrong line one pixel wide, so clusters of differing pixels
/// are limited too.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tolerance {
    /// The largest relative difference of a channel in a pixel that agrees.
    pub relative: f64,
    /// Channels below this are compared as if they were this large.
    pub floor: f64,
    /// The largest share of pixels that do not agree.
    pub share: f64,
    /// The most pixels in a cluster: pixels that do not agree, connected by sides or corners.
    pub cluster: u32,
}

/// The pixels that do not agree within a [`Tolerance`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Disagreement {
    /// The share of pixels that do not agree.
    pub share: f64,
    /// The number of pixels in the largest cluster.
    pub cluster: u32,
}

impl Tolerance {
    /// Whether the pictures have the same size and differ no more than allowed.
    pub fn accepts(&self, expected: &Film, got: &Film) -> bool {
        if !same_size(expected, got) {
            return false;
        }
        let found = self.disagreement(expected, got);
        found.share <= self.share && found.cluster <= self.cluster
    }

    /// The disagreement of two pictures of the same size.
    pub fn disagreement(&self, expected: &Film, got: &Film) -> Disagreement {
        let mut apart = HashSet::new();
        for (i, (a, b)) in expected.to_f32().zip(got.to_f32()).enumerate() {
            if (0..3).any(|c| !within(a[c], b[c], self.relative, self.floor)) {
                let (x, y) = (i as i64 % i64::from(got.width()), i as i64 / i64::from(got.width()));
                apart.insert((x, y));
            }
        }
        let pixels = f64::from(got.width()) * f64::from(got.height());
        Disagreement { share: apart.len() as f64 / pixels, cluster: largest_cluster(apart) }
    }
}

/// The size of the largest set of pixels connected by sides or corners.
fn largest_cluster(mut pixels: HashSet<(i64, i64)>) -> u32 {
    let mut largest = 0;
    while let Some(&start) = pixels.iter().next() {
        pixels.remove(&start);
        let (mut size, mut border) = (0, vec![start]);
        while let Some((x, y)) = border.pop() {
            size += 1;
            for (dx, dy) in [(-1, -1), (0, -1), (1, -1), (-1, 0), (1, 0), (-1, 1), (0, 1), (1, 1)] {
                let next = (x + dx, y + dy);
                if pixels.remove(&next) {
                    border.push(next);
                }
            }
        }
        largest = largest.max(size);
    }
    largest
}
