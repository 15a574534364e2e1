//! Refraction of a direction.

use crate::math::{Normal, Vector};

/// The direction behind the surface, or `None` on total internal reflection.
///
/// `wo` and `n` are unit and on the same side; `eta > 0` is the index of refraction behind the
/// surface over the one in front of it.
///
/// Source: Snell's law as vectors (Suffern, ch. 27): `t = −ω_o/η − (cosθ_t − cosθ_i/η) n`.
pub fn refract(wo: Vector, n: Normal, eta: f64) -> Option<Vector> {
    let cos_i = n.dot(wo);
    let cos_t = cos_refracted(cos_i, eta)?;
    Some(-(1.0 / eta) * wo - (cos_t - cos_i / eta) * n)
}

/// The cosine behind the surface, or `None` on total internal reflection.
pub(super) fn cos_refracted(cos_i: f64, eta: f64) -> Option<f64> {
    // factored: exact for eta = 1, no cancellation near it
    let cos_t_squared = ((eta - 1.0) * (eta + 1.0) + cos_i * cos_i) / (eta * eta);
    (cos_t_squared >= 0.0).then(|| cos_t_squared.sqrt())
}
