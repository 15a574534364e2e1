//! The point light (Suffern, ch. 14), with the distance attenuation of its exercises.

use std::sync::Arc;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{Context, Light, LightContext, LightSample, Segment, Specification, Unlit};
use crate::invalid::{Invalid, finite_point, not_negative, strength};
use crate::kinds;
use crate::math::{Point, power};
use crate::rgb::Rgb;

/// Light `ls · color / d^k` from one place, `d` the distance.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PointLight {
    /// Multiplies the colour; not negative.
    #[serde(default = "kinds::one")]
    #[schemars(extend("x-dimension" = "length^attenuation"))]
    pub ls: f64,
    /// The colour of the light.
    #[serde(default = "kinds::white::<Rgb>")]
    pub color: Rgb,
    /// Where it is.
    pub location: Point,
    /// The exponent `k` of the distance, not negative: 0, the book's default, for the same light at
    /// every distance; 2 for real lamps, whose `ls` must then be as large as the distance squared.
    #[serde(default)]
    pub attenuation: f64,
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

    fn build(&self, _: &mut Context) -> Result<Arc<dyn Light>, Invalid> {
        Ok(Arc::new(PointSource {
            radiance: strength("ls", self.ls)? * self.color.checked("color")?,
            location: finite_point("location", self.location)?,
            attenuation: not_negative("attenuation", self.attenuation)?,
        }))
    }
}

impl Light for PointSource {
    fn sample(&self, from: &LightContext, _: &[[f64; 2]]) -> Option<LightSample> {
        from_point(from.point, self.location, self.radiance, self.attenuation)
    }

    fn unlit(&self, from: &LightContext, _: &[[f64; 2]]) -> Unlit {
        Unlit::AtLight { distance: from.point.distance(self.location) }
    }
}

/// Light `radiance / d^k` from one place; none at the place itself, where it has no direction, or
/// so near that it would be infinite.
pub(super) fn from_point(
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
