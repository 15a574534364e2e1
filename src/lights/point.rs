//! The point light (Suffern, ch. 14), with the distance attenuation of its exercises.

use super::{Context, Light, LightContext, LightSample, Made, Segment, Specification, made};
use crate::math::{NonNegative, Point, Strength, power};
use crate::rgb::Rgb;

/// Light `ls · color / d^k` from one place, `d` the distance.
#[kind(PartialEq)]
pub struct PointLight {
    /// Multiplies the colour; not negative.
    #[default(1.0)]
    #[schemars(extend("x-dimension" = "length^attenuation"))]
    pub ls: Strength,
    /// The colour of the light.
    #[default(Rgb::WHITE)]
    pub color: Rgb,
    /// Where it is.
    pub location: Point,
    /// The exponent `k` of the distance, not negative: 0, the book's default, for the same light at
    /// every distance; 2 for real lamps, whose `ls` must then be as large as the distance squared.
    #[default]
    pub attenuation: NonNegative,
}

#[derive(Debug)]
struct PointSource {
    radiance: Rgb,
    location: Point,
    attenuation: f64,
}

impl Specification for PointLight {
    const FORMULA: &'static str = "\
        adds f(ωi, ωo) · ls · color / d^attenuation · cosθ, where ωi leads from the hit to \
        `location` and d is its distance, unless an object blocks that segment. So with \
        attenuation 0 the light does not weaken with distance; nothing is divided by 4π or by π \
        beyond what f has.";

    fn make(&self, _: &mut Context) -> Made {
        made(PointSource {
            radiance: self.ls * self.color.checked("color")?,
            location: self.location,
            attenuation: self.attenuation,
        })
    }
}

impl Light for PointSource {
    fn sample(&self, from: &LightContext, _: &[[f64; 2]]) -> Option<LightSample> {
        from_point(from.point, self.location, self.radiance, self.attenuation)
    }
}

/// Light `radiance / d^k` from one place; none at the place itself, where it has no direction, or
/// so near that it would be infinite.
pub fn from_point(
    from: Point,
    location: Point,
    radiance: Rgb,
    attenuation: f64,
) -> Option<LightSample> {
    let to_light = location - from;
    let radiance = match attenuation {
        0.0 => radiance,
        k => radiance / power(to_light.length(), k),
    };
    if !radiance.to_array().iter().all(|channel| channel.is_finite()) {
        return None;
    }
    Some(LightSample {
        direction: to_light.unit()?,
        segment: Some(Segment::To(location)),
        radiance,
        blocked: Rgb::BLACK,
        pdf: None,
    })
}
