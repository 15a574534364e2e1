//! The events of each ray, and the recorders that receive them.
//!
//! Events name lights and objects by their indices in the scene; what records them adds the names.

use serde::Serialize;

use super::ShadingPoint;
use crate::lobes::{Lobe, Lobes};
use crate::math::{Ray, Span};
use crate::rgb::Rgb;
use crate::world::Search;

/// The purpose of a ray.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum RayKind {
    /// From the eye.
    Camera,
    /// Scattered to the side it came from: mirrored, or a bounce of a path.
    Reflected,
    /// Refracted.
    Transmitted,
    /// Towards a light.
    Shadow {
        /// The light.
        #[serde(skip)]
        light: u32,
    },
}

/// The outcome of a ray.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(tag = "outcome", rename_all = "snake_case")]
pub enum Outcome {
    /// It met a surface.
    Hit,
    /// It met nothing.
    Background,
    /// It was not cast: deeper than `max_depth`.
    TooDeep,
    /// It was not cast: the budget of rays was spent.
    OverBudget,
    /// A shadow ray that reached its light.
    Unblocked {
        /// The number of transparent surfaces it passed.
        boundaries: u32,
    },
    /// A shadow ray that met an object.
    Blocked {
        /// The object; there may be others.
        #[serde(skip)]
        blocked_by: u32,
    },
}

/// A term of what leaves a surface: `value = weight · arriving`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Term {
    /// Where it comes from.
    pub source: TermSource,
    /// What the arriving light is multiplied by.
    pub weight: Rgb,
    /// The light that arrives.
    pub arriving: Rgb,
    /// Its contribution, `weight · arriving`.
    pub value: Rgb,
}

/// The source of a term.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(tag = "source", rename_all = "snake_case")]
pub enum TermSource {
    /// The background.
    Background {
        /// The MIS weight, if the sky is also sampled: it is the term's weight.
        #[serde(skip_serializing_if = "Option::is_none")]
        mis: Option<f64>,
    },
    /// The surface itself shines.
    Emission {
        /// The MIS weight, if the lamp is also sampled: it is the term's weight.
        #[serde(skip_serializing_if = "Option::is_none")]
        mis: Option<f64>,
    },
    /// A light that meets the ambient reflectance.
    Ambient {
        /// The light.
        #[serde(skip)]
        light: u32,
        /// Whether the shadow ray before it says what arrives.
        traced: bool,
    },
    /// Light straight from a source, scattered by one lobe: the weight is `f cosθ_i / pdf`.
    Direct {
        /// The light.
        #[serde(skip)]
        light: u32,
        /// The lobe, with its reflectance.
        lobe: Lobe,
        /// The value of the lobe for this light and viewer, per steradian.
        f: Rgb,
        /// The cosine of the light's angle to the normal.
        cos_i: f64,
        /// Of the direction, per steradian; `None` for a light that is a single direction, whose
        /// weight is `f cosθ_i`.
        #[serde(skip_serializing_if = "Option::is_none")]
        pdf: Option<f64>,
        /// The MIS weight, if scattered rays can also hit the light; it is a factor of the term's
        /// weight.
        #[serde(skip_serializing_if = "Option::is_none")]
        mis: Option<f64>,
        /// Whether the shadow ray before it says what arrives.
        traced: bool,
    },
    /// Light along the ray before it: the weight is
    /// `f cosθ_i / (pdf · lobe_probability · survival)`.
    Traced {
        /// The lobe that sent the ray.
        lobe: Lobe,
        /// The density with which the lobe draws the direction, per steradian; `None` for a single
        /// direction.
        #[serde(skip_serializing_if = "Option::is_none")]
        pdf: Option<f64>,
        /// The probability with which the path took this lobe; 1 where each lobe is followed.
        lobe_probability: f64,
        /// The probability with which the path went on at all (Russian roulette).
        survival: f64,
    },
    /// The light of a light's sample along a shadow ray.
    Light {
        /// The light.
        #[serde(skip)]
        light: u32,
    },
}

/// Receives the events of every ray. It cannot change the picture. `()` costs nothing.
pub trait Recorder {
    /// A ray begins; the ray before it multiplies its radiance by `weight`.
    fn enter(&mut self, kind: RayKind, ray: &Ray, depth: u32, weight: Rgb);
    /// A search along it, or along a part of it: a shadow ray that passes transparent surfaces
    /// needs several.
    #[inline(always)]
    fn search(&mut self, _search: Search, _ray: &Ray, _span: Span) {}
    /// The surface that it hit, with its lobes.
    #[inline(always)]
    fn hit(&mut self, _point: &ShadingPoint<'_>, _lobes: &Lobes) {}
    /// Two random numbers are drawn.
    #[inline(always)]
    fn draw(&mut self) {}
    /// A term of its sum, in the order of addition.
    fn term(&mut self, term: Term);
    /// It ends so, with the transmittance of its medium and the radiance that arrives at its
    /// origin.
    fn leave(&mut self, outcome: Outcome, transmittance: Rgb, arriving: Rgb);
}

/// Records nothing.
impl Recorder for () {
    #[inline(always)]
    fn enter(&mut self, _: RayKind, _: &Ray, _: u32, _: Rgb) {}
    #[inline(always)]
    fn term(&mut self, _: Term) {}
    #[inline(always)]
    fn leave(&mut self, _: Outcome, _: Rgb, _: Rgb) {}
}

/// Counts rays, those that were too deep to be cast among them.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct RayCounts {
    /// From the eye.
    pub camera: u64,
    /// Scattered to the side they came from: mirrored, or the bounces of a path.
    pub reflected: u64,
    /// Refracted.
    pub transmitted: u64,
    /// Towards lights.
    pub shadow: u64,
    /// Of `reflected` and `transmitted`, those deeper than the tracer's `max_depth`: black, and not
    /// cast. The light samples that a path leaves out at its last hit are in no count.
    pub too_deep: u64,
    /// Pairs of random numbers drawn, without those of the camera.
    pub draws: u64,
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

    fn draw(&mut self) {
        self.draws += 1;
    }

    fn term(&mut self, _: Term) {}

    fn leave(&mut self, outcome: Outcome, _: Rgb, _: Rgb) {
        self.too_deep += u64::from(outcome == Outcome::TooDeep);
    }
}

/// Two recorders hear the same.
impl<A: Recorder, B: Recorder> Recorder for (A, B) {
    fn enter(&mut self, kind: RayKind, ray: &Ray, depth: u32, weight: Rgb) {
        self.0.enter(kind, ray, depth, weight);
        self.1.enter(kind, ray, depth, weight);
    }

    fn search(&mut self, search: Search, ray: &Ray, span: Span) {
        self.0.search(search, ray, span);
        self.1.search(search, ray, span);
    }

    fn hit(&mut self, point: &ShadingPoint<'_>, lobes: &Lobes) {
        self.0.hit(point, lobes);
        self.1.hit(point, lobes);
    }

    fn draw(&mut self) {
        self.0.draw();
        self.1.draw();
    }

    fn term(&mut self, term: Term) {
        self.0.term(term);
        self.1.term(term);
    }

    fn leave(&mut self, outcome: Outcome, transmittance: Rgb, arriving: Rgb) {
        self.0.leave(outcome, transmittance, arriving);
        self.1.leave(outcome, transmittance, arriving);
    }
}
