//! Wrapped noise with the colours of a ramp (Suffern, ch. 31): the book's `WrappedRamp`.

use super::color_table::{ColorTable, Columns};
use super::noise_field::Expanded;
use super::{Made, Specification, Texture, TexturePoint, made};
use crate::kinds::Resources;
use crate::math::{Length, Positive};
use crate::noise::Noise;
use crate::rgb::Rgb;

/// The colour of a ramp at the fractional part of `expansion · fBm`.
#[kind(PartialEq)]
pub struct WrappedRamp {
    /// The colours.
    pub ramp: ColorTable,
    /// The noise.
    #[default]
    pub noise: Noise,
    /// The edge of a cell of the noise lattice, in the unit of the scene; positive.
    #[default(1.0)]
    pub size: Length,
    /// The book's expansion number: the noise has values from 0 to this number; positive.
    #[default(2.0)]
    pub expansion: Positive,
}

#[derive(Debug)]
struct WrappedRampTexture {
    columns: Columns,
    noise: Expanded,
}

impl Specification for WrappedRamp {
    fn make(&self, _: &mut Resources) -> Made {
        made(WrappedRampTexture {
            columns: self.ramp.build("ramp")?,
            noise: Expanded::build(&self.noise, self.size, self.expansion)?,
        })
    }
}

impl Texture for WrappedRampTexture {
    fn color(&self, at: &TexturePoint<'_>) -> Rgb {
        let [_, fraction] = self.noise.at(at);
        self.columns.color(fraction)
    }
}
