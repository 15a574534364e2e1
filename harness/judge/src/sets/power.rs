//! What would have been seen: changes planted in the pictures before.

use serde::Serialize;

use super::sums::{channels, slope};
use super::{SetEvidence, Sets};
use crate::verdict::Area;
use crate::verdict::residuals::{around, mean_of};

/// The gains that are tried.
const GAINS: [f64; 11] = [0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 3.0];

/// A planted change is this part of the one that is promised: other pictures have other noise, which may be against it, and
/// another estimate of its variance.
const PART: f64 = 0.6;

/// The side of the patch.
const PATCH: usize = 16;

/// Changes that would have been seen.
#[derive(Clone, Debug, Serialize)]
pub struct Power {
    /// The smallest gain of the whole picture that is sure to be seen; `None` if none of those tried is.
    pub gain: Option<f64>,
    /// The side of a patch.
    pub patch: usize,
    /// Its left column and top row: it is of about median brightness.
    pub corner: [usize; 2],
    /// The smallest gain of it that is sure to be seen.
    pub gain_of_patch: Option<f64>,
    /// Whether it is sure to be seen that one lamp of twelve is missing: see `one_lamp`.
    pub lamp: bool,
    /// Whether a shift by half a pixel is sure to be seen: along rows, and down columns.
    pub shift: [bool; 2],
}

impl Power {
    /// Of sets that agree.
    pub fn of(sets: &Sets, evidence: &SetEvidence<'_>) -> Self {
        let mean = mean_of(&sets.before);
        let patch = PATCH.min(sets.areas.size[0]).min(sets.areas.size[1]);
        let corner = usual_patch(&mean, sets, patch);
        let in_patch = within(&mean, sets, corner, patch);
        Self {
            gain: smallest(&mean, evidence),
            patch,
            corner,
            gain_of_patch: smallest(&in_patch, evidence),
            lamp: is_seen(&one_lamp(&mean, sets.areas.size), PART, evidence),
            shift: [0, 1]
                .map(|axis| is_seen(&half_shift(&mean, sets.areas.size, axis), PART, evidence)),
        }
    }
}

/// The smallest of the gains for which this change is seen with either sign.
fn smallest(change: &[f64], evidence: &SetEvidence<'_>) -> Option<f64> {
    // what a gain shows, larger ones show
    let (mut low, mut high) = (0, GAINS.len());
    while low < high {
        let middle = (low + high) / 2;
        let is_seen = is_seen(change, PART * GAINS[middle], evidence);
        if is_seen { high = middle } else { low = middle + 1 }
    }
    GAINS.get(low).copied()
}

/// Whether so many times this change of the pictures before is seen, against what noise adds to it.
fn is_seen(change: &[f64], times: f64, evidence: &SetEvidence<'_>) -> bool {
    [-1.0, 1.0].iter().all(|sign| {
        let change: Vec<f64> = change.iter().map(|value| sign * times * value).collect();
        let changed = evidence.sums.with_added(&change, &evidence.of_change);
        !evidence.found(&changed).sums.is_empty()
    })
}

/// The picture within a patch with this corner, and black elsewhere.
fn within(mean: &[f64], sets: &Sets, corner: [usize; 2], side: usize) -> Vec<f64> {
    let mut patch = vec![0.0; mean.len()];
    for pixel in sets.areas.pixels(Area::Tile { corner, side }) {
        patch[3 * pixel..][..3].copy_from_slice(&mean[3 * pixel..][..3]);
    }
    patch
}

/// The corner of a patch of about median brightness: of all of this side beside each other, without what is left over.
fn usual_patch(mean: &[f64], sets: &Sets, side: usize) -> [usize; 2] {
    let [width, height] = sets.areas.size;
    let columns = || (0..width / side).map(|column| column * side);
    let corners = (0..height / side).flat_map(|row| columns().map(move |x| [x, row * side]));
    let brightness = |[x, y]: [usize; 2]| -> f64 {
        let rows = (y..y + side).map(|row| 3 * (row * width + x));
        rows.map(|start| mean[start..start + 3 * side].iter().sum::<f64>()).sum()
    };
    let mut all: Vec<(f64, [usize; 2])> = corners.map(|it| (brightness(it), it)).collect();
    all.sort_by(|a, b| a.0.total_cmp(&b.0));
    all[all.len() / 2].1
}

/// Lamps in a row, and rows.
const LAMPS: [usize; 2] = [4, 3];

/// What one lamp of twelve adds to a picture: they hang in a grid over it, as high as they are apart, and light it by the
/// inverse square of the distance. It is the one whose light is the median of all.
fn one_lamp(mean: &[f64], [width, height]: [usize; 2]) -> Vec<f64> {
    let apart = [width as f64 / LAMPS[0] as f64, height as f64 / LAMPS[1] as f64];
    let lamps = (0..LAMPS[1]).flat_map(|row| (0..LAMPS[0]).map(move |column| [column, row]));
    let light = |lamp: [usize; 2], pixel: usize| {
        let at = [pixel % width, pixel / width];
        let away = [0, 1].map(|i| (at[i] as f64 + 0.5) / apart[i] - (lamp[i] as f64 + 0.5));
        1.0 / (1.0 + away[0] * away[0] + away[1] * away[1])
    };
    let pixels = 0..width * height;
    let of_all: Vec<f64> =
        pixels.clone().map(|pixel| lamps.clone().map(|lamp| light(lamp, pixel)).sum()).collect();
    let part = |lamp: [usize; 2]| -> Vec<f64> {
        let share = |index: usize| light(lamp, index / 3) / of_all[index / 3];
        (0..mean.len()).map(|index| share(index) * mean[index]).collect()
    };
    let mut sums: Vec<(f64, [usize; 2])> =
        lamps.clone().map(|lamp| (part(lamp).iter().sum(), lamp)).collect();
    sums.sort_by(|a, b| a.0.total_cmp(&b.0));
    part(sums[sums.len() / 2].1)
}

/// What a shift by half a pixel to the left, or up, adds to a picture. The picture is smoothed first: the noise of its mean
/// would be taken for edges.
fn half_shift(mean: &[f64], size: [usize; 2], axis: usize) -> Vec<f64> {
    let slopes = channels(mean).map(|channel| slope(&around(&channel, size), size, axis));
    (0..mean.len()).map(|index| 0.5 * slopes[index % 3][index / 3]).collect()
}
