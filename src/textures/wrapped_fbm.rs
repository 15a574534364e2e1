//! The wrapped fBm texture (Suffern, ch. 31): the book's `WrappedFBmTexture`.

use std::sync::Arc;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::noise_field::{self, Expanded, Range, Wrapped};
use super::{Paint, Specification, Texture};
use crate::invalid::Invalid;
use crate::kinds::{self, Resources};
use crate::math::Length;
use crate::noise::Noise;
use crate::rgb::Rgb;

/// The brightness is the fractional part of `noise = expansion · fBm`, mapped to `min` … `max`: it
/// jumps from `max` to `min` along lines where the noise is an integer.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct WrappedFbm {
    /// The noise.
    #[serde(default)]
    pub noise: Noise,
    /// The edge of a cell of the noise lattice, in the unit of the scene; positive.
    #[serde(default = "kinds::one")]
    #[schemars(with = "Length")]
    pub size: f64,
    /// The book's expansion number: the noise has values from 0 to this number; positive.
    #[serde(default = "noise_field::two")]
    pub expansion: f64,
    /// The brightness where the fractional part is 0; not negative.
    #[serde(default)]
    pub min: f64,
    /// The brightness where the fractional part approaches 1; not negative.
    #[serde(default = "kinds::one")]
    pub max: f64,
    /// The colour at brightness 1.
    #[serde(default = "kinds::white::<Paint>")]
    pub color: Paint,
}

impl WrappedFbm {
    /// Black to white, in cells of this size.
    pub fn new(noise: Noise, size: f64, expansion: f64) -> Self {
        Self { noise, size, expansion, min: 0.0, max: 1.0, color: Rgb::WHITE.into() }
    }
}

impl Specification for WrappedFbm {
    fn build(&self, resources: &mut Resources) -> Result<Arc<dyn Texture>, Invalid> {
        Ok(Arc::new(Wrapped {
            noise: Expanded::build(&self.noise, self.size, self.expansion)?,
            range: Range::build(self.min, self.max)?,
            thresholds: Vec::new(),
            colors: vec![self.color.build("color", resources)?],
        }))
    }
}
