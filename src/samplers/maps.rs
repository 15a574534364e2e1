//! Maps from the unit square to other domains (Suffern, ch. 6 and 7).

use std::f64::consts::PI;

use crate::math::{Vector, cos, power, sin};

/// A point of the unit disk: concentric squares become concentric circles, areas keep their ratio
/// (Suffern, ch. 6; Shirley & Chiu, "A Low Distortion Map Between Disk and Square", 1997).
pub fn disk([u1, u2]: [f64; 2]) -> [f64; 2] {
    let (a, b) = (2.0 * u1 - 1.0, 2.0 * u2 - 1.0);
    // the book's four sectors; the angle in units of π/4
    let (r, angle) = if a > -b {
        if a > b { (a, b / a) } else { (b, 2.0 - a / b) }
    } else if a < b {
        (-a, 4.0 + b / a)
    } else if b != 0.0 {
        (-b, 6.0 - a / b)
    } else {
        (0.0, 0.0)
    };
    let phi = 0.25 * PI * angle;
    [r * cos(phi), r * sin(phi)]
}

/// A direction about the z axis with density proportional to `cos^e θ`: `cosθ = (1 − u₂)^(1/(e+1))`,
/// `φ = 2π u₁`. `e ≥ 0`; 0 is uniform, 1 weighs by the cosine.
pub fn hemisphere([u1, u2]: [f64; 2], e: f64) -> Vector {
    let phi = 2.0 * PI * u1;
    let cos_theta = power(1.0 - u2, 1.0 / (e + 1.0));
    let sin_theta = ((1.0 - cos_theta) * (1.0 + cos_theta)).sqrt();
    Vector::new(sin_theta * cos(phi), sin_theta * sin(phi), cos_theta)
}
