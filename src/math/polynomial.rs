//! All real roots of polynomials of small degree, in order (Suffern, ch. 19, needs degree 4; a
//! user's own surface may need more).
//!
//! Between two neighbouring roots of its derivative a polynomial is monotone: it has at most one
//! root there, and the signs at both ends tell whether it has one (Yuksel, "High-Performance
//! Polynomial Root Finding for Graphics", HPG 2022). There is no closed formula, so a leading
//! coefficient that is tiny or zero is no special case, and no square root is taken of a number
//! that rounding made negative.

use arrayvec::ArrayVec;

use super::UNIT_ROUNDOFF;
use super::exact::{two_product, two_sum};
use super::roots::{Tolerance, bracketed_root};

/// The highest degree of [`roots_between`] and [`real_roots`].
pub const MAX_DEGREE: usize = 16;

/// The roots of a polynomial of at most [`MAX_DEGREE`], ascending.
pub type Roots = ArrayVec<f64, MAX_DEGREE>;

type Coefficients = ArrayVec<f64, { MAX_DEGREE + 1 }>;

/// A value counts as zero if a relative change of every coefficient by this could make it zero:
/// rounding of the coefficients must not lose a double root.
const ZERO: f64 = 4.0 * UNIT_ROUNDOFF;

/// The real roots of `c₀ + c₁ x + c₂ x² + …` in `[low, high]`, ascending; a root of even
/// multiplicity counts once or twice. Empty if all coefficients are zero, if one is not finite, or
/// if the degree is above [`MAX_DEGREE`]; leading zeros do not count.
///
/// Each root is the exact root of a polynomial whose coefficients differ from the given ones by a
/// few u.
pub fn roots_between(coefficients: &[f64], low: f64, high: f64) -> Roots {
    let degree = coefficients.iter().rposition(|&c| c != 0.0).unwrap_or(0);
    let coefficients = &coefficients[..coefficients.len().min(degree + 1)];
    let ordered = low <= high && coefficients.iter().all(|c| c.is_finite());
    if !(1..=MAX_DEGREE).contains(&degree) || !ordered {
        return Roots::new();
    }
    let stationary = roots_between(&derivative(coefficients), low, high);
    let mut roots = Roots::new();
    let mut left = (low, 0.0);
    let points = [low].into_iter().chain(stationary).chain([high]);
    for (index, x) in points.enumerate() {
        let sign = sign(coefficients, x);
        let found = match (index, left.1 * sign) {
            _ if sign == 0.0 => Some(x), // a double root, or an end of the interval
            (1.., -1.0) => Some(monotone_root(coefficients, left, x)),
            _ => None,
        };
        if let Some(root) = found.filter(|&root| roots.last() != Some(&root)) {
            // more than `degree` only if stationary points coincide within rounding
            let _ = roots.try_push(root);
        }
        left = (x, sign);
    }
    roots
}

/// All real roots, ascending: those in [−1, 1], and the inverses of the roots in [−1, 1] of the
/// polynomial with reversed coefficients. See [`roots_between`].
pub fn real_roots(coefficients: &[f64]) -> Roots {
    let degree = coefficients.iter().rposition(|&c| c != 0.0).unwrap_or(0);
    let reversed: Vec<f64> = coefficients.iter().take(degree + 1).rev().copied().collect();
    let large = |low, high| {
        let inverses = roots_between(&reversed, low, high).into_iter().rev();
        inverses.filter(|&y| y != 0.0).map(|y| 1.0 / y).filter(|x| x.is_finite())
    };
    let small = roots_between(coefficients, -1.0, 1.0);
    let negative = large(-1.0, 0.0).filter(|&x| x < -1.0);
    negative.chain(small).chain(large(0.0, 1.0).filter(|&x| x > 1.0)).take(MAX_DEGREE).collect()
}

fn derivative(coefficients: &[f64]) -> Coefficients {
    coefficients.iter().enumerate().skip(1).map(|(power, c)| power as f64 * c).collect()
}

/// The sign of the value: −1, 1, or 0 if the value may be only rounding of the coefficients.
fn sign(coefficients: &[f64], x: f64) -> f64 {
    let magnitude = coefficients.iter().rev().fold(0.0, |sum, c| sum * x.abs() + c.abs());
    let value = accurate_value(coefficients, x);
    if value.abs() <= ZERO * magnitude { 0.0 } else { 1.0_f64.copysign(value) }
}

/// The root between two points where the signs differ; the derivative does not vanish between them.
fn monotone_root(coefficients: &[f64], (left, sign): (f64, f64), right: f64) -> f64 {
    let bracket = if sign < 0.0 { [left, right] } else { [right, left] };
    let f = |x| value_and_slope(coefficients, x);
    let x = bracketed_root(f, bracket, 0.5 * left + 0.5 * right, Tolerance::default());
    // corrects the rounding error of plain evaluation
    let step = accurate_value(coefficients, x) / f(x)[1];
    let better = x - step;
    if left < better && better < right { better } else { x }
}

/// Horner's scheme, for the polynomial and its derivative.
pub fn value_and_slope(coefficients: &[f64], x: f64) -> [f64; 2] {
    let step = |[value, slope]: [f64; 2], c: &f64| [value * x + c, slope * x + value];
    coefficients.iter().rev().fold([0.0; 2], step)
}

/// Horner's scheme that carries every rounding error along, as if in twice the precision (Graillat,
/// Langlois & Louvet, "Compensated Horner Scheme", 2005).
fn accurate_value(coefficients: &[f64], x: f64) -> f64 {
    let step = |(value, error): (f64, f64), &c: &f64| {
        let (product, lost) = two_product(value, x);
        let (sum, lost_too) = two_sum(product, c);
        (sum, error * x + (lost + lost_too))
    };
    let (value, error) = coefficients.iter().rev().fold((0.0, 0.0), step);
    // the plain value if splitting overflows, beyond 1e290
    if error.is_finite() { value + error } else { value_and_slope(coefficients, x)[0] }
}
