//! The perfect mirror (Suffern, ch. 24).

use super::{Branch, Claims, LobeSample, Scattering, mirrored};
use crate::invalid::Invalid;
use crate::math::Vector;
use crate::rgb::Rgb;

/// All light from the mirror direction, on either side of the surface.
///
/// The book divides by `n·ω_i` and multiplies by it again; seen from behind, where the product is
/// negative, its mirrors send out negative radiance. Here the two cancel before they are formed.
#[kind(Copy, PartialEq)]
pub struct PerfectSpecular {
    /// `k_r c_r`.
    pub reflectance: Rgb,
}

impl Scattering for PerfectSpecular {
    const BRANCH: Branch = Branch::Mirror;

    fn claims(&self) -> Claims {
        Claims { reciprocal: true, conserves_energy: true }
    }

    fn check(&self) -> Result<(), Invalid> {
        self.reflectance.checked("reflectance").map(drop)
    }

    fn selection_weight(&self, _: Vector) -> f64 {
        self.reflectance.average()
    }

    fn sample(&self, wo: Vector, _: [f64; 2]) -> Option<LobeSample> {
        Some(LobeSample { wi: mirrored(wo), weight: self.reflectance, pdf: None })
    }

    fn albedo(&self, _: Vector) -> Rgb {
        self.reflectance
    }

    fn specimens() -> Vec<Self> {
        vec![Self { reflectance: Rgb::new(0.9, 0.8, 0.7) }]
    }
}
