//! Pictures that stand out from their set: with values that are no numbers, with negative ones, or far from the others.

use serde::Serialize;

use super::Sets;
use super::noise::SQUARES;
use statistics::quantile;

/// A picture is far out if its differences from the median picture are this many times those of the usual picture of its set.
const FAR: f64 = 10.0;

/// In fewer squares that vary, chance may put a picture so far out.
const FEW_SQUARES: usize = 16;

/// What stands out in a picture.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Odd {
    /// The number of its values that are no numbers.
    pub not_finite: usize,
    /// The number of its negative values.
    pub negative: usize,
    /// Whether it is far from the others of its set.
    pub is_far: bool,
}

impl Odd {
    /// Of each picture, those before first.
    pub(super) fn of(sets: &Sets) -> Vec<Self> {
        let far = [&sets.before, &sets.after].map(|set| far_out(set, sets.areas.size)).concat();
        let odd = |(picture, is_far): (&Vec<f32>, bool)| Self {
            not_finite: picture.iter().filter(|value| !value.is_finite()).count(),
            negative: picture.iter().filter(|value| (f32::MIN..0.0).contains(*value)).count(),
            is_far,
        };
        sets.all().zip(far).map(odd).collect()
    }

    /// Whether such a picture, if only one side has some, makes a difference.
    pub(super) fn is_broken(&self) -> bool {
        self.not_finite > 0 || self.is_far
    }
}

/// For each picture of a set, whether it is far out in most of the squares in which it or the usual picture is not the
/// median: noise of single pixels is not. Of two pictures, none is.
fn far_out(set: &[Vec<f32>], [width, height]: [usize; 2]) -> Vec<bool> {
    let side = width.max(height).div_ceil(SQUARES);
    let across = width.div_ceil(side);
    let mut squares = vec![vec![0.0; set.len()]; across * height.div_ceil(side)];
    for index in 0..set[0].len() {
        let values: Vec<f64> = set.iter().map(|picture| f64::from(picture[index])).collect();
        let Some(median) = quantile(&values, 0.5).filter(|it| it.is_finite()) else { continue };
        let [x, y] = [index / 3 % width, index / 3 / width];
        for (sum, value) in squares[y / side * across + x / side].iter_mut().zip(values) {
            let apart = value - median;
            *sum += if apart.is_finite() { apart * apart } else { 0.0 };
        }
    }
    let is_far = |picture: usize| {
        let usual = |square: &Vec<f64>| quantile(square, 0.5).unwrap_or_default();
        let both = squares.iter().map(|square| (square[picture], usual(square)));
        let varied: Vec<_> = both.filter(|(own, usual)| own + usual > 0.0).collect();
        let far = varied.iter().filter(|(own, usual)| *own > FAR * FAR * usual).count();
        varied.len() >= FEW_SQUARES && 2 * far > varied.len()
    };
    (0..set.len()).map(is_far).collect()
}
