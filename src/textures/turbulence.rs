//! The turbulence texture (Suffern, ch. 31): the book's `TurbulenceTexture`.

use std::sync::Arc;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::noise_field::{NoiseField, Range};
use super::{Color, Paint, Specification, Texture, TexturePoint};
use crate::invalid::Invalid;
use crate::kinds::{self, Resources};
use crate::math::Length;
use crate::noise::Noise;
use crate::rgb::Rgb;

/// Turbulence as brightness: `min + (max − min) turbulence` times a colour. It has dark veins where
/// the noise changes sign.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Turbulence {
    /// The noise; gain and lacunarity are not used.
    #[serde(default)]
    pub noise: Noise,
    /// The edge of a cell of the noise lattice, in the unit of the scene; positive.
    #[serde(default = "kinds::one")]
    #[schemars(with = "Length")]
    pub size: f64,
    /// The brightness where the turbulence is 0; not negative.
    #[serde(default)]
    pub min: f64,
    /// The brightness where the turbulence is 1; not negative. It may be above 1, because few
    /// points have a turbulence near 1.
    #[serde(default = "kinds::one")]
    pub max: f64,
    /// The colour at brightness 1.
    #[serde(default = "kinds::white::<Paint>")]
    pub color: Paint,
}

impl Turbulence {
    /// Black to white, in cells of this size.
    pub fn new(noise: Noise, size: f64) -> Self {
        Self { noise, size, min: 0.0, max: 1.0, color: Rgb::WHITE.into() }
    }
}

#[derive(Debug)]
struct TurbulenceTexture {
    field: NoiseField,
    range: Range,
    color: Color,
}

impl Specification for Turbulence {
    fn build(&self, resources: &mut Resources) -> Result<Arc<dyn Texture>, Invalid> {
        Ok(Arc::new(TurbulenceTexture {
            field: NoiseField::build(&self.noise, self.size)?,
            range: Range::build(self.min, self.max)?,
            color: self.color.build("color", resources)?,
        }))
    }
}

impl Texture for TurbulenceTexture {
    fn color(&self, at: &TexturePoint<'_>) -> Rgb {
        let value = self.range.scaled(self.field.noise.value_turbulence(self.field.point(at)));
        value * self.color.at(at)
    }
}
