//! Lights: where light comes from, and how much (Suffern, ch. 14, 16–18).
//!
//! A light returns data; it never casts a ray. `trace` tests whether an object blocks the light,
//! the book's `in_shadow`. The book's `G` and `pdf` are one number here, the density per steradian,
//! and its shared sample point is a returned value. A light of some extent draws one point or
//! direction for each sample; the mean over many samples is the light of all of it.

mod ambient;
mod ambient_occluder;
mod area;
mod directional;
mod environment;
mod fake_spherical;
mod jittered_directional;
mod point;
mod spot;

// shared by the kinds
mod context;

use std::fmt::Debug;

use crate::math::{self, Normal, Vector};
use crate::rgb::Rgb;
use crate::shapes::Surface;

pub use context::{Context, LampObject};
pub use jittered_directional::in_cube;
pub use point::from_point;

/// A source of light. Contract: `tests/contracts/light.rs`.
pub trait Light: Debug + Send + Sync {
    /// The number of pairs of random numbers for a sample, at most [`MAX_DRAWS`]: 0 for a single
    /// direction.
    fn draws(&self) -> usize {
        0
    }

    /// Whether it is ambient light in the book's way: reflected by the ambient reflectance of a
    /// material instead of its lobes, and not attenuated by media.
    fn is_ambient(&self) -> bool {
        false
    }

    /// The object whose surface it is, if it has one: that object shines only while the light is
    /// on.
    fn object(&self) -> Option<&str> {
        None
    }

    /// Whether it is the background: what rays that hit nothing see.
    fn is_sky(&self) -> bool {
        false
    }

    /// Whether rays of a path can meet it: it has a surface, or is the sky.
    fn is_met(&self) -> bool {
        self.object().is_some() || self.is_sky()
    }

    /// Light that may arrive at a surface, for [`Light::draws`] pairs of numbers in `[0, 1)`;
    /// `None` if none does.
    fn sample(&self, from: &LightContext, u: &[[f64; 2]]) -> Option<LightSample>;

    /// The density with which [`Light::sample`] draws this point or direction, per steradian; 0 for
    /// a light that is a single direction, which scattered rays never have.
    fn pdf(&self, _from: &LightContext, _to: &Target<'_>) -> f64 {
        0.0
    }
}

/// The most pairs of random numbers that a light may draw; one more panics.
pub const MAX_DRAWS: usize = 4;

/// The data that lights need of a shading point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LightContext {
    /// The point that is lit.
    pub point: math::Point,
    /// The normal used for shading; of a two-sided surface turned to the viewer.
    pub normal: Normal,
}

/// A point or direction that may have been sampled.
#[derive(Clone, Copy, Debug)]
pub enum Target<'a> {
    /// Infinitely far away, in this unit direction.
    Infinity(Vector),
    /// A point of the surface of the light.
    Surface(&'a Surface),
}

/// Light from one direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LightSample {
    /// Unit, towards the light; the normal for light that is equal from all directions.
    pub direction: Vector,
    /// The segment that must be unblocked; `None` if nothing can block the light.
    pub segment: Option<Segment>,
    /// The radiance that arrives if it is unblocked.
    pub radiance: Rgb,
    /// The radiance that arrives if it is blocked.
    pub blocked: Rgb,
    /// The density per steradian; `None` for a single direction.
    pub pdf: Option<f64>,
}

/// The segment from a surface towards a light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Segment {
    /// Without end: every object in the direction blocks it.
    Infinity,
    /// Up to this point: objects behind it do not block it.
    To(math::Point),
}

impl Segment {
    /// Its length from this point.
    pub fn length(self, from: math::Point) -> f64 {
        match self {
            Self::Infinity => f64::INFINITY,
            Self::To(end) => end.distance(from),
        }
    }
}

crate::kinds! {
    /// Where light comes from, and how much.
    Kind builds dyn Light with Context;
    ch14 ambient::Ambient,
    ch14 directional::Directional,
    ch14 point::PointLight as "point",
    ch14 spot::Spot,
    ch17 ambient_occluder::AmbientOccluder,
    ch18 area::Area,
    ch18 environment::Environment,
    ch18 jittered_directional::JitteredDirectional,
    ch18 fake_spherical::FakeSpherical,
}
