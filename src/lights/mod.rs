//! Lights: where light comes from, and how much (Suffern, ch. 14, 16).
//!
//! A light answers with data; it never casts a ray. Whether something stands in the way is for
//! `trace` to find out.

mod ambient;
mod directional;
mod point;

use std::fmt::Debug;

use crate::math::{Point as Place, Vector};
use crate::rgb::Rgb;

/// A source of light. Contract: `tests/contracts/light.rs`.
pub trait Light: Debug + Send + Sync {
    /// The light that may arrive at a place.
    fn illuminate(&self, from: Place) -> Illumination;
}

/// What a light says it sends to a place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Illumination {
    /// The same from everywhere: it meets the ambient reflectance of a material, without a ray.
    Ambient(Rgb),
    /// From one direction.
    From(LightSample),
}

/// Light from one direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LightSample {
    /// Unit, towards the light.
    pub direction: Vector,
    /// Up to where an object is in the way.
    pub reach: Reach,
    /// What arrives if nothing is in the way.
    pub radiance: Rgb,
    /// What arrives if something is.
    pub blocked: Rgb,
    /// Per steradian; 1 for a light that is a single direction.
    pub pdf: f64,
}

/// How far away a light is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Reach {
    /// Infinitely far: every object in that direction is in the way.
    Infinity,
    /// At this place: objects behind it are not in the way.
    To(Place),
}

crate::kinds! {
    /// Where light comes from, and how much.
    Kind builds dyn Light with ();
    ch14 ambient::Ambient,
    ch14 directional::Directional,
    ch14 point::Point,
}
