//! The power of the cosine about the mirror direction r, `(r·ω_i)^e`: Phong's lobe, which the
//! highlights of chapter 15 and the glossy reflection of chapter 25 share.

use std::f64::consts::PI;

use super::mirrored;
use crate::invalid::{Invalid, not_negative};
use crate::math::{Frame, Normal, Vector, atan2, exp, exp_m1, ln, ln_1p, maps, power, tanh_sinh};

/// Refuses exponents that are negative or too large, of the field `exponent`. At 1e15 the lobe is
/// as narrow as the rounding of directions: a narrower one would have an infinite density, or none,
/// where it draws.
pub(crate) fn check_exponent(exponent: f64) -> Result<(), Invalid> {
    if not_negative("exponent", exponent)? <= 1e15 {
        return Ok(());
    }
    let problem = format!("found {exponent:e}, but at most 1e15 fits; a mirror is `reflective`");
    Err(Invalid::field("exponent", problem))
}

/// `(r·ω_i)^e`, or 0 where `ω_i` is more than 90° from r.
pub(super) fn value(exponent: f64, wo: Vector, wi: Vector) -> f64 {
    let cosine = mirrored(wi).dot(wo);
    if cosine <= 0.0 { 0.0 } else { power(cosine, exponent) }
}

/// Its density over the sphere, `(e + 1)/2π (r·ω_i)^e`.
pub(super) fn density(exponent: f64, wo: Vector, wi: Vector) -> f64 {
    (exponent + 1.0) / (2.0 * PI) * value(exponent, wo, wi)
}

/// A direction of that density, perhaps below the surface; and the same one on the other side of r.
pub(super) fn sample(exponent: f64, wo: Vector, u: [f64; 2]) -> Option<[Vector; 2]> {
    let frame = Frame::around(Normal::new(mirrored(wo))?);
    let local = maps::hemisphere(u, exponent);
    let flipped = Vector::new(-local.x(), -local.y(), local.z());
    Some([local, flipped].map(|w| frame.to_world(w)))
}

/// `∫ (r·ω_i)^e cosθ_i dω_i` above the surface for a viewer at this cosine, in rings at the angle α
/// from r. On a ring that lies above the horizon the mean of `cosθ_i` is `cosα cosθ_o`; those up to
/// `α_h = π/2 − θ_o` do, and their integral is `2π cosθ_o (1 − cos^(e+2) α_h)/(e + 2)`. Beyond, the
/// arc `|φ| < φ_h` is left, and its integral is taken over `y = (cosα/cosα_h)^(e+1)` by the
/// tanh–sinh rule.
pub(super) fn integral(e: f64, cos_o: f64) -> f64 {
    if cos_o <= 0.0 {
        return 0.0;
    }
    // cosα_h = sinθ_o; its logarithm keeps the digits of powers near 1
    let ln_sin_o = 0.5 * ln_1p(-cos_o.min(1.0) * cos_o.min(1.0));
    let above = -exp_m1((e + 2.0) * ln_sin_o) / (e + 2.0);
    let arc = |ln_y: f64| {
        let ln_q = ln_y / (e + 1.0); // q = cosα/cosα_h
        // sinα sinφ_h = √(1 − q²), sinα cosφ_h = −q cosθ_o
        let across = (-exp_m1(2.0 * ln_q)).sqrt();
        let along = exp(ln_q) * cos_o;
        along * atan2(across, -along) + across
    };
    let beyond = 2.0 * exp((e + 2.0) * ln_sin_o) / (e + 1.0) * tanh_sinh(|y| arc(ln(y)));
    2.0 * PI * cos_o * above + beyond
}
