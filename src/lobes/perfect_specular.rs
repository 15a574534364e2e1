//! The perfect mirror (Suffern, ch. 24).

use serde::{Deserialize, Serialize};

use super::{Claims, LobeSample, mirrored};
use crate::invalid::Invalid;
use crate::math::Vector;
use crate::rgb::Rgb;

/// All light from the mirror direction, on either side of the surface.
///
/// The book divides by `n·ω_i` and multiplies by it again; seen from behind, where the product is
/// negative, its mirrors send out negative radiance. Here the two cancel before they are formed.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PerfectSpecular {
    /// `k_r c_r`.
    pub reflectance: Rgb,
}

impl PerfectSpecular {
    pub(super) const SPECULAR: bool = true;
    pub(super) const CLAIMS: Claims = Claims { reciprocal: true, conserves_energy: true };

    pub(super) fn check(&self) -> Result<(), Invalid> {
        self.reflectance.checked("reflectance").map(drop)
    }

    pub(super) fn f(&self, _: Vector, _: Vector) -> Rgb {
        Rgb::BLACK
    }

    pub(super) fn pdf(&self, _: Vector, _: Vector) -> f64 {
        0.0
    }

    pub(super) fn sample(&self, wo: Vector, _: [f64; 2]) -> Option<LobeSample> {
        Some(LobeSample { wi: mirrored(wo), weight: self.reflectance, pdf: f64::INFINITY })
    }

    pub(super) fn albedo(&self, _: Vector) -> Rgb {
        self.reflectance
    }

    pub(super) fn specimens() -> Vec<Self> {
        vec![Self { reflectance: Rgb::new(0.9, 0.8, 0.7) }]
    }
}
