//! The wrapped fBm texture (Suffern, ch. 31): the book's `WrappedFBmTexture`.

use super::noise_field::{Expanded, Range, Wrapped};
use super::{Made, Paint, Specification, made};
use crate::kinds::{self, Resources};
use crate::math::{Length, Positive, Strength};
use crate::noise::Noise;
use crate::rgb::Rgb;

/// The brightness is the fractional part of `noise = expansion · fBm`, mapped to `min` … `max`: it
/// jumps from `max` to `min` along lines where the noise is an integer.
#[kind]
pub struct WrappedFbm {
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
    /// The colour at brightness 1.
    #[default(kinds::white())]
    pub color: Paint,
}

impl WrappedFbm {
    /// Black to white, in cells of this size.
    pub fn new(noise: Noise, size: f64, expansion: f64) -> Self {
        Self { noise, size, expansion, min: 0.0, max: 1.0, color: Rgb::WHITE.into() }
    }
}

impl Specification for WrappedFbm {
    fn make(&self, resources: &mut Resources) -> Made {
        made(Wrapped {
            noise: Expanded::build(&self.noise, self.size, self.expansion)?,
            range: Range { min: self.min, max: self.max },
            thresholds: Vec::new(),
            colors: vec![self.color.build("color", resources)?],
        })
    }
}
