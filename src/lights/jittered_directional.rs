//! The jittered directional light (Suffern, ch. 18): a sun with soft shadows, as an approximation.

use super::{Context, Light, LightContext, LightSample, Made, Segment, Specification, made};
use crate::invalid::direction;
use crate::math::{NonNegative, Strength, Vector};
use crate::rgb::Rgb;

/// Light `ls · color` from one direction for each sample, which is moved by at most `jitter` along
/// each axis. An approximation of a sun: the directions fill a cube, not a disk.
#[kind(PartialEq)]
pub struct JitteredDirectional {
    /// Multiplies the colour; not negative.
    #[default(1.0)]
    pub ls: Strength,
    /// The colour of the light.
    #[default(Rgb::WHITE)]
    pub color: Rgb,
    /// From the scene towards the light; not zero, need not be unit.
    pub direction: Vector,
    /// How far the unit direction is moved along each axis, `r` in the book; not negative.
    pub jitter: NonNegative,
}

#[derive(Debug)]
struct JitteredLight {
    radiance: Rgb,
    direction: Vector,
    jitter: f64,
}

impl Specification for JitteredDirectional {
    const FORMULA: &'static str = "\
        adds the mean of what `directional` lights add in the directions direction / |direction| + \
        jitter · (a, b, c), normalised, where a, b and c are independent and uniform from -1 to 1: \
        f(ωi, ωo) · ls · color · cosθ where no object blocks the half-line along ωi.";

    fn make(&self, _: &mut Context) -> Made {
        made(JitteredLight {
            radiance: self.ls * self.color.checked("color")?,
            direction: direction("direction", self.direction)?.into(),
            jitter: self.jitter,
        })
    }
}

impl Light for JitteredLight {
    fn draws(&self) -> usize {
        2
    }

    fn sample(&self, _: &LightContext, u: &[[f64; 2]]) -> Option<LightSample> {
        Some(LightSample {
            direction: (self.direction + self.jitter * in_cube(u)).unit()?,
            segment: Some(Segment::Infinity),
            radiance: self.radiance,
            blocked: Rgb::BLACK,
            pdf: None,
        })
    }
}

/// A point of the cube `[−1, 1]³` for two pairs of numbers in `[0, 1)`, of which three are used.
pub fn in_cube(u: &[[f64; 2]]) -> Vector {
    let along = |u: f64| 2.0 * u - 1.0;
    Vector::new(along(u[0][0]), along(u[0][1]), along(u[1][0]))
}
