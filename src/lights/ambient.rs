//! Ambient light (Suffern, ch. 14).

use super::{Context, Light, LightContext, LightSample, Made, Specification, made};
use crate::math::Strength;
use crate::rgb::Rgb;

/// The same radiance `ls · color` everywhere and from everywhere.
#[kind(PartialEq)]
pub struct Ambient {
    /// Multiplies the colour; not negative.
    #[default(1.0)]
    pub ls: Strength,
    /// The colour of the light.
    #[default(Rgb::WHITE)]
    pub color: Rgb,
}

#[derive(Debug)]
struct ConstantLight {
    radiance: Rgb,
}

impl Specification for Ambient {
    const FORMULA: &'static str = "\
        adds ρa · ls · color, where ρa is the ambient reflectance of the material. Nothing blocks \
        it, and the normal does not matter: the back of a surface gets it too.";

    fn make(&self, _: &mut Context) -> Made {
        let radiance = self.ls * self.color.checked("color")?;
        made(ConstantLight { radiance })
    }
}

impl Light for ConstantLight {
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
