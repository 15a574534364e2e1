//! The fBm texture (Suffern, ch. 31): the book's `FBmTexture`.

use super::noise_field::{NoiseField, Range};
use super::{Color, Made, Paint, Specification, Texture, TexturePoint, made};
use crate::kinds::{self, Resources};
use crate::math::{Finite, Length};
use crate::noise::Noise;
use crate::rgb::Rgb;

/// Fractional Brownian motion as brightness: `min + (max − min) fBm` times a colour. Where this
/// number is not between 0 and 1 the texture is red, as in the book, which helps to choose min and
/// max.
#[kind]
pub struct Fbm {
    /// The noise.
    #[default]
    pub noise: Noise,
    /// The edge of a cell of the noise lattice, in the unit of the scene; positive.
    #[default(1.0)]
    pub size: Length,
    /// The brightness where fBm is 0; may be negative.
    #[default]
    pub min: Finite,
    /// The brightness where fBm is 1; may be negative.
    #[default(1.0)]
    pub max: Finite,
    /// The colour at brightness 1.
    #[default(kinds::white())]
    pub color: Paint,
}

impl Fbm {
    /// Black to white, in cells of this size.
    pub fn new(noise: Noise, size: f64) -> Self {
        Self { noise, size, min: 0.0, max: 1.0, color: Rgb::WHITE.into() }
    }
}

#[derive(Debug)]
struct FbmTexture {
    field: NoiseField,
    range: Range,
    color: Color,
}

impl Specification for Fbm {
    fn make(&self, resources: &mut Resources) -> Made {
        made(FbmTexture {
            field: NoiseField::build(&self.noise, self.size)?,
            range: Range { min: self.min, max: self.max },
            color: self.color.build("color", resources)?,
        })
    }
}

impl FbmTexture {
    fn value(&self, at: &TexturePoint<'_>) -> f64 {
        self.range.scaled(self.field.fbm(at))
    }
}

impl Texture for FbmTexture {
    fn color(&self, at: &TexturePoint<'_>) -> Rgb {
        let value = self.value(at);
        if !(0.0..=1.0).contains(&value) {
            return Rgb::new(1.0, 0.0, 0.0);
        }
        value * self.color.at(at)
    }

    /// Without the red: it marks only colours out of range.
    fn number(&self, at: &TexturePoint<'_>) -> f64 {
        self.value(at) * self.color.number(at)
    }
}
