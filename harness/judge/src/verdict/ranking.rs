//! How far out one picture of a pool is: the largest of many differences, ranked among those of the others.
//!
//! Each picture in turn is held against the mean and the variance of all others, over tiles of every side and over
//! objects. If pictures are exchangeable, each is as likely to be the farthest out, however its noise is distributed and
//! however the tests depend on each other (Westfall & Young, *Resampling-Based Multiple Testing*, 1993: the largest
//! statistic; Barnard, in the discussion of Bartlett, "The Spectral Analysis of Point Processes", 1963: the rank).

use rayon::prelude::*;

use super::residuals::detail;
use super::{Area, Areas, Map, Pool};
use statistics::quantile;

/// How far out the pictures of a pool are.
#[derive(Clone, Debug)]
pub struct Ranking {
    /// For each picture, the noise of its pixels relative to that of the pool.
    pub noise: Vec<f64>,
    /// For each picture and level of [`DifferenceKind`], the largest difference, in standard deviations.
    pub largest: Vec<Vec<f64>>,
    /// For each picture, how far it is out.
    pub scores: Vec<f64>,
    levels: Vec<DifferenceKind>,
}

/// What differences are of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DifferenceKind {
    /// Tiles of the side 2^level.
    Tiles(usize),
    /// Objects.
    Objects,
    /// The fine structure of objects: noise of any kind has none of ours, a texture of other colours has its negative.
    Structure,
    /// The number of values in which a picture differs from what all others agree on.
    Outliers,
    /// As `Outliers`, but only pixels count whose neighbours differ so too: noise that is unlike that of the others
    /// reaches a little farther than theirs.
    InnerOutliers,
}

/// An area in which a picture differs from the others.
#[derive(Clone, Copy, Debug)]
pub struct DifferingArea {
    /// The area.
    pub area: Area,
    /// Red, green or blue.
    pub channel: usize,
    /// In standard deviations.
    pub z: f64,
}

/// For each picture of a pool, the noise of its pixels relative to that of the pool.
pub(super) fn noise(pool: &Pool) -> Vec<f64> {
    let details: Vec<Option<f64>> =
        (0..pool.count()).into_par_iter().map(|picture| detail(pool, picture)).collect();
    let known: Vec<f64> = details.iter().flatten().copied().collect();
    let usual = quantile(&known, 0.5).unwrap_or_default();
    let factor = |detail: &Option<f64>| match detail {
        Some(detail) if usual > 0.0 => variance(detail / usual, pool).max(0.01).sqrt(),
        _ => 1.0,
    };
    details.iter().map(factor).collect()
}

impl Ranking {
    /// Ranks the pictures of a pool; `from` is the first level of tiles that counts.
    pub fn of(pool: &Pool, areas: &Areas, from: usize) -> Self {
        Self::with_noise(pool, areas, from, noise(pool))
    }

    /// The same; `noise` is that of the pool.
    pub(super) fn with_noise(pool: &Pool, areas: &Areas, from: usize, noise: Vec<f64>) -> Self {
        let mut levels: Vec<_> = (from..areas.levels()).map(DifferenceKind::Tiles).collect();
        let outliers =
            if from == 0 { DifferenceKind::Outliers } else { DifferenceKind::InnerOutliers };
        levels.extend([DifferenceKind::Objects, DifferenceKind::Structure, outliers]);
        let everyone: Vec<usize> = (0..pool.count()).collect();
        let of = |picture: &usize| {
            Map::of(pool, areas, *picture, noise[*picture]).largest(areas, &levels)
        };
        let largest: Vec<Vec<f64>> = everyone.par_iter().map(of).collect();
        let scores = scores(&largest, &levels, &everyone);
        Self { noise, largest, scores, levels }
    }

    /// The number of other pictures that are at least as far out as this one.
    pub fn as_far_as(&self, picture: usize) -> usize {
        let own = self.scores[picture];
        let others = self.scores.iter().enumerate().filter(|(index, _)| *index != picture);
        others.filter(|(_, score)| **score >= own).count()
    }

    /// The probability that a picture is as far out by chance.
    pub fn probability(&self, picture: usize) -> f64 {
        (1 + self.as_far_as(picture)) as f64 / self.scores.len() as f64
    }

    /// How many times as far out a picture is as the farthest of the others, as these see it.
    pub fn times_as_far(&self, picture: usize) -> f64 {
        let others: Vec<usize> = (0..self.scores.len()).filter(|it| *it != picture).collect();
        let scores = scores(&self.largest, &self.levels, &others);
        let farthest = others.iter().map(|other| scores[*other]).fold(0.0, f64::max);
        scores[picture] / farthest
    }

    /// The areas in which a picture is farther out than any other is on the same level, the farthest first.
    pub fn differences(&self, pool: &Pool, areas: &Areas, picture: usize) -> Vec<DifferingArea> {
        let map = Map::of(pool, areas, picture, self.noise[picture]);
        let mut found: Vec<(f64, DifferingArea)> = Vec::new();
        for (at, sums) in map.sums(areas, &self.levels).iter().enumerate() {
            let limit = self.largest_of_others(picture, at);
            let farther = sums.differences(areas).filter(|it| it.z.abs() > limit);
            found.extend(farther.map(|it| (it.z.abs() / limit, it)));
        }
        found.sort_by(|a, b| b.0.total_cmp(&a.0));
        found.into_iter().map(|(_, difference)| difference).collect()
    }

    /// For each level of tiles, its side and the largest difference of any picture but this one.
    pub fn limits(&self, picture: usize) -> impl Iterator<Item = (usize, f64)> + '_ {
        self.levels.iter().enumerate().filter_map(move |(at, level)| match level {
            DifferenceKind::Tiles(level) => Some((1 << level, self.largest_of_others(picture, at))),
            _ => None,
        })
    }

    fn largest_of_others(&self, picture: usize, level: usize) -> f64 {
        let others = self.largest.iter().enumerate().filter(|(index, _)| *index != picture);
        others.map(|(_, largest)| largest[level]).fold(0.0, f64::max)
    }
}

/// The variance x of a picture's noise, if the noise of each of the R other pictures has the variance 1. `ratio` is the
/// picture's [`detail`] divided by the usual one of the others.
///
/// The difference from the mean of the others has the variance `x + 1/R`. Each other picture is compared with R pictures of
/// mean variance `s = (R − 1 + x)/R`, this one among them: its difference has `1 + s/R`, and its detail is that over s. So
/// `ratio = (x + 1/R) s/(1 + s/R)`. With a reference of M pictures, 1/M replaces 1/R and s/R. Both are quadratic in x.
fn variance(ratio: f64, pool: &Pool) -> f64 {
    let others = pool.count() as f64 - 1.0;
    let mean = pool.variance_of_mean();
    // a x² + b x + c = 0
    let [a, b, c] = match &pool.reference {
        None => {
            let squared = others * others;
            let c = others - 1.0 - ratio * (squared + others - 1.0);
            [others, squared - others + 1.0 - ratio, c]
        }
        Some(_) => {
            let whole = ratio * others * (1.0 + mean);
            [1.0, others - 1.0 + mean, mean * (others - 1.0) - whole]
        }
    };
    let root = (b * b - 4.0 * a * c).max(0.0).sqrt();
    (root - b) / (2.0 * a)
}

/// How far out each picture is: the largest over all levels of its difference from the median, in standard deviations
/// of these pictures.
fn scores(largest: &[Vec<f64>], levels: &[DifferenceKind], of: &[usize]) -> Vec<f64> {
    let mut scores = vec![f64::NEG_INFINITY; largest.len()];
    for (at, level) in levels.iter().enumerate() {
        let values: Vec<f64> = of.iter().map(|picture| largest[*picture][at]).collect();
        let median = quantile(&values, 0.5).expect("there are pictures");
        let mean = values.iter().sum::<f64>() / values.len() as f64;
        let squares: f64 = values.iter().map(|value| (value - mean) * (value - mean)).sum();
        let deviation = (squares / (values.len() as f64 - 1.0)).sqrt();
        // twice the root of a rare event's count has the standard deviation 1
        let is_rare = matches!(level, DifferenceKind::Outliers | DifferenceKind::InnerOutliers);
        let deviation = if is_rare { deviation.max(1.0) } else { deviation };
        for (score, largest) in scores.iter_mut().zip(largest) {
            let apart = largest[at] - median;
            *score = score.max(if apart != 0.0 { apart / deviation } else { 0.0 });
        }
    }
    scores
}
