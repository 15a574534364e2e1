//! Fresnel's equations (Suffern, ch. 28), for each polarisation and for unpolarised light.

use super::refract::cos_refracted;

/// How light divides at a boundary; the two add up to 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fresnel {
    /// The share that is reflected, `k_r` in the book.
    pub reflected: f64,
    /// The share that passes, `k_t`: from the transmitted amplitudes, not as `1 − k_r`.
    pub transmitted: f64,
}

/// How light of each polarisation divides.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Polarised {
    /// Light whose electric field is perpendicular to the plane of incidence; `r_⊥²` in the book.
    pub s: Fresnel,
    /// Light whose electric field is in that plane; `r_∥²` in the book.
    pub p: Fresnel,
}

/// The shares for unpolarised light that meets a boundary at `cos_i ≥ 0`, going from a medium into
/// one whose index is `eta` times as large: the means of both polarisations. Beyond the critical
/// angle all of it is reflected.
pub fn fresnel(cos_i: f64, eta: f64) -> Fresnel {
    let Terms { r_s, r_p, passing, t_s, t_p } = Terms::of(cos_i, eta);
    Fresnel { reflected: 0.5 * (r_p + r_s), transmitted: 2.0 * passing * (t_p + t_s) }
}

/// The shares for each polarisation of light that meets the boundary so.
pub fn polarised(cos_i: f64, eta: f64) -> Polarised {
    let Terms { r_s, r_p, passing, t_s, t_p } = Terms::of(cos_i, eta);
    Polarised {
        s: Fresnel { reflected: r_s, transmitted: 4.0 * passing * t_s },
        p: Fresnel { reflected: r_p, transmitted: 4.0 * passing * t_p },
    }
}

/// What the shares are made of: a polarisation reflects `r`, and passes `4 passing t`.
struct Terms {
    /// The reflected amplitudes' squares.
    r_s: f64,
    r_p: f64,
    /// `η cosθ_i cosθ_t`.
    passing: f64,
    /// The transmitted amplitudes' squares over `4 cos²θ_i`.
    t_s: f64,
    t_p: f64,
}

impl Terms {
    const NOTHING_REFLECTED: Self = Self { r_s: 0.0, r_p: 0.0, passing: 0.25, t_s: 1.0, t_p: 1.0 };
    const ALL_REFLECTED: Self = Self { r_s: 1.0, r_p: 1.0, passing: 0.0, t_s: 1.0, t_p: 1.0 };

    fn of(cos_i: f64, eta: f64) -> Self {
        if eta == 1.0 {
            return Self::NOTHING_REFLECTED; // no boundary, also at cos 0
        }
        let Some(cos_t) = cos_refracted(cos_i, eta) else {
            return Self::ALL_REFLECTED;
        };
        let parallel = eta * cos_i + cos_t;
        let perpendicular = cos_i + eta * cos_t;
        let r_par = (eta * cos_i - cos_t) / parallel;
        let r_perp = (cos_i - eta * cos_t) / perpendicular;
        Self {
            r_s: r_perp * r_perp,
            r_p: r_par * r_par,
            // amplitudes t = 2 cosθ_i/(…), power η cosθ_t/cosθ_i · t²
            passing: eta * cos_i * cos_t,
            t_s: 1.0 / (perpendicular * perpendicular),
            t_p: 1.0 / (parallel * parallel),
        }
    }
}
