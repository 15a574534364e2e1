//! Wrapped noise of two colours (Suffern, ch. 31): the book's `WrappedTwoColors` and
//! `NestedNoises`.

use super::noise_field::{Expanded, Range, Wrapped};
use super::{Made, Paint, Specification, made};
use crate::kinds::Resources;
use crate::math::{Length, Positive, Strength};
use crate::noise::Noise;

/// As `wrapped_fbm`, with one colour where `expansion · fBm` is below 1 and another elsewhere. If
/// the second is a noise texture, these are the book's nested noises.
#[kind]
pub struct TwoColors {
    /// The noise.
    #[default]
    pub noise: Noise,
    /// The edge of a cell of the noise lattice, in the unit of the scene; positive.
    #[default(1.0)]
    pub size: Length,
    /// The book's expansion number: the noise has values from 0 to this number; positive.
    #[default(2.0)]
    pub expansion: Positive,
    /// The brightness where the fractional part is 0; not negative.
    #[default]
    pub min: Strength,
    /// The brightness where the fractional part approaches 1; not negative.
    #[default(1.0)]
    pub max: Strength,
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
    fn make(&self, resources: &mut Resources) -> Made {
        made(Wrapped {
            noise: Expanded::build(&self.noise, self.size, self.expansion)?,
            range: Range { min: self.min, max: self.max },
            thresholds: vec![1.0],
            colors: vec![
                self.color1.build("color1", resources)?,
                self.color2.build("color2", resources)?,
            ],
        })
    }
}
