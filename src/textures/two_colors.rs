//! Wrapped noise of two colours (Suffern, ch. 31): the book's `WrappedTwoColors` and
//! `NestedNoises`.

use std::sync::Arc;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::noise_field::{self, Expanded, Range, Wrapped};
use super::{Paint, Specification, Texture};
use crate::invalid::Invalid;
use crate::kinds::{self, Resources};
use crate::math::Length;
use crate::noise::Noise;

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
    #[serde(default = "noise_field::two")]
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

impl TwoColors {
    /// Two colours, each mixed with black, in cells of this size.
    pub fn new(noise: Noise, size: f64, expansion: f64, colors: [Paint; 2]) -> Self {
        let [color1, color2] = colors;
        Self { noise, size, expansion, min: 0.0, max: 1.0, color1, color2 }
    }
}

impl Specification for TwoColors {
    fn build(&self, resources: &mut Resources) -> Result<Arc<dyn Texture>, Invalid> {
        Ok(Arc::new(Wrapped {
            noise: Expanded::build(&self.noise, self.size, self.expansion)?,
            range: Range::build(self.min, self.max)?,
            thresholds: vec![1.0],
            colors: vec![
                self.color1.build("color1", resources)?,
                self.color2.build("color2", resources)?,
            ],
        }))
    }
}
