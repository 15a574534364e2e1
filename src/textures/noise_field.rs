//! Noise in the coordinates of a texture, shared by the noise textures (Suffern, ch. 31).

use super::TexturePoint;
use crate::invalid::{Invalid, length, strength};
use crate::math::{Point, floor};
use crate::noise::{LatticeNoise, Noise};

/// Noise with lattice cells of edge `size`.
#[derive(Debug)]
pub(super) struct NoiseField {
    pub noise: LatticeNoise,
    size: f64,
}

impl NoiseField {
    /// Checks the fields `noise` and `size` of a texture.
    pub fn build(noise: &Noise, size: f64) -> Result<Self, Invalid> {
        let noise = noise.build().map_err(|e| e.inside("noise"))?;
        Ok(Self { noise, size: length("size", size)? })
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
    /// Checks the fields `min` and `max` of a texture.
    pub fn build(min: f64, max: f64) -> Result<Self, Invalid> {
        Ok(Self { min: strength("min", min)?, max: strength("max", max)? })
    }

    /// `min + (max − min) value`.
    pub fn scaled(self, value: f64) -> f64 {
        self.min + (self.max - self.min) * value
    }
}

/// The fractional part of a noise, in `[0, 1)`.
pub(super) fn wrapped(noise: f64) -> f64 {
    noise - floor(noise)
}
