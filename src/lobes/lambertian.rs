//! The Lambertian BRDF (Suffern, ch. 13): the same radiance in every direction.

use std::f64::consts::{FRAC_1_PI, PI};

use super::{Branch, Claims, LobeSample, Scattering};
use crate::invalid::Invalid;
use crate::math::{Vector, maps};
use crate::rgb::Rgb;

/// `f = ρ/π` on the outer side, nothing on the inner.
#[kind(Copy, PartialEq)]
pub struct Lambertian {
    /// `ρ = k_d c_d`.
    pub reflectance: Rgb,
}

impl Scattering for Lambertian {
    const BRANCH: Branch = Branch::Diffuse;

    fn claims(&self) -> Claims {
        Claims { reciprocal: true, conserves_energy: true }
    }

    fn check(&self) -> Result<(), Invalid> {
        self.reflectance.checked("reflectance").map(drop)
    }

    fn formula(&self, _: Vector, _: Vector) -> Rgb {
        FRAC_1_PI * self.reflectance
    }

    fn density(&self, _: Vector, wi: Vector) -> f64 {
        wi.z() / PI
    }

    fn selection_weight(&self, _: Vector) -> f64 {
        self.reflectance.average()
    }

    /// Cosine-distributed, so that the weight is the albedo for every sample.
    fn sample(&self, wo: Vector, u: [f64; 2]) -> Option<LobeSample> {
        let wi = maps::hemisphere(u, 1.0);
        let seen = wo.z() > 0.0 && wi.z() > 0.0;
        seen.then(|| LobeSample { wi, weight: self.reflectance, pdf: Some(self.density(wo, wi)) })
    }

    fn albedo(&self, wo: Vector) -> Rgb {
        if wo.z() > 0.0 { self.reflectance } else { Rgb::BLACK }
    }

    fn specimens() -> Vec<Self> {
        vec![Self { reflectance: Rgb::new(0.8, 0.4, 0.1) }, Self { reflectance: Rgb::WHITE }]
    }
}
