//! The directional light (Suffern, ch. 14): parallel rays from infinitely far away.

use std::sync::Arc;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{Context, Light, LightContext, LightSample, Segment, Specification};
use crate::invalid::{Invalid, direction, strength};
use crate::kinds;
use crate::math::Vector;
use crate::rgb::Rgb;

/// Light `ls · color` from one direction.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Directional {
    /// Multiplies the colour; not negative.
    #[serde(default = "kinds::one")]
    pub ls: f64,
    /// The colour of the light.
    #[serde(default = "kinds::white::<Rgb>")]
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

    fn build(&self, _: &mut Context) -> Result<Arc<dyn Light>, Invalid> {
        Ok(Arc::new(Parallel {
            radiance: strength("ls", self.ls)? * self.color.checked("color")?,
            direction: direction("direction", self.direction)?.into(),
        }))
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
