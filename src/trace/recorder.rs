//! Who listens to the recursion.

use serde::Serialize;

use crate::math::Ray;
use crate::rgb::Rgb;
use crate::world::{Hit, PlacedObject};

/// What a ray is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum RayKind {
    /// From the eye.
    Camera,
    /// Mirrored.
    Reflected,
    /// Refracted.
    Transmitted,
    /// Towards a light.
    Shadow {
        /// The light's place in the scene.
        light: u32,
    },
}

/// What became of a ray.
#[derive(Clone, Copy, Debug)]
pub enum Outcome<'a> {
    /// It met a surface.
    Hit(&'a Hit<'a>),
    /// It met nothing.
    Background,
    /// It was beyond the largest depth and not cast.
    TooDeep,
    /// A shadow ray that reached its light.
    Unblocked,
    /// A shadow ray that met this object (there may be others).
    Blocked(&'a PlacedObject),
}

/// A term of what leaves a surface: `value = weight · light`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Term {
    /// Where it comes from.
    pub what: What,
    /// What the light is multiplied by.
    pub weight: Rgb,
    /// What it adds.
    pub value: Rgb,
}

/// Where a term comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum What {
    /// The background.
    Background,
    /// The surface itself shines.
    Emission,
    /// An ambient light.
    Ambient {
        /// Its place in the scene.
        light: u32,
    },
    /// Light straight from a source, by one lobe.
    Direct {
        /// The light's place in the scene.
        light: u32,
        /// The lobe.
        lobe: &'static str,
        /// Whether the shadow ray before it says what arrives.
        traced: bool,
    },
    /// Light along the ray before it.
    Traced {
        /// The lobe that sent the ray.
        lobe: &'static str,
    },
    /// What a light sends along a shadow ray.
    Light {
        /// Its place in the scene.
        light: u32,
    },
}

/// Hears every ray. It cannot change the picture, and `()` costs nothing.
pub trait Recorder {
    /// A ray begins; it counts `weight` for the ray before it.
    fn enter(&mut self, kind: RayKind, ray: &Ray, depth: u32, weight: Rgb);
    /// What became of it.
    fn outcome(&mut self, outcome: Outcome<'_>);
    /// A term of its sum; terms come in the order in which they are added.
    fn term(&mut self, term: Term);
    /// It ends: what its medium lets through, and what arrives at its origin.
    fn leave(&mut self, transmittance: Rgb, arriving: Rgb);
}

/// Nobody listens.
impl Recorder for () {
    #[inline(always)]
    fn enter(&mut self, _: RayKind, _: &Ray, _: u32, _: Rgb) {}
    #[inline(always)]
    fn outcome(&mut self, _: Outcome<'_>) {}
    #[inline(always)]
    fn term(&mut self, _: Term) {}
    #[inline(always)]
    fn leave(&mut self, _: Rgb, _: Rgb) {}
}

/// Counts rays.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct RayCounts {
    /// From the eye.
    pub camera: u64,
    /// Mirrored.
    pub reflected: u64,
    /// Refracted.
    pub transmitted: u64,
    /// Towards lights.
    pub shadow: u64,
    /// Not cast, because they were too deep; not in the other counts.
    pub too_deep: u64,
}

impl Recorder for RayCounts {
    fn enter(&mut self, kind: RayKind, _: &Ray, _: u32, _: Rgb) {
        match kind {
            RayKind::Camera => self.camera += 1,
            RayKind::Reflected => self.reflected += 1,
            RayKind::Transmitted => self.transmitted += 1,
            RayKind::Shadow { .. } => self.shadow += 1,
        }
    }

    fn outcome(&mut self, outcome: Outcome<'_>) {
        if matches!(outcome, Outcome::TooDeep) {
            self.too_deep += 1;
        }
    }

    fn term(&mut self, _: Term) {}

    fn leave(&mut self, _: Rgb, _: Rgb) {}
}
