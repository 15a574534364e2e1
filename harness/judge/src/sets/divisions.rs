//! How far out the division into before and after is, among the divisions that chance could have made.

use groundtruth::math::{Pcg32, power_of_two};
use rayon::prelude::*;

use super::{AreaSums, Watch};

/// The ways in which chance could have divided pictures, as weights of the pictures; the first is the one that was.
pub struct Divisions {
    /// For each way, the weight of each picture.
    pub weights: Vec<Vec<f64>>,
    /// Whether there is no other way.
    pub is_all: bool,
}

impl Divisions {
    /// The number of ways to divide pictures into sets of these sizes; sets of one size may change places, which changes
    /// no more than a sign.
    pub fn of_sets([n, m]: [usize; 2]) -> f64 {
        let ways = (1..=n).map(|i| (m + i) as f64 / i as f64).product::<f64>().round();
        if n == m { 0.5 * ways } else { ways }
    }

    /// The number of ways to choose the signs of so many differences, but for the sign of all.
    pub fn of_signs(count: usize) -> f64 {
        power_of_two(count as i32 - 1)
    }

    /// Divides pictures, those before first, into sets of these sizes, in all ways or in `most` random ones.
    pub fn sets([n, m]: [usize; 2], most: usize) -> Self {
        let is_all = Self::of_sets([n, m]) <= most as f64;
        let ways = if is_all {
            // of two sets of one size, the first picture stays in the first
            all(n, m).into_iter().filter(|way| n != m || !way[0]).collect()
        } else {
            let was = (0..n + m).map(|picture| picture >= n).collect();
            random(was, most, |way, random| random.shuffle(way))
        };
        let weight = |is_after: &bool| if *is_after { 1.0 / m as f64 } else { -1.0 / n as f64 };
        let weights = ways.into_iter().map(|after| after.iter().map(weight).collect()).collect();
        Self { weights, is_all }
    }

    /// Gives differences signs, in all ways or in `most` random ones.
    pub fn signs(count: usize, most: usize) -> Self {
        let is_all = Self::of_signs(count) <= most as f64;
        let ways = if is_all {
            let is_turned = |way: usize, at: usize| way >> at & 1 == 1;
            let way = |way: usize| (0..count).map(|at| is_turned(way, at)).collect();
            (0..1 << (count - 1)).map(way).collect()
        } else {
            random(vec![false; count], most, |way, random| {
                way.iter_mut().for_each(|is_turned| *is_turned = random.below(2) == 1);
            })
        };
        let weight = |is_turned: &bool| if *is_turned { -1.0 } else { 1.0 } / count as f64;
        let weights = ways.into_iter().map(|way: Vec<bool>| way.iter().map(weight).collect());
        Self { weights: weights.collect(), is_all }
    }
}

/// All ways in which `n` pictures are before and `m` after: first the one in which the first `n` are.
fn all(n: usize, m: usize) -> Vec<Vec<bool>> {
    if n == 0 || m == 0 {
        return vec![vec![n == 0; n + m]];
    }
    let with = |first: bool, rest: Vec<Vec<bool>>| {
        rest.into_iter().map(move |way| [vec![first], way].concat())
    };
    let [before, after] = [all(n - 1, m), all(n, m - 1)];
    with(false, before).chain(with(true, after)).collect()
}

/// The way that was, and others by chance.
fn random(
    was: Vec<bool>,
    most: usize,
    draw: impl Fn(&mut Vec<bool>, &mut Pcg32),
) -> Vec<Vec<bool>> {
    let mut random = Pcg32::new(was.len() as u64, 0);
    let others = (1..most).map(|_| {
        let mut way = was.clone();
        draw(&mut way, &mut random);
        way
    });
    std::iter::once(was.clone()).chain(others).collect()
}

/// How far out the division that was is.
pub struct Rank {
    /// The probability that chance divides the pictures so that they are at least as far apart.
    pub probability: f64,
    /// For each level, the t from which on a difference would have been called one.
    pub needed: Vec<f64>,
}

impl Rank {
    /// Among these divisions, at this level. Each is scored by the most improbable of its levels' largest differences; if
    /// chance divided the pictures, each is as likely to have the largest score, however the noise is distributed
    /// (Fisher, *The Design of Experiments*, 1935; Westfall & Young, *Resampling-Based Multiple Testing*, 1993).
    /// Of a comparison that is interrupted it has no meaning.
    pub fn of(sums: &AreaSums<'_>, divisions: &Divisions, watch: Watch<'_>, level: f64) -> Self {
        let design = sums.design;
        let score = |weights: &Vec<f64>| -> f64 {
            if watch.is_interrupted() {
                return f64::MIN;
            }
            (watch.tried)();
            let largest = sums.largest(weights).into_iter().zip(&sums.levels);
            largest.map(|(t, (_, range))| design.score(t, range.len())).fold(f64::MIN, f64::max)
        };
        let scores: Vec<f64> = divisions.weights.par_iter().map(score).collect();
        let (own, mut others) = (scores[0], scores[1..].to_vec());
        let as_far = others.iter().filter(|score| **score >= own).count();
        others.sort_by(|a, b| b.total_cmp(a));
        // so many others may be as far out
        let allowed = (level * scores.len() as f64) as usize;
        let score = others.get(allowed.saturating_sub(1)).copied().unwrap_or(f64::MAX);
        let needed =
            sums.levels.iter().map(|(_, range)| design.t_of_score(score, range.len())).collect();
        Self { probability: (1 + as_far) as f64 / scores.len() as f64, needed }
    }
}
