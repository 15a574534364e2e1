//! How far out one picture of a pool is: the largest of many differences, ranked among those of the others.
//!
//! Each picture in turn is held against the mean and the variance of all others, over tiles of every side and over
//! objects. If pictures are exchangeable, each is as likely to be the farthest out, however its noise is distributed and
//! however the tests depend on each other (Westfall & Young, *Resampling-Based Multiple Testing*, 1993: the largest
//! statistic; Barnard, in the discussion of Bartlett, "The Spectral Analysis of Point Processes", 1963: the rank).

use rayon::prelude::*;

use super::areas::{Area, Areas};
use super::pool::{Against, Pool};
use crate::verify::quantile;

/// Where the others hardly differ, their variance is at least this part of that around it.
const SMALLEST_VARIANCE: f64 = 0.01;

/// The neighbours of a value whose variance counts: so many to either side.
const REACH: usize = 2;

/// How far out the pictures of a pool are.
#[derive(Clone, Debug)]
pub struct Ranking {
    /// For each picture, the noise of its pixels relative to that of the pool.
    pub noise: Vec<f64>,
    /// For each picture and level of [`Level`], the largest difference, in standard deviations.
    pub largest: Vec<Vec<f64>>,
    /// For each picture, how far it is out.
    pub scores: Vec<f64>,
    levels: Vec<Level>,
}

/// What differences are of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Level {
    /// Tiles of the side 2^level.
    Tiles(usize),
    /// Objects.
    Objects,
    /// The number of values in which a picture differs from what all others agree on.
    Alone,
    /// As `Alone`, but only pixels count whose neighbours differ so too: noise that is unlike that of the others
    /// reaches a little farther than theirs.
    AloneInside,
}

/// An area in which a picture differs from the others.
#[derive(Clone, Copy, Debug)]
pub struct Difference {
    /// The area.
    pub area: Area,
    /// Red, green or blue.
    pub channel: usize,
    /// In standard deviations.
    pub z: f64,
}

impl Ranking {
    /// Ranks the pictures of a pool; `from` is the first level of tiles that counts.
    pub fn of(pool: &Pool, areas: &Areas, from: usize) -> Self {
        let all = 0..pool.count();
        let details: Vec<Option<f64>> =
            all.clone().into_par_iter().map(|picture| detail(pool, picture)).collect();
        let known: Vec<f64> = details.iter().flatten().copied().collect();
        let usual = quantile(&known, 0.5).unwrap_or_default();
        let others = 1.0 / (pool.count() as f64 - 1.0);
        let factor = |detail: &Option<f64>| match detail {
            // the difference from the mean of the others has its noise too
            Some(detail) if usual > 0.0 => {
                (detail / usual * (1.0 + others) - others).max(0.01).sqrt()
            }
            _ => 1.0,
        };
        let noise: Vec<f64> = details.iter().map(factor).collect();
        let mut levels: Vec<Level> = (from..areas.levels()).map(Level::Tiles).collect();
        let alone = if from == 0 { Level::Alone } else { Level::AloneInside };
        levels.extend([Level::Objects, alone]);
        let largest: Vec<Vec<f64>> = all
            .into_par_iter()
            .map(|picture| {
                let map = Map::of(pool, areas, picture, noise[picture]);
                map.largest(areas, &levels)
            })
            .collect();
        let everyone: Vec<usize> = (0..pool.count()).collect();
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
    pub fn differences(&self, pool: &Pool, areas: &Areas, picture: usize) -> Vec<Difference> {
        let map = Map::of(pool, areas, picture, self.noise[picture]);
        let mut found: Vec<(f64, Difference)> = Vec::new();
        for (at, sums) in map.sums(areas, &self.levels).iter().enumerate() {
            let others = self.largest.iter().enumerate().filter(|(index, _)| *index != picture);
            let limit = others.map(|(_, largest)| largest[at]).fold(0.0, f64::max);
            for difference in sums.differences(areas) {
                if difference.z.abs() > limit {
                    found.push((difference.z.abs() / limit, difference));
                }
            }
        }
        found.sort_by(|a, b| b.0.total_cmp(&a.0));
        found.into_iter().map(|(_, difference)| difference).collect()
    }

    /// For each level of tiles, its side and the largest difference of any picture but this one.
    pub fn limits(&self, picture: usize) -> impl Iterator<Item = (usize, f64)> + '_ {
        let others = move |at: usize| {
            let others = self.largest.iter().enumerate().filter(move |(it, _)| *it != picture);
            others.map(move |(_, largest)| largest[at]).fold(0.0, f64::max)
        };
        self.levels.iter().enumerate().filter_map(move |(at, level)| match level {
            Level::Tiles(level) => Some((1 << level, others(at))),
            _ => None,
        })
    }
}

/// How far out each picture is: the largest over all levels of its difference from the median, in standard deviations
/// of these pictures.
fn scores(largest: &[Vec<f64>], levels: &[Level], of: &[usize]) -> Vec<f64> {
    let mut scores = vec![f64::NEG_INFINITY; largest.len()];
    for (at, level) in levels.iter().enumerate() {
        let values: Vec<f64> = of.iter().map(|picture| largest[*picture][at]).collect();
        let median = quantile(&values, 0.5).expect("there are pictures");
        let mean = values.iter().sum::<f64>() / values.len() as f64;
        let squares: f64 = values.iter().map(|value| (value - mean) * (value - mean)).sum();
        let deviation = (squares / (values.len() as f64 - 1.0)).sqrt();
        let deviation = match level {
            // twice the root of a rare event's count has the standard deviation 1
            Level::Alone | Level::AloneInside => deviation.max(1.0),
            _ => deviation,
        };
        for (score, largest) in scores.iter_mut().zip(largest) {
            let apart = largest[at] - median;
            if apart != 0.0 {
                *score = score.max(apart / deviation);
            } else {
                *score = score.max(0.0);
            }
        }
    }
    scores
}

/// The differences of a picture from the others, and their variances, for each channel and pixel.
pub struct Map {
    differences: [Vec<f64>; 3],
    variances: [Vec<f64>; 3],
    /// The number of values in which all others agree against it, in each pixel.
    alone: Vec<f64>,
}

impl Map {
    /// That of one picture, whose noise is this times that of the pool.
    pub fn of(pool: &Pool, areas: &Areas, picture: usize, noise: f64) -> Self {
        let pixels = areas.size[0] * areas.size[1];
        let mut alone = vec![0.0; pixels];
        // its own noise, and that of the mean of the others
        let factor = noise * noise + 1.0 / (pool.count() as f64 - 1.0);
        let (mut differences, mut variances) = (Vec::new(), Vec::new());
        for channel in 0..3 {
            let Residuals { difference, variance, varied } =
                Residuals::of(pool, picture, channel, &mut alone);
            let around = around(&variance, areas.size);
            let own = own_variance(&difference, areas.size);
            let value = |pixel: usize| {
                let mean = pool.mean_of_others(picture, 3 * pixel + channel);
                let rounding = pool.stored.rounding(mean);
                let variance = variance[pixel].max(SMALLEST_VARIANCE * around[pixel]);
                (variance * factor).max(own[pixel]) + rounding * rounding
            };
            let with_floor =
                (0..pixels).map(|pixel| if varied[pixel] { value(pixel) } else { 0.0 });
            variances.push(with_floor.collect());
            differences.push(difference);
        }
        leave_out_bright(pool, picture, &mut differences, &mut variances);
        let three = |all: Vec<Vec<f64>>| <[Vec<f64>; 3]>::try_from(all).expect("three channels");
        Self { differences: three(differences), variances: three(variances), alone }
    }

    /// The largest difference of each level, in standard deviations.
    fn largest(&self, areas: &Areas, levels: &[Level]) -> Vec<f64> {
        let root_of = |counts: &[f64]| 2.0 * counts.iter().sum::<f64>().sqrt();
        let largest = |sums: Sums| match sums.level {
            Level::Alone => root_of(&self.alone),
            Level::AloneInside => root_of(&inside(&self.alone, areas.size)),
            _ => sums.differences(areas).map(|it| it.z.abs()).fold(0.0, f64::max),
        };
        self.sums(areas, levels).into_iter().map(largest).collect()
    }

    /// The sums over the areas of each level.
    fn sums(&self, areas: &Areas, levels: &[Level]) -> Vec<Sums> {
        let both = |of: &dyn Fn(&[f64]) -> Vec<f64>| {
            [0, 1, 2].map(|channel| [of(&self.differences[channel]), of(&self.variances[channel])])
        };
        let mut tiles = both(&<[f64]>::to_vec);
        let mut at = 0;
        let mut of_level = |level: &Level| {
            let channels = match *level {
                Level::Tiles(level) => {
                    while at < level {
                        at += 1;
                        tiles = tiles
                            .each_ref()
                            .map(|both| both.each_ref().map(|it| areas.coarser(it, at)));
                    }
                    tiles.clone()
                }
                Level::Objects => both(&|values| areas.by_object(values)),
                Level::Alone | Level::AloneInside => Default::default(),
            };
            Sums { level: *level, channels }
        };
        levels.iter().map(&mut of_level).collect()
    }

    /// The pixels in which all others agree against this picture.
    pub fn alone(&self) -> impl Iterator<Item = usize> + '_ {
        self.alone.iter().enumerate().filter(|(_, count)| **count > 0.0).map(|(pixel, _)| pixel)
    }

    /// The largest difference of each pixel's channels, in standard deviations, with its sign.
    pub fn pixels(&self) -> Vec<f64> {
        let z = |pixel: usize, channel: usize| {
            let variance = self.variances[channel][pixel];
            if variance > 0.0 { self.differences[channel][pixel] / variance.sqrt() } else { 0.0 }
        };
        let farther = |a: f64, b: f64| if b.abs() > a.abs() { b } else { a };
        let largest = |pixel| (0..3).map(|channel| z(pixel, channel)).fold(0.0, farther);
        (0..self.alone.len()).map(largest).collect()
    }

    /// The variance of the sum over an area, of a channel.
    pub fn variance(&self, pixels: &[usize], channel: usize) -> f64 {
        pixels.iter().map(|pixel| self.variances[channel][*pixel]).sum()
    }
}

/// Noise near the largest value that can be stored is cut on one side: so many standard deviations below it count.
const NEAR_LARGEST: f64 = 3.0;

/// Leaves out the pixels of which a channel is near the largest value.
fn leave_out_bright(
    pool: &Pool,
    picture: usize,
    differences: &mut [Vec<f64>],
    variances: &mut [Vec<f64>],
) {
    let largest = pool.stored.largest();
    for pixel in 0..variances[0].len() {
        let is_near = (0..3).any(|channel| {
            let mean = pool.mean_of_others(picture, 3 * pixel + channel);
            mean + NEAR_LARGEST * variances[channel][pixel].sqrt() > largest
        });
        if is_near {
            differences.iter_mut().for_each(|channel| channel[pixel] = 0.0);
            variances.iter_mut().for_each(|channel| channel[pixel] = 0.0);
        }
    }
}

/// Sums over the areas of a level: for each channel, of the differences and of their variances.
struct Sums {
    level: Level,
    channels: [[Vec<f64>; 2]; 3],
}

impl Sums {
    /// The differences of all areas, in standard deviations.
    fn differences<'a>(&'a self, areas: &'a Areas) -> impl Iterator<Item = Difference> + 'a {
        self.channels.iter().enumerate().flat_map(move |(channel, [differences, variances])| {
            let both = differences.iter().zip(variances).enumerate();
            both.filter(|(_, (_, variance))| **variance > 0.0).map(
                move |(index, (sum, variance))| {
                    let area = match self.level {
                        Level::Tiles(level) => areas.tile(level, index),
                        _ => Area::Object(index),
                    };
                    Difference { area, channel, z: sum / variance.sqrt() }
                },
            )
        })
    }
}

/// The differences of a channel of a picture from the mean of the others, where the others vary.
struct Residuals {
    difference: Vec<f64>,
    /// Of the others.
    variance: Vec<f64>,
    varied: Vec<bool>,
}

impl Residuals {
    fn of(pool: &Pool, picture: usize, channel: usize, alone: &mut [f64]) -> Self {
        let pixels = pool.size[0] * pool.size[1];
        let (mut difference, mut variance, mut varied) =
            (vec![0.0; pixels], vec![0.0; pixels], vec![false; pixels]);
        for pixel in 0..pixels {
            match pool.against(picture, 3 * pixel + channel) {
                Against::Varied { difference: d, variance: v } => {
                    (difference[pixel], variance[pixel], varied[pixel]) = (d, v, true);
                }
                Against::Alone => alone[pixel] += 1.0,
                Against::Same | Against::Nothing => {}
            }
        }
        Self { difference, variance, varied }
    }
}

/// A block's detail counts at most this many times the variance of the others, so that single bright pixels do not
/// decide.
const MOST_DETAIL: f64 = 16.0;

/// Fewer blocks say nothing of the noise.
const FEW_BLOCKS: u32 = 16;

/// The square of the finest details of a picture's difference from the others, relative to the variance of these: the
/// mean over blocks of two by two pixels. `None` if there are few such blocks.
fn detail(pool: &Pool, picture: usize) -> Option<f64> {
    let [width, height] = pool.size;
    let (mut sum, mut count) = (0.0, 0_u32);
    for channel in 0..3 {
        let Residuals { difference, variance, varied } =
            Residuals::of(pool, picture, channel, &mut vec![0.0; width * height]);
        for y in (0..height - height % 2).step_by(2) {
            for x in (0..width - width % 2).step_by(2) {
                let block = [[0, 0], [1, 0], [0, 1], [1, 1]].map(|[i, j]| (y + j) * width + x + i);
                let total: f64 = block.iter().map(|pixel| variance[*pixel]).sum();
                if block.iter().any(|pixel| varied[*pixel]) && total > 0.0 {
                    let [a, b, c, d] = block.map(|pixel| difference[pixel]);
                    sum += (square(a - b - c + d) / total).min(MOST_DETAIL);
                    count += 1;
                }
            }
        }
    }
    (count >= FEW_BLOCKS).then(|| sum / f64::from(count))
}

fn square(x: f64) -> f64 {
    x * x
}

/// The variance of a picture's noise around each pixel, from the finest details of its differences: noise has them,
/// and most errors do not.
fn own_variance(difference: &[f64], size @ [width, height]: [usize; 2]) -> Vec<f64> {
    let detail = |pixel: usize| {
        let (x, y) = (pixel % width, pixel / width);
        let (right, below) = (usize::from(x + 1 < width), usize::from(y + 1 < height) * width);
        let [a, b, c, d] = [0, right, below, below + right].map(|step| difference[pixel + step]);
        0.25 * square(a - b - c + d)
    };
    around(&(0..difference.len()).map(detail).collect::<Vec<f64>>(), size)
}

/// The counts that are not 0 and have no neighbour that is.
fn inside(counts: &[f64], [width, height]: [usize; 2]) -> Vec<f64> {
    let is_inside = |pixel: usize| {
        let near = |at: usize, length: usize| at.saturating_sub(1)..=(at + 1).min(length - 1);
        let (x, y) = (pixel % width, pixel / width);
        near(y, height).all(|row| near(x, width).all(|column| counts[row * width + column] > 0.0))
    };
    let count = |pixel| if is_inside(pixel) { counts[pixel] } else { 0.0 };
    (0..counts.len()).map(count).collect()
}

/// The mean over the neighbours of each value, itself among them.
fn around(values: &[f64], [width, height]: [usize; 2]) -> Vec<f64> {
    let rows = averaged(values, width, height, [1, width]);
    averaged(&rows, height, width, [width, 1])
}

/// The mean over the neighbours along lines of this length, whose values are `step` apart and which begin `next` apart.
fn averaged(values: &[f64], length: usize, lines: usize, [step, next]: [usize; 2]) -> Vec<f64> {
    let mut means = vec![0.0; values.len()];
    for line in 0..lines {
        for at in 0..length {
            let near = at.saturating_sub(REACH)..=(at + REACH).min(length - 1);
            let count = near.clone().count() as f64;
            let sum: f64 = near.map(|other| values[line * next + other * step]).sum();
            means[line * next + at * step] = sum / count;
        }
    }
    means
}
