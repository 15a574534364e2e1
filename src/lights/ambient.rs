//! Ambient light (Suffern, ch. 14).

use std::sync::Arc;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{Illumination, Light, Place};
use crate::invalid::{Invalid, not_negative};
use crate::kinds::{self, Specification};
use crate::rgb::Rgb;

/// The same radiance `ls · color` everywhere and from everywhere.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Ambient {
    /// Multiplies the colour; not negative.
    #[serde(default = "kinds::one")]
    pub ls: f64,
    /// The colour of the light.
    #[serde(default = "kinds::white::<Rgb>")]
    pub color: Rgb,
}

#[derive(Debug)]
struct Built {
    radiance: Rgb,
}

impl Specification for Ambient {
    type Built = Arc<dyn Light>;
    type Context = ();

    fn build(&self, (): &mut ()) -> Result<Arc<dyn Light>, Invalid> {
        let radiance = not_negative("ls", self.ls)? * self.color.checked("color")?;
        Ok(Arc::new(Built { radiance }))
    }

    fn scaled(&self, _: f64) -> Self {
        self.clone()
    }

    fn specimens() -> Vec<Self> {
        vec![Self { ls: 0.25, color: Rgb::new(1.0, 0.5, 0.75) }]
    }
}

impl Light for Built {
    fn illuminate(&self, _: Place) -> Illumination {
        Illumination::Ambient(self.radiance)
    }
}
