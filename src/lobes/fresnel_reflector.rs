//! The Fresnel reflector (Suffern, ch. 28): a mirror whose strength depends on the angle.

use super::{Branch, Claims, LobeSample, Scattering, fresnel, mirrored, relative};
use crate::invalid::{Invalid, index_ratio};
use crate::math::Vector;
use crate::rgb::Rgb;

/// Light from the mirror direction, by Fresnel's equations; all of it on total internal reflection.
#[kind(Copy, PartialEq)]
pub struct FresnelReflector {
    /// The index of refraction inside over the one outside.
    pub eta: f64,
}

impl Scattering for FresnelReflector {
    const BRANCH: Branch = Branch::Mirror;

    fn claims(&self) -> Claims {
        Claims { reciprocal: true, conserves_energy: true }
    }

    fn check(&self) -> Result<(), Invalid> {
        index_ratio("eta", self.eta).map(drop)
    }

    fn selection_weight(&self, wo: Vector) -> f64 {
        fresnel(wo.z().abs(), relative(self.eta, wo)).reflected
    }

    fn sample(&self, wo: Vector, _: [f64; 2]) -> Option<LobeSample> {
        let reflected = fresnel(wo.z().abs(), relative(self.eta, wo)).reflected;
        let weight = Rgb::grey(reflected);
        (reflected > 0.0).then_some(LobeSample { wi: mirrored(wo), weight, pdf: None })
    }

    fn albedo(&self, wo: Vector) -> Rgb {
        Rgb::grey(fresnel(wo.z().abs(), relative(self.eta, wo)).reflected)
    }

    fn specimens() -> Vec<Self> {
        vec![Self { eta: 1.5 }, Self { eta: 0.75 }, Self { eta: 2.42 }]
    }
}
