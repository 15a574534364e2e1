//! The Lambertian BRDF (Suffern, ch. 13): the same radiance in every direction.

use std::f64::consts::{FRAC_1_PI, PI};

use serde::{Deserialize, Serialize};

use super::{Claims, LobeSample};
use crate::invalid::Invalid;
use crate::math::Vector;
use crate::rgb::Rgb;
use crate::samplers::maps;

/// `f = ρ/π` on the outer side, nothing on the inner.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Lambertian {
    /// `ρ = k_d c_d`.
    pub reflectance: Rgb,
}

impl Lambertian {
    pub(super) const SPECULAR: bool = false;
    pub(super) const CLAIMS: Claims = Claims { reciprocal: true, conserves_energy: true };

    pub(super) fn check(&self) -> Result<(), Invalid> {
        self.reflectance.checked("reflectance").map(drop)
    }

    pub(super) fn f(&self, wo: Vector, wi: Vector) -> Rgb {
        if wo.z() > 0.0 { self.f_outside(wi) } else { Rgb::BLACK }
    }

    pub(super) fn f_outside(&self, wi: Vector) -> Rgb {
        if wi.z() > 0.0 { FRAC_1_PI * self.reflectance } else { Rgb::BLACK }
    }

    pub(super) fn pdf(&self, wo: Vector, wi: Vector) -> f64 {
        if wo.z() > 0.0 && wi.z() > 0.0 { wi.z() / PI } else { 0.0 }
    }

    /// Cosine-distributed, so that the weight is the albedo for every sample.
    pub(super) fn sample(&self, wo: Vector, u: [f64; 2]) -> Option<LobeSample> {
        let wi = maps::hemisphere(u, 1.0);
        let pdf = self.pdf(wo, wi);
        (pdf > 0.0).then_some(LobeSample { wi, weight: self.reflectance, pdf })
    }

    pub(super) fn albedo(&self, wo: Vector) -> Rgb {
        if wo.z() > 0.0 { self.reflectance } else { Rgb::BLACK }
    }

    pub(super) fn specimens() -> Vec<Self> {
        vec![Self { reflectance: Rgb::new(0.8, 0.4, 0.1) }, Self { reflectance: Rgb::WHITE }]
    }
}
