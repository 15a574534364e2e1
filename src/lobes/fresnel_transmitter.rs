//! The Fresnel transmitter (Suffern, ch. 28): refraction whose strength depends on the angle.

use super::{Branch, Claims, LobeSample, Scattering, fresnel, normal_towards, refract, relative};
use crate::invalid::{Invalid, index_ratio};
use crate::math::Vector;
use crate::rgb::Rgb;

/// Light from the refracted direction, by Fresnel's equations, times the `1/η²` of radiance.
#[kind(Copy, PartialEq)]
pub struct FresnelTransmitter {
    /// The index of refraction inside over the one outside.
    pub eta: f64,
}

impl Scattering for FresnelTransmitter {
    const BRANCH: Branch = Branch::Refraction;

    fn claims(&self) -> Claims {
        // as the perfect transmitter
        Claims { reciprocal: false, conserves_energy: true }
    }

    fn check(&self) -> Result<(), Invalid> {
        index_ratio("eta", self.eta).map(drop)
    }

    fn selection_weight(&self, wo: Vector) -> f64 {
        fresnel(wo.z().abs(), relative(self.eta, wo)).transmitted
    }

    fn sample(&self, wo: Vector, _: [f64; 2]) -> Option<LobeSample> {
        let eta = relative(self.eta, wo);
        let wi = refract(wo, normal_towards(wo), eta)?;
        let transmitted = fresnel(wo.z().abs(), eta).transmitted;
        let weight = Rgb::grey(transmitted / (eta * eta));
        (transmitted > 0.0).then_some(LobeSample { wi, weight, pdf: None })
    }

    fn albedo(&self, wo: Vector) -> Rgb {
        self.sample(wo, [0.0; 2]).map_or(Rgb::BLACK, |sample| sample.weight)
    }

    fn eta(&self) -> Option<f64> {
        Some(self.eta)
    }

    fn specimens() -> Vec<Self> {
        vec![Self { eta: 1.5 }, Self { eta: 0.75 }, Self { eta: 1.0 }]
    }
}
