//! The differences of one picture from the others, and their sums over areas.

use super::areas::{Area, Areas};
use super::pool::Pool;
use super::ranking::{DifferenceKind, DifferingArea};
use super::residuals::{Residuals, around, neighbours, own_variance};

/// Where the others hardly differ, their variance is at least this part of that around it.
const SMALLEST_VARIANCE: f64 = 0.01;

/// The differences of a picture from the others, and their variances, for each channel and pixel.
pub struct Map {
    differences: [Vec<f64>; 3],
    variances: [Vec<f64>; 3],
    /// The differences times the fine structure of the others, and the variances of these products.
    structure: [[Vec<f64>; 2]; 3],
    /// The number of values in which all others agree against it, in each pixel.
    outliers: Vec<f64>,
}

impl Map {
    /// That of one picture, whose noise is this times that of the pool.
    pub fn of(pool: &Pool, areas: &Areas, picture: usize, noise: f64) -> Self {
        let pixels = areas.size[0] * areas.size[1];
        let mut outliers = vec![0.0; pixels];
        // its own noise, and that of the mean of the others
        let factor = noise * noise + pool.variance_of_mean();
        let (mut differences, mut variances, mut of_others) = (Vec::new(), Vec::new(), Vec::new());
        for channel in 0..3 {
            let Residuals { difference, variance, varied } =
                Residuals::of(pool, picture, channel, &mut outliers);
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
            of_others.push(variance);
        }
        leave_out_bright(pool, picture, &mut differences, &mut variances);
        let three = |all: Vec<Vec<f64>>| <[Vec<f64>; 3]>::try_from(all).expect("three channels");
        let (differences, variances) = (three(differences), three(variances));
        let structure = [0, 1, 2].map(|channel| {
            let mean = (0..pixels).map(|pixel| pool.mean_of_others(picture, 3 * pixel + channel));
            structure(&mean.collect::<Vec<f64>>(), areas.size, |pixel| {
                let variance =
                    if variances[channel][pixel] > 0.0 { of_others[channel][pixel] } else { 0.0 };
                [
                    differences[channel][pixel],
                    pool.variance_of_mean() * variance,
                    variances[channel][pixel],
                ]
            })
        });
        Self { differences, variances, structure, outliers }
    }

    /// The largest difference of each level, in standard deviations.
    pub fn largest(&self, areas: &Areas, levels: &[DifferenceKind]) -> Vec<f64> {
        let root_of = |counts: &[f64]| 2.0 * counts.iter().sum::<f64>().sqrt();
        let largest = |sums: DifferenceSums| match sums.level {
            DifferenceKind::Outliers => root_of(&self.outliers),
            DifferenceKind::InnerOutliers => root_of(&inside(&self.outliers, areas.size)),
            _ => sums.differences(areas).map(|it| it.z.abs()).fold(0.0, f64::max),
        };
        self.sums(areas, levels).into_iter().map(largest).collect()
    }

    /// The sums over the areas of each level.
    pub fn sums(&self, areas: &Areas, levels: &[DifferenceKind]) -> Vec<DifferenceSums> {
        let both = |of: &dyn Fn(&[f64]) -> Vec<f64>| {
            [0, 1, 2].map(|channel| [of(&self.differences[channel]), of(&self.variances[channel])])
        };
        let mut tiles = both(&<[f64]>::to_vec);
        let mut at = 0;
        let mut of_level = |level: &DifferenceKind| {
            let channels = match *level {
                DifferenceKind::Tiles(level) => {
                    while at < level {
                        at += 1;
                        tiles = tiles
                            .each_ref()
                            .map(|both| both.each_ref().map(|it| areas.coarser(it, at)));
                    }
                    tiles.clone()
                }
                DifferenceKind::Objects => both(&|values| areas.by_object(values)),
                DifferenceKind::Structure => self
                    .structure
                    .each_ref()
                    .map(|both| both.each_ref().map(|values| areas.by_object(values))),
                DifferenceKind::Outliers | DifferenceKind::InnerOutliers => Default::default(),
            };
            DifferenceSums { level: *level, channels }
        };
        levels.iter().map(&mut of_level).collect()
    }

    /// The pixels in which all others agree against this picture.
    pub fn outliers(&self) -> impl Iterator<Item = usize> + '_ {
        self.outliers.iter().enumerate().filter(|(_, count)| **count > 0.0).map(|(pixel, _)| pixel)
    }

    /// The largest difference of each pixel's channels, in standard deviations, with its sign.
    pub fn pixels(&self) -> Vec<f64> {
        let z = |pixel: usize, channel: usize| {
            let variance = self.variances[channel][pixel];
            if variance > 0.0 { self.differences[channel][pixel] / variance.sqrt() } else { 0.0 }
        };
        let farther = |a: f64, b: f64| if b.abs() > a.abs() { b } else { a };
        let largest = |pixel| (0..3).map(|channel| z(pixel, channel)).fold(0.0, farther);
        (0..self.outliers.len()).map(largest).collect()
    }

    /// The variance of the sum over an area, of a channel.
    pub fn variance(&self, pixels: &[usize], channel: usize) -> f64 {
        pixels.iter().map(|pixel| self.variances[channel][*pixel]).sum()
    }
}

/// The products of a picture's differences with the fine structure of the others, which is what their mean has more than
/// around each value; and the variances of these products. Of each pixel are given: the difference, the variance of the
/// mean, and that of the difference.
///
/// The mean `m` is subtracted in the difference, and a part `1 − 1/n` of it is in the structure (`n` neighbours), so that
/// the product of noise is `−(1 − 1/n) Var m` in the mean: this is put back.
fn structure(mean: &[f64], size: [usize; 2], of: impl Fn(usize) -> [f64; 3]) -> [Vec<f64>; 2] {
    let around = around(mean, size);
    let products = (0..mean.len()).map(|pixel| {
        let [difference, of_mean, variance] = of(pixel);
        // values that are no numbers are left out
        let fine = Some(mean[pixel] - around[pixel]).filter(|fine| fine.is_finite()).unwrap_or(0.0);
        let put_back = (1.0 - 1.0 / neighbours(pixel, size)) * of_mean;
        (fine * difference + put_back, fine * fine * variance)
    });
    let (products, variances) = products.unzip();
    [products, variances]
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
pub struct DifferenceSums {
    level: DifferenceKind,
    channels: [[Vec<f64>; 2]; 3],
}

impl DifferenceSums {
    /// The differences of all areas, in standard deviations.
    pub fn differences<'a>(&'a self, areas: &'a Areas) -> impl Iterator<Item = DifferingArea> + 'a {
        self.channels.iter().enumerate().flat_map(move |(channel, [differences, variances])| {
            let both = differences.iter().zip(variances).enumerate();
            both.filter(|(_, (_, variance))| **variance > 0.0).map(
                move |(index, (sum, variance))| {
                    let area = match self.level {
                        DifferenceKind::Tiles(level) => areas.tile(level, index),
                        DifferenceKind::Structure => Area::Structure(index),
                        _ => Area::Object(index),
                    };
                    DifferingArea { area, channel, z: sum / variance.sqrt() }
                },
            )
        })
    }
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
