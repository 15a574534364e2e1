//! Wrapped noise of two colours (Suffern, ch. 31): the book's `WrappedTwoColors` and
//! `NestedNoises`.

use std::sync::Arc;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::noise_field::{NoiseField, Range, wrapped};
use super::{Color, Paint, Texture, TexturePoint, WrappedFbm};
use crate::invalid::{Invalid, positive};
use crate::kinds::{self, Resources, Specification};
use crate::math::Length;
use crate::noise::Noise;
use crate::rgb::Rgb;

/// As `wrapped_fbm`, with one colour where `expansion · fBm` is below 1 and another elsewhere. If
/// the second is a noise texture, these are the book's nested noises.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TwoColors {
    /// The noise.
    #[serde(default)]
    pub noise: Noise,
    /// The edge of a cell of the noise lattice, in the unit of the scene; positive.
    #[serde(default = "kinds::one")]
    #[schemars(with = "Length")]
    pub size: f64,
    /// The book's expansion number: the noise has values from 0 to this number; positive.
    #[serde(default = "two")]
    pub expansion: f64,
    /// The brightness where the fractional part is 0; not negative.
    #[serde(default)]
    pub min: f64,
    /// The brightness where the fractional part approaches 1; not negative.
    #[serde(default = "kinds::one")]
    pub max: f64,
    /// The colour where the noise is below 1.
    pub color1: Paint,
    /// The colour where the noise is at least 1.
    pub color2: Paint,
}

fn two() -> f64 {
    2.0
}

impl TwoColors {
    /// Two colours, each mixed with black, in cells of this size.
    pub fn new(noise: Noise, size: f64, expansion: f64, colors: [Paint; 2]) -> Self {
        let [color1, color2] = colors;
        Self { noise, size, expansion, min: 0.0, max: 1.0, color1, color2 }
    }
}

#[derive(Debug)]
struct TwoColorsTexture {
    field: NoiseField,
    expansion: f64,
    range: Range,
    color1: Color,
    color2: Color,
}

impl Specification for TwoColors {
    type Built = Arc<dyn Texture>;
    type Context = Resources;

    fn build(&self, resources: &mut Resources) -> Result<Arc<dyn Texture>, Invalid> {
        Ok(Arc::new(TwoColorsTexture {
            field: NoiseField::build(&self.noise, self.size)?,
            expansion: positive("expansion", self.expansion)?,
            range: Range::build(self.min, self.max)?,
            color1: self.color1.build("color1", resources)?,
            color2: self.color2.build("color2", resources)?,
        }))
    }

    fn specimens() -> Vec<Self> {
        let noise = Noise { lacunarity: 4.0, ..Noise::of_octaves(4) };
        let [gold, jade] = [Rgb::new(1.0, 0.75, 0.0), Rgb::new(0.0, 0.6, 0.3)].map(Paint::from);
        let plain = Self::new(noise, 0.75, 2.0, [gold.clone(), jade]);
        let inner = WrappedFbm::new(Noise::of_octaves(6), 0.25, 3.0);
        vec![plain, Self::new(noise, 1.0, 2.0, [gold, inner.into()])]
    }
}

impl Texture for TwoColorsTexture {
    fn color(&self, at: &TexturePoint<'_>) -> Rgb {
        let noise = self.expansion * self.field.fbm(at);
        let color = if noise < 1.0 { &self.color1 } else { &self.color2 };
        self.range.scaled(wrapped(noise)) * color.at(at)
    }
}
