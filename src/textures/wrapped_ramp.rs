//! Wrapped noise with the colours of a ramp (Suffern, ch. 31): the book's `WrappedRamp`.

use std::sync::Arc;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::color_table::{ColorTable, Columns};
use super::noise_field::{self, Expanded};
use super::{Specification, Texture, TexturePoint};
use crate::invalid::Invalid;
use crate::kinds::{self, Resources};
use crate::math::Length;
use crate::noise::Noise;
use crate::rgb::Rgb;

/// The colour of a ramp at the fractional part of `expansion · fBm`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct WrappedRamp {
    /// The colours.
    pub ramp: ColorTable,
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
}

#[derive(Debug)]
struct WrappedRampTexture {
    columns: Columns,
    noise: Expanded,
}

impl Specification for WrappedRamp {
    fn build(&self, _: &mut Resources) -> Result<Arc<dyn Texture>, Invalid> {
        Ok(Arc::new(WrappedRampTexture {
            columns: self.ramp.build("ramp")?,
            noise: Expanded::build(&self.noise, self.size, self.expansion)?,
        }))
    }
}

impl Texture for WrappedRampTexture {
    fn color(&self, at: &TexturePoint<'_>) -> Rgb {
        let [_, fraction] = self.noise.at(at);
        self.columns.color(fraction)
    }
}
