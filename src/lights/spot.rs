//! The spot light: not in the book.

use super::point::from_point;
use super::{Context, Light, LightContext, LightSample, Made, Specification, made};
use crate::invalid::{direction, within};
use crate::math::{self, NonNegative, Normal, Strength, Vector, atan2, to_degrees};
use crate::rgb::Rgb;

/// A point light that shines into a cone: all of `ls · color / d^k` up to `inner` degrees from its
/// axis, none from `outer` on, and a smooth step between.
#[kind(PartialEq)]
pub struct Spot {
    /// Multiplies the colour; not negative.
    #[default(1.0)]
    #[schemars(extend("x-dimension" = "length^attenuation"))]
    pub ls: Strength,
    /// The colour of the light.
    #[default(Rgb::WHITE)]
    pub color: Rgb,
    /// Where it is.
    pub location: math::Point,
    /// Where it shines to; not zero, need not be unit.
    pub direction: Vector,
    /// From this angle to the axis on it grows weaker, in degrees; from 0 to `outer`.
    pub inner: f64,
    /// From this angle to the axis on it is dark, in degrees; at most 180. If it equals `inner`,
    /// the edge is sharp.
    pub outer: f64,
    /// The exponent `k` of the distance, not negative; as of `point`.
    #[default]
    pub attenuation: NonNegative,
}

#[derive(Debug)]
struct SpotCone {
    radiance: Rgb,
    location: math::Point,
    axis: Normal,
    inner: f64,
    outer: f64,
    attenuation: f64,
}

impl Specification for Spot {
    const FORMULA: &'static str = "\
        adds f(ωi, ωo) · s² (3 - 2 s) · ls · color / d^attenuation · cosθ, where ωi leads from the \
        hit to `location` and d is its distance, unless an object blocks that segment. With the \
        angle α in degrees between -ωi and `direction`, s is 1 for α ≤ inner, 0 for α ≥ outer, and \
        (outer - α) / (outer - inner) between.";

    fn make(&self, _: &mut Context) -> Made {
        let outer = within("outer", self.outer, 0.0..=180.0)?;
        made(SpotCone {
            radiance: self.ls * self.color.checked("color")?,
            location: self.location,
            axis: direction("direction", self.direction)?,
            inner: within("inner", self.inner, 0.0..=outer)?,
            outer,
            attenuation: self.attenuation,
        })
    }
}

impl SpotCone {
    /// The share of light that goes into this direction: `s² (3 − 2s)`, s from 1 at `inner` to 0 at
    /// `outer`.
    fn share(&self, direction: Vector) -> f64 {
        let across = Vector::from(self.axis).cross(direction).length();
        let angle = to_degrees(atan2(across, self.axis.dot(direction)));
        if angle <= self.inner {
            return 1.0;
        }
        if angle >= self.outer {
            return 0.0;
        }
        let s = (self.outer - angle) / (self.outer - self.inner);
        s * s * (3.0 - 2.0 * s)
    }
}

impl Light for SpotCone {
    fn sample(&self, from: &LightContext, _: &[[f64; 2]]) -> Option<LightSample> {
        let sample = from_point(from.point, self.location, self.radiance, self.attenuation)?;
        let share = self.share(-sample.direction);
        (share > 0.0).then(|| LightSample { radiance: share * sample.radiance, ..sample })
    }
}
