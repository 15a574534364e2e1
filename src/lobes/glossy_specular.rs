//! The glossy specular BRDF (Suffern, ch. 15): Phong's highlight.

use std::f64::consts::PI;

use super::{Branch, Claims, LobeSample, Scattering, cosine_power, drawn};
use crate::invalid::Invalid;
use crate::math::Vector;
use crate::rgb::Rgb;

/// `f = k_s c_s (r·ω_o)^e`, `r` the mirror image of `ω_i`; no normalising factor, as in the book,
/// so that a broad lobe (small `e`) can send out more light than arrives.
#[kind(Copy, PartialEq)]
pub struct GlossySpecular {
    /// `k_s c_s`.
    pub reflectance: Rgb,
    /// `e`, not negative.
    pub exponent: f64,
}

impl Scattering for GlossySpecular {
    const BRANCH: Branch = Branch::Highlight;

    fn claims(&self) -> Claims {
        Claims { reciprocal: true, conserves_energy: false }
    }

    fn check(&self) -> Result<(), Invalid> {
        cosine_power::check_exponent(self.exponent)?;
        self.reflectance.checked("reflectance").map(drop)
    }

    fn formula(&self, wo: Vector, wi: Vector) -> Rgb {
        cosine_power::value(self.exponent, wo, wi) * self.reflectance
    }

    /// What falls below the surface is lost, so it integrates to less than 1 there.
    fn density(&self, wo: Vector, wi: Vector) -> f64 {
        cosine_power::density(self.exponent, wo, wi)
    }

    fn selection_weight(&self, _: Vector) -> f64 {
        // its albedo for a viewer straight above, at most the reflectance
        self.reflectance.average() * (2.0 * PI / (self.exponent + 2.0)).min(1.0)
    }

    fn sample(&self, wo: Vector, u: [f64; 2]) -> Option<LobeSample> {
        let [wi, _] = cosine_power::sample(self.exponent, wo, u)?;
        drawn(self, wo, wi)
    }

    fn albedo(&self, wo: Vector) -> Rgb {
        cosine_power::integral(self.exponent, wo.z()) * self.reflectance
    }

    fn specimens() -> Vec<Self> {
        let lobe = |ks, exponent| Self { reflectance: Rgb::grey(ks), exponent };
        vec![lobe(0.2, 10.0), lobe(0.25, 0.25), lobe(0.5, 2000.0), lobe(1.0, 0.0)]
    }
}
