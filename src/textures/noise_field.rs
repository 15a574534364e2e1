//! Noise in the coordinates of a texture, shared by the noise textures (Suffern, ch. 31).

use super::{Color, Texture, TexturePoint};
use crate::invalid::Invalid;
use crate::math::{Point, floor};
use crate::noise::{LatticeNoise, Noise};
use crate::rgb::Rgb;

/// Noise with lattice cells of edge `size`.
#[derive(Debug)]
pub(super) struct NoiseField {
    pub noise: LatticeNoise,
    size: f64,
}

impl NoiseField {
    /// Builds the field `noise` of a texture.
    pub fn build(noise: &Noise, size: f64) -> Result<Self, Invalid> {
        let noise = noise.build().map_err(|e| e.inside("noise"))?;
        Ok(Self { noise, size })
    }

    /// The point in units of lattice cells.
    pub fn point(&self, at: &TexturePoint<'_>) -> Point {
        Point::from(at.local.to_array().map(|c| c / self.size))
    }

    /// Fractional Brownian motion, from 0 to 1.
    pub fn fbm(&self, at: &TexturePoint<'_>) -> f64 {
        self.noise.value_fbm(self.point(at))
    }
}

/// The values to which 0 and 1 of a noise are mapped.
#[derive(Clone, Copy, Debug)]
pub(super) struct Range {
    pub min: f64,
    pub max: f64,
}

impl Range {
    /// `min + (max − min) value`.
    pub fn scaled(self, value: f64) -> f64 {
        self.min + (self.max - self.min) * value
    }
}

/// Noise with values from 0 to the book's expansion number, of which textures use the fractional
/// part.
#[derive(Debug)]
pub(super) struct Expanded {
    field: NoiseField,
    expansion: f64,
}

impl Expanded {
    /// As [`NoiseField::build`].
    pub fn build(noise: &Noise, size: f64, expansion: f64) -> Result<Self, Invalid> {
        Ok(Self { field: NoiseField::build(noise, size)?, expansion })
    }

    /// `expansion · fBm`, and its fractional part in `[0, 1)`.
    pub fn at(&self, at: &TexturePoint<'_>) -> [f64; 2] {
        let noise = self.expansion * self.field.fbm(at);
        [noise, noise - floor(noise)]
    }
}

/// The built texture of wrapped noise in one or more colours.
#[derive(Debug)]
pub(super) struct Wrapped {
    pub noise: Expanded,
    pub range: Range,
    /// The noise from which on the next colour is used; ascending.
    pub thresholds: Vec<f64>,
    /// One colour more than thresholds.
    pub colors: Vec<Color>,
}

impl Texture for Wrapped {
    fn color(&self, at: &TexturePoint<'_>) -> Rgb {
        let [noise, fraction] = self.noise.at(at);
        let passed = self.thresholds.iter().filter(|threshold| noise >= **threshold).count();
        self.range.scaled(fraction) * self.colors[passed].at(at)
    }
}
