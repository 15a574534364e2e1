//! Fresnel's equations for unpolarised light (Suffern, ch. 28).

use super::refract::cos_refracted;

/// How light divides at a boundary; the two add up to 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fresnel {
    /// The share that is reflected, `k_r` in the book.
    pub reflected: f64,
    /// The share that passes, `k_t`: from the transmitted amplitudes, not as `1 − k_r`.
    pub transmitted: f64,
}

/// The shares for light that meets a boundary at `cos_i ≥ 0`, going from a medium into one whose
/// index is `eta` times as large. Beyond the critical angle all of it is reflected.
pub fn fresnel(cos_i: f64, eta: f64) -> Fresnel {
    if eta == 1.0 {
        return Fresnel { reflected: 0.0, transmitted: 1.0 }; // no boundary, also at cos 0
    }
    let Some(cos_t) = cos_refracted(cos_i, eta) else {
        return Fresnel { reflected: 1.0, transmitted: 0.0 };
    };
    let parallel = eta * cos_i + cos_t;
    let perpendicular = cos_i + eta * cos_t;
    let r_par = (eta * cos_i - cos_t) / parallel;
    let r_perp = (cos_i - eta * cos_t) / perpendicular;
    Fresnel {
        reflected: 0.5 * (r_par * r_par + r_perp * r_perp),
        // amplitudes t = 2 cosθ_i/(…), power η cosθ_t/cosθ_i · t²
        transmitted: 2.0
            * (eta * cos_i * cos_t)
            * (1.0 / (parallel * parallel) + 1.0 / (perpendicular * perpendicular)),
    }
}
