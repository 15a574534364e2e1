//! The fake spherical light (Suffern, ch. 18): a jittered point light.

use super::jittered_directional::in_cube;
use super::point::from_point;
use super::{Context, Light, LightContext, LightSample, Made, Specification, made};
use crate::math::{self, NonNegative, Strength, Width};
use crate::rgb::Rgb;

/// Light `ls · color / d^k` from one place for each sample, which is moved by at most `jitter`
/// along each axis. An approximation of a spherical lamp, from before there were area lights: the
/// places fill a cube, and none of them is seen.
#[kind(PartialEq)]
pub struct FakeSpherical {
    /// Multiplies the colour; not negative.
    #[default(1.0)]
    #[schemars(extend("x-dimension" = "length^attenuation"))]
    pub ls: Strength,
    /// The colour of the light.
    #[default(Rgb::WHITE)]
    pub color: Rgb,
    /// The middle of the places.
    pub location: math::Point,
    /// How far a place is from the middle along each axis at most, `r` in the book; not negative.
    pub jitter: Width,
    /// The exponent `k` of the distance, not negative; as of `point`.
    #[default]
    pub attenuation: NonNegative,
}

#[derive(Debug)]
struct JitteredPoint {
    radiance: Rgb,
    location: math::Point,
    jitter: f64,
    attenuation: f64,
}

impl Specification for FakeSpherical {
    const FORMULA: &'static str = "\
        adds the mean of what `point` lights add at the points location + jitter · (a, b, c), \
        where a, b and c are independent and uniform from -1 to 1: f(ωi, ωo) · ls · color / \
        d^attenuation · cosθ where no object blocks the segment of length d.";

    fn make(&self, _: &mut Context) -> Made {
        made(JitteredPoint {
            radiance: self.ls * self.color.checked("color")?,
            location: self.location,
            jitter: self.jitter,
            attenuation: self.attenuation,
        })
    }
}

impl Light for JitteredPoint {
    fn draws(&self) -> usize {
        2
    }

    fn sample(&self, from: &LightContext, u: &[[f64; 2]]) -> Option<LightSample> {
        let drawn = self.location + self.jitter * in_cube(u);
        from_point(from.point, drawn, self.radiance, self.attenuation)
    }
}
