//! A picture beside the mean of ours, from which causes are inferred.

use std::mem::take;

use pictures::compare::spread;

use super::residuals::{Residuals, around};
use super::{Areas, Pool, Stored};

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
    /// The variance by which the difference is weighted: that of noise, but not too small.
    pub variances: Vec<f64>,
    /// The variance that the difference has by noise alone; 0 where all of ours agree.
    pub noise: Vec<f64>,
    /// The pixels of each tile.
    pub blocks: Vec<Vec<usize>>,
}

/// Differences below this part of our value are no evidence.
const LEAST: f64 = 1e-3;

/// Where ours hardly differ, their variance weighs as at least this part of that around it.
const SMALLEST_VARIANCE: f64 = 0.01;

/// Causes are inferred from tiles of this level at most.
const LEVEL: usize = 2;

impl<'a> Evidence<'a> {
    /// That of the last picture of a pool, whose noise is this part of that of the others; `theirs` are its values with no
    /// pixel set apart. A wrong picture's finest details are no noise, so the variance is that of ours.
    pub fn of(pool: &Pool, noise_of_theirs: f64, areas: &'a Areas, theirs: &[f32]) -> Self {
        let last = pool.count() - 1;
        let theirs: Vec<f64> = theirs.iter().map(|value| f64::from(*value)).collect();
        let mean: Vec<f64> = (0..theirs.len()).map(|at| pool.mean_of_others(last, at)).collect();
        let level = mean.iter().sum::<f64>() / mean.len() as f64;
        let own = noise_of_theirs.min(1.0);
        let factor = own * own + pool.variance_of_mean();
        let (mut variances, mut noise) = (vec![0.0; theirs.len()], vec![0.0; theirs.len()]);
        for channel in 0..3 {
            let outliers = &mut vec![0.0; theirs.len() / 3];
            let Residuals { variance, varied, .. } = Residuals::of(pool, last, channel, outliers);
            let around = around(&variance, areas.size);
            for pixel in 0..variance.len() {
                let at = 3 * pixel + channel;
                let least = LEAST * mean[at].abs().max(LEAST * level);
                let rounding = pool.stored.rounding(mean[at]);
                if varied[pixel] {
                    noise[at] = factor * variance[pixel] + rounding * rounding;
                }
                let smallest = SMALLEST_VARIANCE * factor * around[pixel];
                variances[at] = noise[at].max(smallest).max(least * least + rounding * rounding);
            }
        }
        let level = LEVEL.min(areas.levels() - 1);
        let [across, down] = areas.grid(level);
        let blocks = (0..across * down).map(|index| areas.pixels(areas.tile(level, index)));
        let (stored, blocks) = (pool.stored, blocks.collect());
        Self { areas, stored, theirs, mean, variances, noise, blocks }
    }

    /// The side of these tiles.
    pub fn side(&self) -> usize {
        1 << LEVEL.min(self.areas.levels() - 1)
    }

    /// Sums over tiles, of each channel, of values for each pixel and channel.
    pub fn tiles(&self, value: impl Fn(usize) -> f64) -> Vec<f64> {
        let of_channel = |channel: usize| {
            let value = |pixel: &usize| value(3 * pixel + channel);
            self.blocks.iter().map(|block| block.iter().map(value).sum()).collect::<Vec<f64>>()
        };
        [0, 1, 2].map(of_channel).concat()
    }

    /// The picture less the mean of ours, over tiles.
    pub fn difference(&self) -> Vec<f64> {
        self.tiles(|at| finite(self.theirs[at] - self.mean[at]))
    }

    /// Keeps about so many tiles: those in which the picture differs most, and as many that are evenly spread.
    pub fn keep(&mut self, most: usize) {
        if self.blocks.len() <= most {
            return;
        }
        let (difference, weights) = (self.difference(), self.weights());
        let count = self.blocks.len();
        let square = |tile: usize| -> f64 {
            let channels = (0..3).map(|channel| channel * count + tile);
            channels.map(|at| weights[at] * difference[at] * difference[at]).sum()
        };
        let mut order: Vec<(f64, usize)> = (0..count).map(|tile| (square(tile), tile)).collect();
        order.sort_by(|a, b| b.0.total_cmp(&a.0));
        let rest = spread(count - most / 2, most / 2).map(|at| order[most / 2 + at].1);
        let mut kept: Vec<usize> = order[..most / 2].iter().map(|it| it.1).chain(rest).collect();
        kept.sort_unstable();
        self.blocks = kept.into_iter().map(|tile| take(&mut self.blocks[tile])).collect();
    }

    /// For each tile and channel, one over the variance of the difference; 0 where there is a value that is no number.
    pub fn weights(&self) -> Vec<f64> {
        let of_value = |at: usize| {
            if self.theirs[at].is_finite() { self.variances[at] } else { f64::INFINITY }
        };
        let inverse = |variance: f64| if variance > 0.0 { 1.0 / variance } else { 0.0 };
        self.tiles(of_value).into_iter().map(inverse).collect()
    }

    /// For each tile and channel, the weighted square of a difference that is noise, on average.
    pub fn squares_of_noise(&self) -> Vec<f64> {
        let noise = self.tiles(|at| if self.theirs[at].is_finite() { self.noise[at] } else { 0.0 });
        noise.into_iter().zip(self.weights()).map(|(noise, weight)| noise * weight).collect()
    }
}

/// What is no number has no weight.
pub(super) fn finite(value: f64) -> f64 {
    if value.is_finite() { value } else { 0.0 }
}
