//! The noise of pictures: how much there is before and after, and which pictures share it.

use serde::Serialize;

use statistics::means::{difference, two_samples};
use statistics::quantile;

use super::Sets;
use crate::verdict::residuals::mean_of;
use groundtruth::math::{exp, ln};

/// Pictures whose finest details are correlated by more than this have equal seeds.
const EQUAL: f64 = 0.5;

/// The noise is measured in about so many squares along the longer side.
pub const SQUARES: usize = 16;

/// The noise after, held against that before.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Noise {
    /// How many times as large it is.
    pub factor: f64,
    /// The ends of an interval of 99 %.
    pub interval: [f64; 2],
    /// The probability of a factor as far from 1, if the noise is the same.
    pub probability: f64,
    /// Whether it is the same as far as can be seen, so that pictures before and after may be exchanged.
    #[serde(skip)]
    pub is_alike: bool,
}

/// Noise of this part of the other's, to its inverse, is taken for the same.
const ALIKE: f64 = 0.9;

impl Noise {
    /// Of sets of two pictures or more; of fewer nothing is known, and the factor is 1. The level is that of a change that is
    /// seen where there is none.
    pub fn of(sets: &Sets, level: f64) -> Self {
        let [n, _] = sets.sizes();
        let held = |values: Vec<f64>| {
            let logarithm = |value: f64| (value > 0.0).then(|| 0.5 * ln(value));
            let all: Option<Vec<f64>> = values.into_iter().map(logarithm).collect();
            let all = all.unwrap_or_default();
            let (before, after) = all.split_at(n.min(all.len()));
            Some((difference(after, before, 0.99)?.map(exp), two_samples(after, before)))
        };
        let is_alike = |factor: f64, probability: f64| {
            (ALIKE..=1.0 / ALIKE).contains(&factor) || probability > level
        };
        let squares = squares(sets);
        let Some(([factor, low, high], probability)) = held(medians(&squares)) else {
            let interval = [0.0, f64::MAX];
            return Self { factor: 1.0, interval, probability: 1.0, is_alike: true };
        };
        // most squares have no firefly, so that their median shows no change of these
        let whole = held(squares.iter().map(|sums| sums.iter().sum()).collect());
        let is_alike = is_alike(factor, probability)
            && whole.is_none_or(|([factor, ..], probability)| is_alike(factor, probability));
        Self { factor, interval: [low, high], probability, is_alike }
    }
}

/// For each picture, the median over squares of how its squared differences are to those of all pictures, so that single
/// bright pixels do not decide; 0 if nothing is known.
fn medians(squares: &[Vec<f64>]) -> Vec<f64> {
    let count = squares.len() as f64;
    let total = |square: usize| squares.iter().map(|sums| sums[square]).sum::<f64>() / count;
    let totals: Vec<f64> = (0..squares.first().map_or(0, Vec::len)).map(total).collect();
    let median = |sums: &Vec<f64>| {
        let ratios = sums.iter().zip(&totals).map(|(sum, total)| sum / total);
        let known: Vec<f64> = ratios.filter(|ratio| ratio.is_finite()).collect();
        quantile(&known, 0.5).unwrap_or_default()
    };
    squares.iter().map(median).collect()
}

/// For each picture, its squared differences from the mean of its set, in squares.
fn squares(sets: &Sets) -> Vec<Vec<f64>> {
    let [width, height] = sets.areas.size;
    let side = width.max(height).div_ceil(SQUARES);
    let across = width.div_ceil(side);
    let mut squares: Vec<Vec<f64>> = Vec::new();
    for set in [&sets.before, &sets.after].into_iter().filter(|set| set.len() > 1) {
        let mean = mean_of(set);
        let left = set.len() as f64 / (set.len() as f64 - 1.0);
        for picture in set {
            let mut sums = vec![0.0; across * height.div_ceil(side)];
            for (index, (value, mean)) in picture.iter().zip(&mean).enumerate() {
                let [x, y] = [index / 3 % width, index / 3 / width];
                let apart = f64::from(*value) - mean;
                sums[y / side * across + x / side] += left * apart * apart;
            }
            squares.push(sums);
        }
    }
    squares
}

/// Pictures with equal seeds: the places of one before and of one after.
#[derive(Clone, Debug, Default)]
pub struct Pairs(pub Vec<[usize; 2]>);

impl Pairs {
    /// The pairs of two sets, those of which the finest details of the noise are correlated; none, if some of the smaller
    /// set's have no partner.
    pub fn of(sets: &Sets) -> Self {
        let [n, m] = sets.sizes();
        if n < 2 || m < 2 {
            return Self::default();
        }
        let details = [&sets.before, &sets.after].map(|set| {
            let mean = mean_of(set);
            set.iter().map(|picture| details(picture, &mean, sets.areas.size)).collect::<Vec<_>>()
        });
        let mut all: Vec<(f64, [usize; 2])> = Vec::new();
        for (i, before) in details[0].iter().enumerate() {
            for (j, after) in details[1].iter().enumerate() {
                let correlation: f64 = before.iter().zip(after).map(|(a, b)| a * b).sum();
                if correlation > EQUAL {
                    all.push((correlation, [i, j]));
                }
            }
        }
        all.sort_by(|a, b| b.0.total_cmp(&a.0));
        let mut pairs: Vec<[usize; 2]> = Vec::new();
        for (_, pair) in all {
            if pairs.iter().all(|taken| taken[0] != pair[0] && taken[1] != pair[1]) {
                pairs.push(pair);
            }
        }
        pairs.sort_unstable();
        if pairs.len() == n.min(m) { Self(pairs) } else { Self::default() }
    }
}

/// The finest details of the sum of a picture's channels without the mean: those of blocks of two by two pixels, of length
/// 1 all together.
fn details(picture: &[f32], mean: &[f64], [width, height]: [usize; 2]) -> Vec<f64> {
    let grey = |x: usize, y: usize| -> f64 {
        let at = 3 * (y * width + x);
        (at..at + 3).map(|index| f64::from(picture[index]) - mean[index]).sum()
    };
    let rows = (0..height - height % 2).step_by(2);
    let blocks = rows.flat_map(|y| (0..width - width % 2).step_by(2).map(move |x| [x, y]));
    let detail =
        |[x, y]: [usize; 2]| grey(x, y) - grey(x + 1, y) - grey(x, y + 1) + grey(x + 1, y + 1);
    let details: Vec<f64> = blocks.map(detail).collect();
    let length = details.iter().map(|detail| detail * detail).sum::<f64>().sqrt();
    if length > 0.0 { details.into_iter().map(|detail| detail / length).collect() } else { details }
}
