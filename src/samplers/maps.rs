//! Maps from the unit square to other domains (Suffern, ch. 7).

use std::f64::consts::PI;

use crate::math::{Vector, cos, power, sin};

/// A direction about the z axis with density proportional to `cos^e θ`: `cosθ = (1 − u₂)^(1/(e+1))`,
/// `φ = 2π u₁`. `e ≥ 0`; 0 is uniform, 1 weighs by the cosine.
pub fn hemisphere([u1, u2]: [f64; 2], e: f64) -> Vector {
    let phi = 2.0 * PI * u1;
    let cos_theta = power(1.0 - u2, 1.0 / (e + 1.0));
    let sin_theta = ((1.0 - cos_theta) * (1.0 + cos_theta)).sqrt();
    Vector::new(sin_theta * cos(phi), sin_theta * sin(phi), cos_theta)
}
