//! The directional light (Suffern, ch. 14): parallel rays from infinitely far away.

use super::{Context, Light, LightContext, LightSample, Made, Segment, Specification, made};
use crate::invalid::direction;
use crate::math::{Strength, Vector};
use crate::rgb::Rgb;

/// Light `ls · color` from one direction.
#[kind(PartialEq)]
pub struct Directional {
    /// Multiplies the colour; not negative.
    #[default(1.0)]
    pub ls: Strength,
    /// The colour of the light.
    #[default(Rgb::WHITE)]
    pub color: Rgb,
    /// From the scene towards the light; not zero, need not be unit.
    pub direction: Vector,
}

#[derive(Debug)]
struct Parallel {
    radiance: Rgb,
    direction: Vector,
}

impl Specification for Directional {
    const FORMULA: &'static str = "\
        adds f(ωi, ωo) · ls · color · cosθ with ωi = direction / |direction|, unless an object \
        blocks the half-line from the hit along ωi.";

    fn make(&self, _: &mut Context) -> Made {
        made(Parallel {
            radiance: self.ls * self.color.checked("color")?,
            direction: direction("direction", self.direction)?.into(),
        })
    }
}

impl Light for Parallel {
    fn sample(&self, _: &LightContext, _: &[[f64; 2]]) -> Option<LightSample> {
        Some(LightSample {
            direction: self.direction,
            segment: Some(Segment::Infinity),
            radiance: self.radiance,
            blocked: Rgb::BLACK,
            pdf: None,
        })
    }
}
