//! Glossy reflection (Suffern, ch. 25): a mirror that blurs.

use std::f64::consts::PI;

use super::{Branch, Claims, LobeSample, Scattering, cosine_power, drawn};
use crate::invalid::Invalid;
use crate::math::Vector;
use crate::rgb::Rgb;

/// Light from about the mirror direction, with the density `p` of a cosine power; rays are traced
/// for it.
#[kind(Copy, PartialEq)]
pub struct GlossyReflection {
    /// `k_r c_r`.
    pub reflectance: Rgb,
    /// `e`, not negative.
    pub exponent: f64,
    /// What a ray's light counts.
    pub rule: GlossyRule,
}

/// What the light along a ray of glossy reflection counts.
#[kind(Default)]
#[schemars(title = "rules of glossy reflection")]
pub enum GlossyRule {
    /// The reflectance, as in the book: `f = k_r c_r p(ω_i)/cosθ_i`. A ray that would go below the
    /// surface is turned half around the mirror direction. Not reciprocal.
    #[default]
    Book,
    /// `f = k_r c_r (e + 2)/2π (r·ω_o)^e`: reciprocal, and darker: a narrow lobe reflects about
    /// `k_r c_r cosθ_o` of uniform light, where a mirror reflects `k_r c_r` (Lafortune & Willems,
    /// "Using the Modified Phong Reflectance Model for Physically Based Rendering", 1994).
    Normalised,
}

impl GlossyReflection {
    /// Whether a direction was perhaps one below the surface, turned half around the mirror
    /// direction.
    fn is_doubled(wo: Vector, wi: Vector) -> bool {
        let r = super::mirrored(wo);
        let other = 2.0 * r.dot(wi) * r - wi;
        other.z() <= 0.0
    }
}

impl Scattering for GlossyReflection {
    const BRANCH: Branch = Branch::Gloss;

    fn claims(&self) -> Claims {
        Claims { reciprocal: self.rule == GlossyRule::Normalised, conserves_energy: true }
    }

    fn check(&self) -> Result<(), Invalid> {
        cosine_power::check_exponent(self.exponent)?;
        self.reflectance.checked("reflectance").map(drop)
    }

    fn formula(&self, wo: Vector, wi: Vector) -> Rgb {
        match self.rule {
            GlossyRule::Book => (self.density(wo, wi) / wi.z()) * self.reflectance,
            GlossyRule::Normalised => {
                let scale = (self.exponent + 2.0) / (2.0 * PI);
                (scale * cosine_power::value(self.exponent, wo, wi)) * self.reflectance
            }
        }
    }

    /// By the book's rule every direction above the surface counts for itself and, if that lies
    /// below, for the one opposite it.
    fn density(&self, wo: Vector, wi: Vector) -> f64 {
        let density = cosine_power::density(self.exponent, wo, wi);
        let doubled = self.rule == GlossyRule::Book && Self::is_doubled(wo, wi);
        if doubled { 2.0 * density } else { density }
    }

    fn selection_weight(&self, _: Vector) -> f64 {
        self.reflectance.average()
    }

    fn sample(&self, wo: Vector, u: [f64; 2]) -> Option<LobeSample> {
        let [first, turned] = cosine_power::sample(self.exponent, wo, u)?;
        let wi = match self.rule {
            GlossyRule::Book if first.z() <= 0.0 => turned,
            _ => first,
        };
        drawn(self, wo, wi)
    }

    /// By the book's rule all of the reflectance: of a direction and the one opposite it about r,
    /// at least one lies above the surface.
    fn albedo(&self, wo: Vector) -> Rgb {
        if wo.z() <= 0.0 {
            return Rgb::BLACK;
        }
        match self.rule {
            GlossyRule::Book => self.reflectance,
            GlossyRule::Normalised => {
                let scale = (self.exponent + 2.0) / (2.0 * PI);
                (scale * cosine_power::integral(self.exponent, wo.z())) * self.reflectance
            }
        }
    }

    fn specimens() -> Vec<Self> {
        let lobe =
            |kr, exponent, rule| Self { reflectance: Rgb::new(kr, 0.5 * kr, kr), exponent, rule };
        vec![
            lobe(0.8, 10.0, GlossyRule::Book),
            lobe(1.0, 100.0, GlossyRule::Normalised),
            lobe(1.0, 1.0, GlossyRule::Book),
            lobe(1.0, 1.0, GlossyRule::Normalised),
        ]
    }
}
