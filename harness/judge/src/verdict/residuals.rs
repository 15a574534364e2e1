//! What is left of a picture without the mean of the others, and its noise.

use std::ops::Range;

use super::pool::{Against, Pool};

/// The neighbours of a value whose variance counts: so many to either side.
const REACH: usize = 2;

/// The differences of a channel of a picture from the mean of the others, where the others vary.
pub struct Residuals {
    /// The value less the mean of the others; 0 where these agree.
    pub difference: Vec<f64>,
    /// Of the others.
    pub variance: Vec<f64>,
    /// Whether the others vary.
    pub varied: Vec<bool>,
}

impl Residuals {
    /// `outliers` counts the values in which all others agree against the picture.
    pub fn of(pool: &Pool, picture: usize, channel: usize, outliers: &mut [f64]) -> Self {
        let pixels = pool.size[0] * pool.size[1];
        let (mut difference, mut variance, mut varied) =
            (vec![0.0; pixels], vec![0.0; pixels], vec![false; pixels]);
        for pixel in 0..pixels {
            match pool.against(picture, 3 * pixel + channel) {
                Against::Varied { difference: d, variance: v } => {
                    (difference[pixel], variance[pixel], varied[pixel]) = (d, v, true);
                }
                Against::Outlier => outliers[pixel] += 1.0,
                Against::Same | Against::Nothing => {}
            }
        }
        Self { difference, variance, varied }
    }
}

/// For each value, the mean over pictures.
pub fn mean_of(pictures: &[Vec<f32>]) -> Vec<f64> {
    let mut mean = vec![0.0; pictures[0].len()];
    for picture in pictures {
        mean.iter_mut().zip(picture).for_each(|(sum, x)| *sum += f64::from(*x));
    }
    mean.iter_mut().for_each(|sum| *sum /= pictures.len() as f64);
    mean
}

/// A block's detail counts at most this many times the mean, so that single bright pixels do not decide.
const MOST_DETAIL: f64 = 16.0;

/// Fewer blocks say nothing of the noise.
const FEW_BLOCKS: usize = 16;

/// The square of the finest details of a picture's difference from the others, relative to the variance of these: the
/// mean over blocks of two by two pixels. `None` if there are few such blocks.
pub fn detail(pool: &Pool, picture: usize) -> Option<f64> {
    let [width, height] = pool.size;
    let mut squares = Vec::new();
    for channel in 0..3 {
        let Residuals { difference, variance, varied } =
            Residuals::of(pool, picture, channel, &mut vec![0.0; width * height]);
        for y in (0..height - height % 2).step_by(2) {
            for x in (0..width - width % 2).step_by(2) {
                let block = [[0, 0], [1, 0], [0, 1], [1, 1]].map(|[i, j]| (y + j) * width + x + i);
                let total: f64 = block.iter().map(|pixel| variance[*pixel]).sum();
                if block.iter().any(|pixel| varied[*pixel]) && total > 0.0 {
                    let [a, b, c, d] = block.map(|pixel| difference[pixel]);
                    squares.push(square(a - b - c + d) / total);
                }
            }
        }
    }
    (squares.len() >= FEW_BLOCKS).then(|| robust_mean(&squares))
}

/// The mean of values of which each counts at most [`MOST_DETAIL`] times that mean. It scales with the values.
///
/// Source: P. J. Huber, *Robust Statistics*, 1981, 5.2, "proposal 2" for a scale.
fn robust_mean(values: &[f64]) -> f64 {
    /// Further steps change the mean less than noise does.
    const STEPS: usize = 30;
    let count = values.len() as f64;
    let mut mean = values.iter().sum::<f64>() / count;
    for _ in 0..STEPS {
        let most = MOST_DETAIL * mean;
        let next = values.iter().map(|value| value.min(most)).sum::<f64>() / count;
        let is_near = mean - next <= 1e-6 * mean;
        mean = next;
        if is_near {
            break;
        }
    }
    mean
}

fn square(x: f64) -> f64 {
    x * x
}

/// The variance of a picture's noise around each pixel, from the finest details of its differences: noise has them,
/// and most errors do not.
pub fn own_variance(difference: &[f64], size @ [width, height]: [usize; 2]) -> Vec<f64> {
    let detail = |pixel: usize| {
        let (x, y) = (pixel % width, pixel / width);
        let (right, below) = (usize::from(x + 1 < width), usize::from(y + 1 < height) * width);
        let [a, b, c, d] = [0, right, below, below + right].map(|step| difference[pixel + step]);
        0.25 * square(a - b - c + d)
    };
    around(&(0..difference.len()).map(detail).collect::<Vec<f64>>(), size)
}

/// The mean over the neighbours of each value, itself among them.
pub fn around(values: &[f64], [width, height]: [usize; 2]) -> Vec<f64> {
    let mut rows = vec![0.0; values.len()];
    for (row, means) in values.chunks_exact(width).zip(rows.chunks_exact_mut(width)) {
        for (x, mean) in means.iter_mut().enumerate() {
            let near = &row[near(x, width, REACH)];
            *mean = near.iter().sum::<f64>() / near.len() as f64;
        }
    }
    let mut around = vec![0.0; values.len()];
    for (y, means) in around.chunks_exact_mut(width).enumerate() {
        let near = near(y, height, REACH);
        for row in near.clone() {
            let row = &rows[row * width..][..width];
            means.iter_mut().zip(row).for_each(|(sum, value)| *sum += value);
        }
        let count = near.len() as f64;
        means.iter_mut().for_each(|sum| *sum /= count);
    }
    around
}

/// The number of a value's neighbours, itself among them.
pub fn neighbours(pixel: usize, [width, height]: [usize; 2]) -> f64 {
    (near(pixel % width, width, REACH).len() * near(pixel / width, height, REACH).len()) as f64
}

/// The places around one on a line, so many to either side.
pub fn near(at: usize, length: usize, reach: usize) -> Range<usize> {
    at.saturating_sub(reach)..(at + reach + 1).min(length)
}
