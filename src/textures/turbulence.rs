//! The turbulence texture (Suffern, ch. 31): the book's `TurbulenceTexture`.

use super::noise_field::{NoiseField, Range};
use super::{Color, Made, Paint, Specification, Texture, TexturePoint, made};
use crate::kinds::{self, Resources};
use crate::math::{Length, Strength};
use crate::noise::Noise;
use crate::rgb::Rgb;

/// Turbulence as brightness: `min + (max − min) turbulence` times a colour. It has dark veins where
/// the noise changes sign.
#[kind]
pub struct Turbulence {
    /// The noise; gain and lacunarity are not used.
    #[default]
    pub noise: Noise,
    /// The edge of a cell of the noise lattice, in the unit of the scene; positive.
    #[default(1.0)]
    pub size: Length,
    /// The brightness where the turbulence is 0; not negative.
    #[default]
    pub min: Strength,
    /// The brightness where the turbulence is 1; not negative. It may be above 1, because few
    /// points have a turbulence near 1.
    #[default(1.0)]
    pub max: Strength,
    /// The colour at brightness 1.
    #[default(kinds::white())]
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
    fn make(&self, resources: &mut Resources) -> Made {
        made(TurbulenceTexture {
            field: NoiseField::build(&self.noise, self.size)?,
            range: Range { min: self.min, max: self.max },
            color: self.color.build("color", resources)?,
        })
    }
}

impl Texture for TurbulenceTexture {
    fn color(&self, at: &TexturePoint<'_>) -> Rgb {
        let value = self.range.scaled(self.field.noise.value_turbulence(self.field.point(at)));
        value * self.color.at(at)
    }
}
