//! Residuals and roots of polynomials in one variable.

use crate::{
    real::{Real, magnitude, nearest, real},
    solve::Polynomial,
};

fn exact(coefficients: &[f64]) -> Polynomial {
    Polynomial(coefficients.iter().map(|&c| real(c)).collect())
}

/// `|P(x)|` over the sum of `|cₖ xᵏ|`: how much the coefficients `c₀, c₁, …` must change, relatively,
/// to make `x` a root.
pub fn residual(coefficients: &[f64], x: f64) -> f64 {
    relative(coefficients, &real(x))
}

fn relative(coefficients: &[f64], x: &Real) -> f64 {
    let size = exact(&coefficients.iter().map(|c| c.abs()).collect::<Vec<_>>());
    let sum = magnitude(&size.value(&real(magnitude(x))));
    if sum == 0.0 { 0.0 } else { magnitude(&exact(coefficients).value(x)) / sum }
}

/// The roots in `[low, high]`, ascending and rounded to the nearest `f64`; and a lower bound of the
/// relative change of the coefficients that changes the number of roots.
pub fn polynomial_roots(coefficients: &[f64], low: f64, high: f64) -> (Vec<f64>, f64) {
    let levels = exact(coefficients).levels(&real(low), &real(high));
    let places = levels[1..].iter().flatten().cloned().chain([real(low), real(high)]);
    let margin = places.map(|x| relative(coefficients, &x)).fold(f64::INFINITY, f64::min);
    (levels[0].iter().map(nearest).collect(), margin)
}
