//! What is tested: the pictures, or differences of pairs of them, added up, and the test that can be had with so many.

use serde::Serialize;
use statrs::distribution::{ContinuousCDF, Normal};

use statistics::means::two_samples;
use statistics::quantile;

use super::divisions::{Divisions, Rank};
use super::noise::{Noise, Pairs};
use super::sums::{AreaSums, Design, SumKind, SummedPictures, channels};
use super::{Method, Sets, Watch};
use crate::verdict::Areas;
use crate::verdict::residuals::{around, own_variance};

/// Sets whose noise is of this part of each other's, to its inverse, may be divided as if it were the same.
const ALIKE: f64 = 0.9;

/// So many divisions over the level are tried: the probability of the last one that counts is known to a quarter.
const DIVISIONS: f64 = 4.0;

/// Where pictures cannot be divided often enough, only tiles of at least this part of the picture's side are tested: each
/// further halving makes every test stricter.
const SMALLEST_PART: usize = 8;

/// Of one picture, tiles of this side and larger are tested: their sums are of enough pixels to be about normal.
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
    design: Design,
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
    /// The sums that differ, the farthest first.
    pub sums: Vec<usize>,
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
    ///
    /// `not_finite` has the number of values of each picture that are no numbers.
    pub fn of(
        sets: &'a Sets,
        not_finite: Vec<f64>,
        (pairs, noise): (&Pairs, &Noise),
        level: f64,
        watch: Watch<'a>,
    ) -> Self {
        let most = (DIVISIONS / level).ceil() as usize;
        let sizes @ [n, m] = sets.sizes();
        if pairs.0.len() >= 2 {
            return Self::of_pairs(sets, &not_finite, pairs, (level, most), watch);
        }
        if n < 2 || m < 2 {
            return Self::of_one(sets, level, watch);
        }
        let (least, design) = (1.0 / Divisions::of_sets(sizes), Design::means(sizes));
        let is_alike = (ALIKE..=1.0 / ALIKE).contains(&noise.factor) || noise.probability > level;
        let divisions = (is_alike && least <= level).then(|| Divisions::sets(sizes, most));
        let method = match &divisions {
            Some(divisions) => {
                Method::Divisions { count: divisions.weights.len(), is_all: divisions.is_all }
            }
            None if is_alike => Method::Areas { because: Reason::Few(least) },
            None => Method::Areas { because: Reason::Noise },
        };
        let mean = sets.mean_of_all();
        let values: Vec<Vec<f64>> = sets.all().map(|picture| less(picture, &mean)).collect();
        let variance = with_rounding(smoothed(&values, (n + m) as f64 - 1.0, sets), sets);
        let values = values.into_iter().zip(centred(not_finite)).collect();
        let pictures = SummedPictures { values, mean: &mean, variance: &variance };
        let all = (n + m) as f64;
        let both = |before: f64, after: f64| [vec![before; n], vec![after; m]].concat();
        Self {
            sums: AreaSums::of(&pictures, &sets.areas, design),
            method,
            correlation: 1.0,
            weights: both(-1.0 / n as f64, 1.0 / m as f64),
            of_change: both(m as f64 / all, -(n as f64) / all),
            sizes,
            design,
            divisions,
            level,
            watch,
        }
    }

    /// Of pairs with equal seeds, whose differences have little noise.
    fn of_pairs(
        sets: &'a Sets,
        not_finite: &[f64],
        pairs: &Pairs,
        (level, most): (f64, usize),
        watch: Watch<'a>,
    ) -> Self {
        let (count, mean) = (pairs.0.len(), sets.mean_of_all());
        let least = 1.0 / Divisions::of_signs(count);
        let divisions = (least <= level).then(|| Divisions::signs(count, most));
        let difference = |[a, b]: &[usize; 2]| {
            let both = sets.before[*a].iter().zip(&sets.after[*b]);
            both.map(|(before, after)| f64::from(*after) - f64::from(*before)).collect()
        };
        let values: Vec<Vec<f64>> = pairs.0.iter().map(difference).collect();
        let variance = with_rounding(smoothed(&values, count as f64, sets), sets);
        let more = pairs.0.iter().map(|[a, b]| not_finite[sets.before.len() + b] - not_finite[*a]);
        let values = values.into_iter().zip(more).collect();
        let design = Design::differences(count);
        let pictures = SummedPictures { values, mean: &mean, variance: &variance };
        let method = match &divisions {
            Some(divisions) => Method::Signs {
                pairs: count,
                count: divisions.weights.len(),
                is_all: divisions.is_all,
            },
            None => Method::PairedAreas { pairs: count, because: Reason::Few(least) },
        };
        Self {
            sums: AreaSums::of(&pictures, &sets.areas, design),
            method,
            correlation: 1.0,
            weights: vec![1.0 / count as f64; count],
            of_change: vec![-1.0; count],
            sizes: [count, 0],
            design,
            divisions,
            level,
            watch,
        }
    }

    /// Of one picture before or after: its noise is estimated from its finest details.
    fn of_one(sets: &'a Sets, level: f64, watch: Watch<'a>) -> Self {
        let mean = sets.mean_of_all();
        let [before, after] = [&sets.before, &sets.after].map(|set| sets.mean(set));
        let difference: Vec<f64> = after.iter().zip(&before).map(|(b, a)| b - a).collect();
        let own = channels(&difference).map(|channel| own_variance(&channel, sets.areas.size));
        let variance = with_rounding(interleaved(&own), sets);
        let values = vec![(difference, 0.0)];
        let pictures = SummedPictures { values, mean: &mean, variance: &variance };
        let design = Design::differences(1);
        let sums = AreaSums::of(&pictures, &sets.areas, design);
        Self {
            correlation: correlation(&sums),
            sums,
            method: Method::OnePicture,
            weights: vec![1.0],
            of_change: vec![-1.0],
            sizes: [1, 0],
            design,
            divisions: None,
            level,
            watch,
        }
    }

    /// What is found if all pictures before are changed so.
    pub fn with_change(&self, change: &[f64]) -> Found {
        self.found_in(&self.sums.with_added(change, &self.of_change))
    }

    /// Whether the sets differ, and where.
    pub fn found(&self) -> Found {
        self.found_in(&self.sums)
    }

    fn found_in(&self, sums: &AreaSums<'_>) -> Found {
        match (&self.divisions, &self.method) {
            (Some(divisions), _) => self.by_divisions(sums, divisions),
            (None, Method::OnePicture) => self.by_details(sums),
            _ => self.by_holm(sums),
        }
    }

    /// What is found where there is no noise: more than rounding.
    pub fn by_rounding(&self) -> Found {
        let differences = self.sums.differences(&self.weights);
        let differs =
            |index: &usize| f64::from(differences[*index]).abs() > self.sums.rounding(*index);
        let mut sums: Vec<usize> = (0..differences.len()).filter(differs).collect();
        let farthest = |index: &usize| -f64::from(differences[*index].abs());
        sums.sort_by(|a, b| farthest(a).total_cmp(&farthest(b)));
        Found { probability: f64::from(u8::from(sums.is_empty())), sums }
    }

    /// For each pixel, the difference of the channel in which it is largest, in standard deviations.
    pub fn z_of_pixels(&self, areas: &Areas) -> Vec<f64> {
        let differences = self.sums.differences(&self.weights);
        let mut z: Vec<f64> = vec![0.0; areas.object_of.len()];
        let Some((SumKind::Tiles(level), range)) = self.sums.levels.first() else { return z };
        let tiles = range.len() / 3;
        for index in range.clone() {
            let t = self.sums.t(index, f64::from(differences[index]), self.design);
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
        let rank = Rank::of(sums, self.design, (divisions, self.watch), self.level);
        let mut found: Vec<(f64, usize)> = Vec::new();
        if rank.probability <= self.level {
            let differences = sums.differences(&self.weights);
            for ((_, range), needed) in sums.levels.iter().zip(&rank.needed) {
                for index in range.clone() {
                    let t = sums.t(index, f64::from(differences[index]), self.design).abs();
                    if t >= *needed {
                        found.push((self.design.score(t, range.len()), index));
                    }
                }
            }
        }
        found.sort_by(|a, b| b.0.total_cmp(&a.0));
        Found { probability: rank.probability, sums: found.into_iter().map(|it| it.1).collect() }
    }

    /// The test of each large area by its t, all together at the level (Holm, "A Simple Sequentially Rejective Multiple Test
    /// Procedure", 1979); if the noise has changed, by Welch's test too, which does not take it for the same.
    fn by_holm(&self, sums: &AreaSums<'_>) -> Found {
        let differences = sums.differences(&self.weights);
        let is_changed = self.method == Method::Areas { because: Reason::Noise };
        let mut tests: Vec<(f64, usize)> = Vec::new();
        for index in large(sums, self.smallest()) {
            let probability = self
                .design
                .probability(sums.t(index, f64::from(differences[index]), self.design).abs());
            let welch = || {
                let values = sums.in_pictures(index);
                two_samples(&values[..self.sizes[0]], &values[self.sizes[0]..])
            };
            tests.push((if is_changed { probability.max(welch()) } else { probability }, index));
        }
        tests.sort_by(|a, b| a.0.total_cmp(&b.0));
        let count = tests.len();
        let adjusted = |at: usize| (tests[at].0 * (count - at) as f64).min(1.0);
        let differ = (0..count).take_while(|at| adjusted(*at) <= self.level);
        Found {
            sums: differ.map(|at| tests[at].1).collect(),
            probability: if count > 0 { adjusted(0) } else { 1.0 },
        }
    }

    /// Each area of one difference against the noise of its finest details, at the level of all together (Bonferroni).
    fn by_details(&self, sums: &AreaSums<'_>) -> Found {
        let z = z_of_one(sums);
        let is_tested = |level| match level {
            SumKind::Tiles(level) => 1 << level >= SMALLEST_OF_ONE,
            SumKind::Regions => true,
            // single bright pixels are in the difference and in the patterns of its mean
            SumKind::Patterns | SumKind::NotFinite => false,
        };
        let levels = sums.levels.iter().filter(|(level, _)| is_tested(*level));
        let deviation = self.correlation.sqrt();
        let mut tests: Vec<(f64, usize)> = levels
            .flat_map(|(_, range)| range.clone().map(|index| (z[index].abs() / deviation, index)))
            .collect();
        tests.sort_by(|a, b| b.0.total_cmp(&a.0));
        let (count, normal) = (tests.len() as f64, Normal::standard());
        let probability = |z: f64| (2.0 * count * normal.sf(z)).min(1.0);
        let differ = tests.iter().take_while(|(z, _)| probability(*z) <= self.level);
        Found {
            sums: differ.map(|(_, index)| *index).collect(),
            probability: tests.first().map_or(1.0, |(z, _)| probability(*z)),
        }
    }

    /// The smallest side of tiles that [`SetEvidence::by_holm`] tests.
    fn smallest(&self) -> usize {
        let levels = self.sums.levels.iter();
        let largest = levels.filter_map(|(level, _)| match level {
            SumKind::Tiles(level) => Some(1 << level),
            _ => None,
        });
        largest.max().unwrap_or(1) / SMALLEST_PART
    }
}

/// One difference in standard deviations of its finest details.
fn z_of_one(sums: &AreaSums<'_>) -> Vec<f64> {
    let differences = sums.differences(&[1.0]).into_iter().enumerate();
    let z = |(index, difference)| sums.t(index, f64::from(difference), Design::differences(1));
    differences.map(z).collect()
}

/// How many times as large as of independent pixels the variance of sums is: of neighbouring tiles, whose differences a
/// change of the whole picture hardly alters.
fn correlation(sums: &AreaSums<'_>) -> f64 {
    let (z, mut factor) = (z_of_one(sums), 1.0_f64);
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

/// The sums of regions, patterns, and tiles of at least this side.
fn large<'a>(sums: &'a AreaSums<'_>, smallest: usize) -> impl Iterator<Item = usize> + 'a {
    let is_large = move |level: SumKind| match level {
        SumKind::Tiles(level) => 1 << level >= smallest,
        SumKind::Regions | SumKind::Patterns | SumKind::NotFinite => true,
    };
    let levels = sums.levels.iter().filter(move |(level, _)| is_large(*level));
    levels.flat_map(|(_, range)| range.clone())
}

/// The mean of the squares of values over the neighbours of each, and over the pictures.
fn smoothed(pictures: &[Vec<f64>], freedom: f64, sets: &Sets) -> Vec<f64> {
    let mut variance = vec![0.0; pictures[0].len()];
    for picture in pictures {
        variance.iter_mut().zip(picture).for_each(|(sum, x)| *sum += x * x / freedom);
    }
    interleaved(&channels(&variance).map(|channel| around(&channel, sets.areas.size)))
}

/// Three values a pixel, of three channels.
fn interleaved(channels: &[Vec<f64>; 3]) -> Vec<f64> {
    let pixels = 0..channels[0].len();
    pixels.flat_map(|pixel| channels.each_ref().map(|channel| channel[pixel])).collect()
}

/// With the variance of rounding, of which values that hardly vary show nothing.
fn with_rounding(mut variance: Vec<f64>, sets: &Sets) -> Vec<f64> {
    variance.iter_mut().zip(&sets.rounding).for_each(|(sum, rounding)| *sum += rounding);
    variance
}

fn less(picture: &[f32], mean: &[f64]) -> Vec<f64> {
    picture.iter().zip(mean).map(|(x, mean)| f64::from(*x) - mean).collect()
}

fn centred(values: Vec<f64>) -> Vec<f64> {
    let mean = values.iter().sum::<f64>() / values.len() as f64;
    values.into_iter().map(|value| value - mean).collect()
}
