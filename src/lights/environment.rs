//! The environment light (Suffern, ch. 18): the sky.

use std::f64::consts::PI;
use std::sync::Arc;

use super::{
    Context, Light, LightContext, LightSample, Made, Segment, Specification, Target, made,
};
use crate::background::{Directions, ImageSky, Sky};
use crate::invalid::Invalid;
use crate::math::{Frame, maps};
use crate::rgb::Rgb;

/// The light of the scene's `background`, from all sides: directions are drawn by the cosine for a
/// colour, for an image texels in proportion to their radiance and within a texel all points alike.
/// It has no radiance of its own, so that the sky is written once. Switched off, the sky is still
/// seen. (The book's light has a material, and a huge sphere of it is the sky.)
#[kind(PartialEq)]
pub struct Environment {}

/// A sky of one colour, sampled by the cosine.
#[derive(Debug)]
struct Uniform {
    color: Rgb,
}

/// A sky by image, sampled by its radiance.
#[derive(Debug)]
struct Imaged {
    sky: Arc<ImageSky>,
    directions: Directions,
}

impl Specification for Environment {
    const FORMULA: &'static str = "\
        adds the integral of f(ωi, ωo) · B(ωi) · cosθ over the hemisphere of directions in which \
        nothing is hit, where B is the background. Each sample draws one direction; how it is \
        drawn changes the noise only.";

    fn make(&self, context: &mut Context) -> Made {
        match &context.background {
            Sky::Color(color) => made(Uniform { color: *color }),
            Sky::Image(sky) => {
                let directions = Directions::new(sky);
                made(Imaged { sky: Arc::clone(sky), directions })
            }
            Sky::Sinusoid(_) => {
                let problem = "the background depends on where a ray starts, so it is no sky; a \
                               colour is one";
                Err(Invalid::new(problem))
            }
        }
    }
}

impl Light for Uniform {
    fn is_sky(&self) -> bool {
        true
    }

    fn draws(&self) -> usize {
        1
    }

    /// Cosine-distributed about the normal.
    fn sample(&self, from: &LightContext, u: &[[f64; 2]]) -> Option<LightSample> {
        let direction = Frame::around(from.normal).to_world(maps::hemisphere(u[0], 1.0));
        let pdf = from.normal.dot(direction) / PI;
        (pdf > 0.0).then_some(LightSample {
            direction,
            segment: Some(Segment::Infinity),
            radiance: self.color,
            blocked: Rgb::BLACK,
            pdf: Some(pdf),
        })
    }

    fn pdf(&self, from: &LightContext, to: &Target<'_>) -> f64 {
        match to {
            Target::Infinity(direction) => from.normal.dot(*direction).max(0.0) / PI,
            Target::Surface(_) => 0.0,
        }
    }
}

impl Light for Imaged {
    fn is_sky(&self) -> bool {
        true
    }

    fn draws(&self) -> usize {
        1
    }

    /// From the whole sky, independent of the normal: light may also come through the surface.
    fn sample(&self, _: &LightContext, u: &[[f64; 2]]) -> Option<LightSample> {
        let direction = self.directions.sample(u[0])?;
        let pdf = self.directions.pdf(direction);
        (pdf > 0.0).then(|| LightSample {
            direction,
            segment: Some(Segment::Infinity),
            radiance: self.sky.radiance(direction),
            blocked: Rgb::BLACK,
            pdf: Some(pdf),
        })
    }

    fn pdf(&self, _: &LightContext, to: &Target<'_>) -> f64 {
        match to {
            Target::Infinity(direction) => self.directions.pdf(*direction),
            Target::Surface(_) => 0.0,
        }
    }
}
