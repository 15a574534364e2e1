//! A picture beside the mean of ours, from which causes are inferred.

use super::areas::Areas;
use super::residuals::{Residuals, around};
use super::{Evaluation, Stored};

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
    /// Whether ours have noise.
    pub has_noise: bool,
}

/// Differences below this part of our value are no evidence.
const LEAST: f64 = 1e-3;

/// Where ours hardly differ, their variance weighs as at least this part of that around it.
const SMALLEST_VARIANCE: f64 = 0.01;

/// Causes are inferred from tiles of this level at most.
const LEVEL: usize = 2;

impl<'a> Evidence<'a> {
    /// That of a judgement; `theirs` is the judged picture with no pixel set apart. A wrong picture's finest details are
    /// no noise, so the variance is that of ours.
    pub fn of(judged: &Evaluation, areas: &'a Areas, theirs: &[f32]) -> Self {
        let (pool, last) = (&judged.pool, judged.pool.count() - 1);
        let theirs: Vec<f64> = theirs.iter().map(|value| f64::from(*value)).collect();
        let mean: Vec<f64> = (0..theirs.len()).map(|at| pool.mean_of_others(last, at)).collect();
        let level = mean.iter().sum::<f64>() / mean.len() as f64;
        let own = judged.ranking.noise[last].min(1.0);
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
                variances[at] = noise[at].max(smallest).max(least * least);
            }
        }
        let (stored, has_noise) = (pool.stored, !judged.is_fixed);
        Self { areas, stored, theirs, mean, variances, noise, has_noise }
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

    /// For each tile and channel, the weighted square of a difference that is noise, on average.
    pub fn squares_of_noise(&self) -> Vec<f64> {
        let noise = self.tiles(|at| if self.theirs[at].is_finite() { self.noise[at] } else { 0.0 });
        noise.into_iter().zip(self.weights()).map(|(noise, weight)| noise * weight).collect()
    }
}
