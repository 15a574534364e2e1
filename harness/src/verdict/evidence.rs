//! A picture beside the mean of ours, from which causes are inferred.

use super::areas::Areas;
use super::map::Map;
use super::{Judged, Stored};

/// A picture beside ours: three values a pixel, as radiance.
#[derive(Clone, Debug)]
pub struct Evidence<'a> {
    /// The areas of the picture.
    pub areas: &'a Areas,
    /// How its values are stored.
    pub stored: Stored,
    /// Theirs.
    pub theirs: Vec<f64>,
    /// The mean of ours.
    pub mean: Vec<f64>,
    /// The variance of the difference.
    pub variances: Vec<f64>,
    /// Whether the difference has noise, of which that is the variance.
    pub has_noise: bool,
}

/// Differences below this part of our value are no evidence.
const LEAST: f64 = 1e-3;

/// Causes are inferred from tiles of this level at most.
const LEVEL: usize = 2;

impl<'a> Evidence<'a> {
    /// That of a judgement; `theirs` is the judged picture with no pixel set apart.
    pub fn of(judged: &Judged, areas: &'a Areas, theirs: &[f32]) -> Self {
        let (pool, last) = (&judged.pool, judged.pool.count() - 1);
        let theirs: Vec<f64> = theirs.iter().map(|value| f64::from(*value)).collect();
        let mean: Vec<f64> = (0..theirs.len()).map(|at| pool.mean_of_others(last, at)).collect();
        let level = mean.iter().sum::<f64>() / mean.len() as f64;
        let map = Map::of(pool, areas, last, judged.ranking.noise[last]);
        let variance = |at: usize| {
            let least = LEAST * mean[at].abs().max(LEAST * level);
            map.variance(&[at / 3], at % 3).max(least * least)
        };
        let variances = (0..theirs.len()).map(variance).collect();
        let (stored, has_noise) = (pool.stored, !judged.is_fixed);
        Self { areas, stored, theirs, mean, variances, has_noise }
    }

    /// The side of these tiles.
    pub fn side(&self) -> usize {
        1 << LEVEL.min(self.areas.levels() - 1)
    }

    /// Sums over tiles, of each channel, of values for each pixel and channel.
    pub fn tiles(&self, value: impl Fn(usize) -> f64) -> Vec<f64> {
        let (pixels, level) = (self.theirs.len() / 3, LEVEL.min(self.areas.levels() - 1));
        let of = |channel: usize| {
            let values = (0..pixels).map(|pixel| value(3 * pixel + channel)).collect();
            (1..=level).fold(values, |sums: Vec<f64>, level| self.areas.coarser(&sums, level))
        };
        (0..3).flat_map(of).collect()
    }

    /// For each tile and channel, one over the variance of the difference; 0 where there is a value that is no number.
    pub fn weights(&self) -> Vec<f64> {
        let of_value = |at: usize| {
            if self.theirs[at].is_finite() { self.variances[at] } else { f64::INFINITY }
        };
        let inverse = |variance: f64| if variance > 0.0 { 1.0 / variance } else { 0.0 };
        self.tiles(of_value).into_iter().map(inverse).collect()
    }
}
