//! The directional light (Suffern, ch. 14): parallel rays from infinitely far away.

use std::sync::Arc;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{Illumination, Light, LightSample, Place, Reach};
use crate::invalid::{Invalid, direction, not_negative};
use crate::kinds::{self, Specification};
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
struct Built {
    radiance: Rgb,
    direction: Vector,
}

impl Specification for Directional {
    type Built = Arc<dyn Light>;
    type Context = ();

    fn build(&self, (): &mut ()) -> Result<Arc<dyn Light>, Invalid> {
        Ok(Arc::new(Built {
            radiance: not_negative("ls", self.ls)? * self.color.checked("color")?,
            direction: direction("direction", self.direction)?.into(),
        }))
    }

    fn scaled(&self, _: f64) -> Self {
        self.clone()
    }

    fn specimens() -> Vec<Self> {
        vec![Self { ls: 2.0, color: Rgb::WHITE, direction: Vector::new(15.0, 15.0, 2.5) }]
    }
}

impl Light for Built {
    fn illuminate(&self, _: Place) -> Illumination {
        Illumination::From(LightSample {
            direction: self.direction,
            reach: Reach::Infinity,
            radiance: self.radiance,
            blocked: Rgb::BLACK,
            pdf: 1.0,
        })
    }
}
