//! What is tested: the pictures, or differences of pairs of them, added up, and the test that can be had with so many.

use groundtruth::math::ln;
use serde::Serialize;

use statistics::means::two_samples;
use statistics::quantile;

use super::sums::channels;
use super::{AreaSums, Design, Divisions, Method, Noise, Pairs, Rank, Sets, SumKind, Watch};
use crate::verdict::Areas;
use crate::verdict::residuals::{around, mean_of, own_variance};

/// So many divisions over the level are tried: the probability of the last one that counts is known to a quarter.
const DIVISIONS: f64 = 4.0;

/// Of one picture, tiles of this side and larger are tested.
const SMALLEST_OF_ONE: usize = 8;

/// Of one picture, the correlation of neighbours is measured on at least so many tiles.
const FEW_TILES: usize = 16;

/// The median of the square of a normal value of variance 1.
const MEDIAN_SQUARE: f64 = 0.4549;

/// The sums of two sets, and how they are tested.
pub struct SetEvidence<'a> {
    /// The sums of what is divided: the pictures, those before first; or differences, after less before.
    pub sums: AreaSums<'a>,
    /// How it is tested.
    pub method: Method,
    /// The weights of the pictures that make the difference that is tested.
    pub weights: Vec<f64>,
    /// How many times a change of all pictures before is in each.
    pub of_change: Vec<f64>,
    sizes: [usize; 2],
    divisions: Option<Divisions>,
    /// How many times as large the variance of sums is as of independent pixels: of one picture a side.
    correlation: f64,
    level: f64,
    watch: Watch<'a>,
}

/// What a test found.
#[derive(Clone, Debug, Default)]
pub struct Found {
    /// The probability of a difference as large, if there is none.
    pub probability: f64,
    /// The sums that differ, each with what [`AreaSums::beyond`] says of it.
    pub sums: Vec<(usize, f64)>,
}

/// Why single areas cannot be tested by divisions.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Reason {
    /// There are too few: the best probability is this.
    Few(f64),
    /// Their noise is not the same, so that it makes a difference which is which.
    Noise,
}

impl<'a> SetEvidence<'a> {
    /// The best that there is of these sets.
    pub fn of(
        sets: &'a Sets,
        (pairs, noise): (&Pairs, &Noise),
        limits @ (level, _): (f64, Watch<'a>),
    ) -> Self {
        let sizes @ [n, m] = sets.sizes();
        if pairs.0.len() >= 2 {
            return Self::of_pairs(sets, pairs, limits);
        }
        if n < 2 || m < 2 {
            return Self::of_one(sets, limits);
        }
        let least = 1.0 / Divisions::of_sets(sizes);
        let divisions =
            (noise.is_alike && least <= level).then(|| Divisions::sets(sizes, most(level)));
        let method = match &divisions {
            Some(divisions) => {
                Method::Divisions { count: divisions.weights.len(), is_all: divisions.is_all }
            }
            None if noise.is_alike => Method::Areas { because: Reason::Few(least) },
            None => Method::Areas { because: Reason::Noise },
        };
        let mean = sets.mean_of_all();
        let values = || sets.all().map(|picture| less(picture, &mean));
        let variance = smoothed(values(), (n + m) as f64 - 1.0, sets);
        Self::new(sets, (values(), variance), sizes, (method, divisions), limits)
    }

    /// Of sums of these values: of so many pictures before and after, or of differences, 0 after.
    fn new(
        sets: &'a Sets,
        (values, mut variance): (impl Iterator<Item = Vec<f64>>, Vec<f64>),
        sizes @ [n, m]: [usize; 2],
        (method, divisions): (Method, Option<Divisions>),
        (level, watch): (f64, Watch<'a>),
    ) -> Self {
        // values that hardly vary show nothing of the variance of rounding
        variance.iter_mut().zip(&sets.rounding).for_each(|(sum, rounding)| *sum += rounding);
        let (one, other, all) = (n as f64, m as f64, (n + m) as f64);
        let both = |before: f64, after: f64| [vec![before; n], vec![after; m]].concat();
        let (design, weights, of_change) = match m {
            0 => (Design::differences(n), vec![1.0 / one; n], vec![-1.0; n]),
            _ => {
                let of_change = both(other / all, -one / all);
                (Design::means(sizes), both(-1.0 / one, 1.0 / other), of_change)
            }
        };
        let sums = AreaSums::of(values, [&sets.mean_of_all(), &variance], &sets.areas, design);
        Self { sums, method, weights, of_change, sizes, divisions, correlation: 1.0, level, watch }
    }

    /// Of pairs with equal seeds, whose differences have little noise.
    fn of_pairs(sets: &'a Sets, pairs: &Pairs, limits @ (level, _): (f64, Watch<'a>)) -> Self {
        let count = pairs.0.len();
        let least = 1.0 / Divisions::of_signs(count);
        let divisions = (least <= level).then(|| Divisions::signs(count, most(level)));
        let difference = |[a, b]: &[usize; 2]| {
            let both = sets.before[*a].iter().zip(&sets.after[*b]);
            both.map(|(before, after)| f64::from(*after) - f64::from(*before)).collect()
        };
        let values = || pairs.0.iter().map(difference);
        let variance = smoothed(values(), count as f64, sets);
        let method = match &divisions {
            Some(divisions) => Method::Signs {
                pairs: count,
                count: divisions.weights.len(),
                is_all: divisions.is_all,
            },
            None => Method::PairedAreas { pairs: count, because: Reason::Few(least) },
        };
        Self::new(sets, (values(), variance), [count, 0], (method, divisions), limits)
    }

    /// Of one picture before or after: its noise is estimated from its finest details.
    fn of_one(sets: &'a Sets, limits: (f64, Watch<'a>)) -> Self {
        let [before, after] = [&sets.before, &sets.after].map(|set| mean_of(set));
        let difference: Vec<f64> = after.iter().zip(&before).map(|(b, a)| b - a).collect();
        let own = match sets.areas.size.contains(&1) {
            false => channels(&difference).map(|channel| own_variance(&channel, sets.areas.size)),
            // of one row or column there are no details
            true => [0; 3].map(|_| vec![f64::INFINITY; sets.areas.object_of.len()]),
        };
        let values = (std::iter::once(difference), interleaved(&own));
        let one = Self::new(sets, values, [1, 0], (Method::OnePicture, None), limits);
        Self { correlation: correlation(&one.sums), ..one }
    }

    /// Whether sets with these sums differ, and where.
    pub fn found(&self, sums: &AreaSums<'_>) -> Found {
        match &self.divisions {
            Some(divisions) => self.by_divisions(sums, divisions),
            None => self.by_areas(sums),
        }
    }

    /// For each pixel, the difference of the channel in which it is largest, in standard deviations.
    pub fn z_of_pixels(&self, areas: &Areas) -> Vec<f64> {
        let differences = self.sums.differences(&self.weights);
        let mut z: Vec<f64> = vec![0.0; areas.object_of.len()];
        let Some((SumKind::Tiles(level), range)) = self.sums.levels.first() else { return z };
        let tiles = range.len() / 3;
        for index in range.clone() {
            let t = self.sums.t(index, differences[index]);
            for pixel in areas.pixels(areas.tile(*level, (index - range.start) % tiles)) {
                if t.abs() > z[pixel].abs() {
                    z[pixel] = t;
                }
            }
        }
        z
    }

    /// The standard deviation of the sum of all channels of an area, of one difference, if channels have their noise in
    /// common: the area's place among those of the level.
    pub fn deviation_of_one(&self, level: SumKind, number: usize) -> f64 {
        let of_channel = |index: usize| (self.correlation * self.sums.expected[index]).sqrt();
        self.sums.places(level, number).map(of_channel).iter().sum()
    }

    fn by_divisions(&self, sums: &AreaSums<'_>, divisions: &Divisions) -> Found {
        let rank = Rank::of(sums, divisions, self.watch, self.level);
        let mut found = Vec::new();
        if rank.probability <= self.level {
            let differences = sums.differences(&self.weights);
            for ((_, range), needed) in sums.levels.iter().zip(&rank.needed) {
                for index in range.clone() {
                    let t = sums.t(index, differences[index]).abs();
                    if t >= *needed {
                        found.push((index, sums.beyond(index, differences[index], needed / t)));
                    }
                }
            }
        }
        Found { probability: rank.probability, sums: found }
    }

    /// The test of each area by its t, those of a size together at an equal part of the level (Bonferroni); if the noise has
    /// changed, by Welch's test too, which does not take it for the same.
    fn by_areas(&self, sums: &AreaSums<'_>) -> Found {
        let differences = sums.differences(&self.weights);
        let levels: Vec<_> = sums.levels.iter().filter(|(kind, _)| self.is_tested(*kind)).collect();
        let mut found = Found { probability: 1.0, sums: Vec::new() };
        for (_, range) in &levels {
            let count = levels.len() * range.len();
            let [possible, needed] =
                [1.0, self.level].map(|level| sums.design.t_of_score(-ln(level), count));
            for index in range.clone() {
                let t = sums.t(index, differences[index]).abs() / self.correlation.sqrt();
                if t < possible {
                    continue;
                }
                let values = sums.in_pictures(index);
                let (before, after) = values.split_at(self.sizes[0]);
                let welch = if self.is_changed() { two_samples(before, after) } else { 0.0 };
                let probability = count as f64 * sums.design.probability(t).max(welch);
                found.probability = found.probability.min(probability);
                if probability <= self.level {
                    found.sums.push((index, sums.beyond(index, differences[index], needed / t)));
                }
            }
        }
        found
    }

    /// Whether sums of this kind are tested by their t: of one difference, those of many pixels, which are about normal.
    fn is_tested(&self, kind: SumKind) -> bool {
        let is_one = self.method == Method::OnePicture;
        match kind {
            SumKind::Tiles(level) => !is_one || 1 << level >= SMALLEST_OF_ONE,
            SumKind::Regions => true,
            // they are of the mean of all pictures, in which the side with more noise has more of its own
            SumKind::Patterns => !is_one && !self.is_changed(),
        }
    }

    /// Whether the noise is not the same on both sides.
    fn is_changed(&self) -> bool {
        self.method == Method::Areas { because: Reason::Noise }
    }
}

/// So many divisions are tried at most.
fn most(level: f64) -> usize {
    (DIVISIONS / level).ceil() as usize
}

/// How many times as large as of independent pixels the variance of sums is: of neighbouring tiles, whose differences a
/// change of the whole picture hardly alters.
fn correlation(sums: &AreaSums<'_>) -> f64 {
    // in standard deviations of its finest details
    let z = |(index, difference)| sums.t(index, difference);
    let z: Vec<f64> = sums.differences(&[1.0]).into_iter().enumerate().map(z).collect();
    let mut factor = 1.0_f64;
    for (level, range) in &sums.levels {
        if matches!(level, SumKind::Tiles(_)) && range.len() >= 3 * FEW_TILES {
            let apart =
                z[range.clone()].windows(2).map(|it| 0.5 * (it[0] - it[1]) * (it[0] - it[1]));
            let median = quantile(&apart.collect::<Vec<f64>>(), 0.5).unwrap_or_default();
            factor = factor.max(median / MEDIAN_SQUARE);
        }
    }
    factor
}

/// The mean of the squares of values over the neighbours of each, and over the pictures.
fn smoothed(pictures: impl Iterator<Item = Vec<f64>>, freedom: f64, sets: &Sets) -> Vec<f64> {
    let mut variance = vec![0.0; sets.rounding.len()];
    for picture in pictures {
        variance.iter_mut().zip(&picture).for_each(|(sum, x)| *sum += x * x / freedom);
    }
    interleaved(&channels(&variance).map(|channel| around(&channel, sets.areas.size)))
}

/// Three values a pixel, of three channels.
fn interleaved(channels: &[Vec<f64>; 3]) -> Vec<f64> {
    let pixels = 0..channels[0].len();
    pixels.flat_map(|pixel| channels.each_ref().map(|channel| channel[pixel])).collect()
}

fn less(picture: &[f32], mean: &[f64]) -> Vec<f64> {
    picture.iter().zip(mean).map(|(x, mean)| f64::from(*x) - mean).collect()
}
