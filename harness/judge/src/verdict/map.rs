//! The differences of one picture from the others, and their sums over areas.

use super::residuals::{Residuals, around, near, neighbours, own_variance};
use super::{Area, Areas, DifferenceKind, DifferingArea, Pool};

/// Where the others hardly differ, their variance is at least this part of that around it.
const SMALLEST_VARIANCE: f64 = 0.01;

/// For each channel, differences and their variances, of pixels or areas.
type Channels = [[Vec<f64>; 2]; 3];

/// The differences of a picture from the others, and their variances.
pub struct Map {
    pixels: Channels,
    /// The differences times the fine structure of the others, and the variances of these products.
    structure: Channels,
    /// The number of values in which all others agree against it, in each pixel.
    outliers: Vec<f64>,
}

impl Map {
    /// That of one picture, whose noise is this times that of the pool.
    pub fn of(pool: &Pool, areas: &Areas, picture: usize, noise: f64) -> Self {
        let count = areas.size[0] * areas.size[1];
        let mut outliers = vec![0.0; count];
        // its own noise, and that of the mean of the others
        let factor = noise * noise + pool.variance_of_mean();
        let means = [0, 1, 2].map(|channel| -> Vec<f64> {
            (0..count).map(|pixel| pool.mean_of_others(picture, 3 * pixel + channel)).collect()
        });
        let of_others =
            [0, 1, 2].map(|channel| Residuals::of(pool, picture, channel, &mut outliers));
        let mut pixels = [0, 1, 2].map(|channel| {
            let Residuals { difference, variance, varied } = &of_others[channel];
            let around = around(variance, areas.size);
            let own = own_variance(difference, areas.size);
            let with_floor = |pixel: usize| {
                let rounding = pool.stored.rounding(means[channel][pixel]);
                let variance = variance[pixel].max(SMALLEST_VARIANCE * around[pixel]);
                (variance * factor).max(own[pixel]) + rounding * rounding
            };
            let variance = |pixel: usize| if varied[pixel] { with_floor(pixel) } else { 0.0 };
            [difference.clone(), (0..count).map(variance).collect()]
        });
        leave_out_bright(&means, pool.stored.largest(), &mut pixels);
        let structure = [0, 1, 2].map(|channel| {
            let [differences, variances] = &pixels[channel];
            structure(&means[channel], areas.size, |pixel| {
                let variance = variances[pixel];
                let of_mean = if variance > 0.0 { of_others[channel].variance[pixel] } else { 0.0 };
                [differences[pixel], pool.variance_of_mean() * of_mean, variance]
            })
        });
        Self { pixels, structure, outliers }
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
        let each = |channels: &Channels, of: &dyn Fn(&[f64]) -> Vec<f64>| {
            channels.each_ref().map(|both| both.each_ref().map(|values| of(values)))
        };
        let by_object = |channels| each(channels, &|values| areas.by_object(values));
        let (mut tiles, mut at) = (self.pixels.clone(), 0);
        let mut of_level = |level: &DifferenceKind| {
            let channels = match *level {
                DifferenceKind::Tiles(level) => {
                    while at < level {
                        at += 1;
                        tiles = each(&tiles, &|finer| areas.coarser(finer, at));
                    }
                    tiles.clone()
                }
                DifferenceKind::Objects => by_object(&self.pixels),
                DifferenceKind::Structure => by_object(&self.structure),
                DifferenceKind::Outliers | DifferenceKind::InnerOutliers => Channels::default(),
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
        let z = |[differences, variances]: &[Vec<f64>; 2], pixel: usize| {
            let variance = variances[pixel];
            if variance > 0.0 { differences[pixel] / variance.sqrt() } else { 0.0 }
        };
        let farther = |a: f64, b: f64| if b.abs() > a.abs() { b } else { a };
        let largest = |pixel| self.pixels.iter().map(|both| z(both, pixel)).fold(0.0, farther);
        (0..self.outliers.len()).map(largest).collect()
    }

    /// The variance of the sum over an area, of a channel.
    pub fn variance(&self, pixels: &[usize], channel: usize) -> f64 {
        pixels.iter().map(|pixel| self.pixels[channel][1][*pixel]).sum()
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

/// Leaves out the pixels of which a channel's mean is near the largest value.
fn leave_out_bright(means: &[Vec<f64>; 3], largest: f64, pixels: &mut Channels) {
    for pixel in 0..means[0].len() {
        let is_near = means.iter().zip(&*pixels).any(|(mean, [_, variances])| {
            mean[pixel] + NEAR_LARGEST * variances[pixel].sqrt() > largest
        });
        if is_near {
            pixels.as_flattened_mut().iter_mut().for_each(|values| values[pixel] = 0.0);
        }
    }
}

/// Sums over the areas of a level.
pub struct DifferenceSums {
    level: DifferenceKind,
    channels: Channels,
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
        near(pixel / width, height, 1)
            .all(|y| near(pixel % width, width, 1).all(|x| counts[y * width + x] > 0.0))
    };
    let count = |pixel| if is_inside(pixel) { counts[pixel] } else { 0.0 };
    (0..counts.len()).map(count).collect()
}
