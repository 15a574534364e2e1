//! The glossy specular BRDF (Suffern, ch. 15): Phong's highlight.

use std::f64::consts::PI;

use serde::{Deserialize, Serialize};

use super::{Branch, Claims, LobeSample, Scatter, mirrored};
use crate::invalid::{Invalid, not_negative};
use crate::math::{Frame, Normal, Vector, atan2, exp, exp_m1, ln, ln_1p, maps, power, tanh_sinh};
use crate::rgb::Rgb;

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

impl Scatter for GlossySpecular {
    const BRANCH: Branch = Branch::Highlight;
    const CLAIMS: Claims = Claims { reciprocal: true, conserves_energy: false };

    fn check(&self) -> Result<(), Invalid> {
        not_negative("exponent", self.exponent)?;
        self.reflectance.checked("reflectance").map(drop)
    }

    fn formula(&self, wo: Vector, wi: Vector) -> Rgb {
        let cosine = mirrored(wi).dot(wo);
        if cosine <= 0.0 {
            return Rgb::BLACK;
        }
        power(cosine, self.exponent) * self.reflectance
    }

    /// The density of a cosine power about the mirror direction, `(e + 1)/2π (r·ω_i)^e`; what falls
    /// below the surface is lost, so it integrates to less than 1 there.
    fn density(&self, wo: Vector, wi: Vector) -> f64 {
        let cosine = mirrored(wo).dot(wi);
        if cosine <= 0.0 {
            return 0.0;
        }
        (self.exponent + 1.0) / (2.0 * PI) * power(cosine, self.exponent)
    }

    fn chance(&self, _: Vector) -> f64 {
        // its albedo for a viewer straight above, at most the reflectance
        self.reflectance.average() * (2.0 * PI / (self.exponent + 2.0)).min(1.0)
    }

    fn sample(&self, wo: Vector, u: [f64; 2]) -> Option<LobeSample> {
        let r = Normal::new(mirrored(wo))?;
        let wi = Frame::around(r).to_world(maps::hemisphere(u, self.exponent));
        if wo.z() <= 0.0 || wi.z() <= 0.0 {
            return None;
        }
        let pdf = self.density(wo, wi);
        let weight = (wi.z() / pdf) * self.formula(wo, wi);
        (pdf > 0.0).then_some(LobeSample { wi, weight, pdf: Some(pdf) })
    }

    /// `∫ f cosθ_i dω_i`, in rings at the angle α from the mirror direction. On a ring that lies
    /// above the horizon the mean of `cosθ_i` is `cosα cosθ_o`; those up to `α_h = π/2 − θ_o` do,
    /// and their integral is `2π cosθ_o (1 − cos^(e+2) α_h)/(e + 2)`. Beyond, the arc `|φ| < φ_h` is
    /// left, and its integral is taken over `y = (cosα/cosα_h)^(e+1)` by the tanh–sinh rule.
    fn albedo(&self, wo: Vector) -> Rgb {
        let (cos_o, e) = (wo.z(), self.exponent);
        if cos_o <= 0.0 {
            return Rgb::BLACK;
        }
        // cosα_h = sinθ_o; its logarithm keeps the digits of powers near 1
        let ln_sin_o = 0.5 * ln_1p(-cos_o.min(1.0) * cos_o.min(1.0));
        let above = -exp_m1((e + 2.0) * ln_sin_o) / (e + 2.0);
        let arc = |ln_y: f64| {
            let ln_q = ln_y / (e + 1.0); // q = cosα/cosα_h
            // sinα sinφ_h = √(1 − q²), sinα cosφ_h = −q cosθ_o
            let across = (-exp_m1(2.0 * ln_q)).sqrt();
            let along = exp(ln_q) * cos_o;
            along * atan2(across, -along) + across
        };
        let beyond = 2.0 * exp((e + 2.0) * ln_sin_o) / (e + 1.0) * tanh_sinh(|y| arc(ln(y)));
        (2.0 * PI * cos_o * above + beyond) * self.reflectance
    }

    fn specimens() -> Vec<Self> {
        let lobe = |ks, exponent| Self { reflectance: Rgb::grey(ks), exponent };
        vec![lobe(0.2, 10.0), lobe(0.25, 0.25), lobe(0.5, 2000.0), lobe(1.0, 0.0)]
    }
}
