//! The truncated Gaussian filter.

use std::f64::consts::{PI, SQRT_2};

use super::{Filter, Made, Specification, inverse, made};
use crate::invalid::Invalid;
use crate::math::{Positive, erf, exp};

/// `c exp(−x²/2σ²)` within the radius.
#[kind(PartialEq)]
pub struct Gaussian {
    /// The standard deviation σ, in pixels; at least a hundredth of the radius.
    #[default(0.5)]
    pub sigma: Positive,
    /// The radius in pixels: positive, at most 16.
    #[default(1.5)]
    pub radius: f64,
}

impl Specification for Gaussian {
    fn make(&self, (): &mut ()) -> Made {
        let radius = super::radius(self.radius)?;
        let sigma = self.sigma;
        if sigma < 0.01 * radius {
            let problem = format!("found {sigma}, less than a hundredth of the radius {radius}");
            return Err(Invalid::field("sigma", problem));
        }
        let end = radius / (SQRT_2 * sigma);
        made(GaussianFilter { radius, scale: SQRT_2 * sigma, end, whole: erf(end) })
    }
}

/// In units of `√2 σ` the filter is `exp(−z²)`.
#[derive(Debug)]
struct GaussianFilter {
    radius: f64,
    /// `√2 σ`.
    scale: f64,
    /// The radius in that unit.
    end: f64,
    /// The error function at `end`.
    whole: f64,
}

impl Filter for GaussianFilter {
    /// The inverse of `erf(z)/erf(end)`, of both signs.
    fn draw(&self, u: f64) -> (f64, f64) {
        let v = 2.0 * u - 1.0;
        let slope = |z: f64| 2.0 / PI.sqrt() * exp(-z * z);
        let z = inverse(v.abs() * self.whole, self.end, |z| [erf(z), slope(z)]);
        (0.5 + (self.scale * z).copysign(v), 1.0)
    }

    fn value(&self, x: f64) -> f64 {
        let z = x / self.scale;
        if x.abs() > self.radius {
            return 0.0;
        }
        exp(-z * z) / (PI.sqrt() * self.scale * self.whole)
    }

    fn radius(&self) -> f64 {
        self.radius
    }
}
