//! The glossy specular BRDF (Suffern, ch. 15): Phong's highlight.

use std::f64::consts::PI;

use serde::{Deserialize, Serialize};

use super::{Claims, LobeSample, mirrored};
use crate::invalid::{Invalid, not_negative};
use crate::math::{Frame, Normal, Vector, cos, power, sin};
use crate::rgb::Rgb;
use crate::samplers::maps;

/// `f = k_s c_s (r·ω_o)^e`, `r` the mirror image of `ω_i`; no normalising factor, as in the book,
/// so that a broad lobe (small `e`) can send out more light than arrives.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct GlossySpecular {
    /// `k_s c_s`.
    pub reflectance: Rgb,
    /// `e`, not negative.
    pub exponent: f64,
}

impl GlossySpecular {
    pub(super) const SPECULAR: bool = false;
    pub(super) const CLAIMS: Claims = Claims { reciprocal: true, conserves_energy: false };

    pub(super) fn check(&self) -> Result<(), Invalid> {
        not_negative("exponent", self.exponent)?;
        self.reflectance.checked("reflectance").map(drop)
    }

    pub(super) fn f(&self, wo: Vector, wi: Vector) -> Rgb {
        if wo.z() > 0.0 { self.f_outside(wo, wi) } else { Rgb::BLACK }
    }

    pub(super) fn f_outside(&self, wo: Vector, wi: Vector) -> Rgb {
        let cosine = mirrored(wi).dot(wo);
        if wi.z() <= 0.0 || cosine <= 0.0 {
            return Rgb::BLACK;
        }
        power(cosine, self.exponent) * self.reflectance
    }

    /// The density of a cosine power about the mirror direction, `(e + 1)/2π (r·ω_o)^e`; what falls
    /// below the surface is lost, so it integrates to less than 1 there.
    pub(super) fn pdf(&self, wo: Vector, wi: Vector) -> f64 {
        let cosine = mirrored(wo).dot(wi);
        if wo.z() <= 0.0 || wi.z() <= 0.0 || cosine <= 0.0 {
            return 0.0;
        }
        (self.exponent + 1.0) / (2.0 * PI) * power(cosine, self.exponent)
    }

    pub(super) fn sample(&self, wo: Vector, u: [f64; 2]) -> Option<LobeSample> {
        let r = Normal::new(mirrored(wo))?;
        let wi = Frame::around(r).to_world(maps::hemisphere(u, self.exponent));
        let pdf = self.pdf(wo, wi);
        let weight = (wi.z() / pdf) * self.f(wo, wi);
        (pdf > 0.0).then_some(LobeSample { wi, weight, pdf })
    }

    /// By quadrature in polar coordinates about the mirror direction: there is no closed form for
    /// every exponent. At normal incidence it is `2π k_s/(e + 2)`.
    pub(super) fn albedo(&self, wo: Vector) -> Rgb {
        let Some(r) = Normal::new(mirrored(wo)).filter(|_| wo.z() > 0.0) else {
            return Rgb::BLACK;
        };
        const STEPS: u32 = 256;
        let frame = Frame::around(r);
        let mut sum = 0.0;
        for i in 0..STEPS {
            // equal steps of cos^(e+1), the measure of the lobe itself
            let u = (f64::from(i) + 0.5) / f64::from(STEPS);
            let cos_alpha = power(u, 1.0 / (self.exponent + 1.0));
            let sin_alpha = (1.0 - cos_alpha * cos_alpha).max(0.0).sqrt();
            for j in 0..STEPS {
                let phi = 2.0 * PI * (f64::from(j) + 0.5) / f64::from(STEPS);
                let local = Vector::new(sin_alpha * cos(phi), sin_alpha * sin(phi), cos_alpha);
                sum += frame.to_world(local).z().max(0.0);
            }
        }
        let mean = sum / f64::from(STEPS * STEPS);
        (2.0 * PI / (self.exponent + 1.0) * mean) * self.reflectance
    }

    pub(super) fn specimens() -> Vec<Self> {
        let lobe = |ks, exponent| Self { reflectance: Rgb::grey(ks), exponent };
        vec![lobe(0.2, 10.0), lobe(0.25, 0.25), lobe(0.5, 2000.0), lobe(1.0, 0.0)]
    }
}
