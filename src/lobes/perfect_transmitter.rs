//! The perfect transmitter (Suffern, ch. 27): refraction with a constant weight.

use super::refract::cos_refracted;
use super::{Branch, Claims, LobeSample, Scattering, normal_towards, refract, relative};
use crate::invalid::{Invalid, index_ratio, not_negative};
use crate::math::Vector;
use crate::rgb::Rgb;

/// All light from the refracted direction. Radiance changes by `1/η²` where it crosses into a
/// medium of relative index η, as seen along the ray.
#[kind(Copy, PartialEq)]
pub struct PerfectTransmitter {
    /// `k_t`.
    pub transmittance: f64,
    /// The index of refraction inside over the one outside.
    pub eta: f64,
}

impl PerfectTransmitter {
    /// Whether a viewer at this cosine (negative inside) sees total internal reflection, the
    /// book's `tir`.
    pub fn reflects_totally(&self, cos_o: f64) -> bool {
        let eta = if cos_o < 0.0 { 1.0 / self.eta } else { self.eta };
        cos_refracted(cos_o, eta).is_none()
    }
}

impl Scattering for PerfectTransmitter {
    const BRANCH: Branch = Branch::Refraction;

    fn claims(&self) -> Claims {
        // the index of refraction enters once, on one side: reciprocal in basic radiance L/η² only
        Claims { reciprocal: false, conserves_energy: true }
    }

    fn check(&self) -> Result<(), Invalid> {
        not_negative("transmittance", self.transmittance)?;
        index_ratio("eta", self.eta).map(drop)
    }

    fn selection_weight(&self, wo: Vector) -> f64 {
        let passes = !self.reflects_totally(wo.z());
        if passes { self.transmittance } else { 0.0 }
    }

    fn sample(&self, wo: Vector, _: [f64; 2]) -> Option<LobeSample> {
        let eta = relative(self.eta, wo);
        let wi = refract(wo, normal_towards(wo), eta)?;
        let weight = Rgb::grey(self.transmittance / (eta * eta));
        Some(LobeSample { wi, weight, pdf: None })
    }

    fn albedo(&self, wo: Vector) -> Rgb {
        self.sample(wo, [0.0; 2]).map_or(Rgb::BLACK, |sample| sample.weight)
    }

    fn eta(&self) -> Option<f64> {
        Some(self.eta)
    }

    fn specimens() -> Vec<Self> {
        vec![
            Self { transmittance: 0.9, eta: 1.5 },
            Self { transmittance: 0.5, eta: 0.75 },
            Self { transmittance: 1.0, eta: 1.0 },
        ]
    }
}
