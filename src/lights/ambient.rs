//! Ambient light (Suffern, ch. 14).

use std::sync::Arc;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{Context, Light, LightContext, LightSample, Specification};
use crate::invalid::{Invalid, strength};
use crate::kinds;
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
struct Constant {
    radiance: Rgb,
}

impl Specification for Ambient {
    const FORMULA: &'static str = "\
        adds ρa · ls · color, where ρa is the ambient reflectance of the material. Nothing blocks \
        it, and the normal does not matter: the back of a surface gets it too.";

    fn build(&self, _: &mut Context) -> Result<Arc<dyn Light>, Invalid> {
        let radiance = strength("ls", self.ls)? * self.color.checked("color")?;
        Ok(Arc::new(Constant { radiance }))
    }
}

impl Light for Constant {
    fn is_ambient(&self) -> bool {
        true
    }

    fn sample(&self, from: &LightContext, _: &[[f64; 2]]) -> Option<LightSample> {
        Some(LightSample {
            direction: from.normal.into(),
            segment: None,
            radiance: self.radiance,
            blocked: self.radiance,
            pdf: None,
        })
    }
}
