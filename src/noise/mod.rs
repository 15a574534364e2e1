//! Lattice noise and its sums (Suffern, ch. 31): the book's `LatticeNoise`.
//!
//! Points of integer coordinates have random numbers and unit vectors; between them these are
//! interpolated, linearly or by cubics. The edge of a cell is 1 here; textures divide by their
//! size.

mod cubic;
mod lattice;
mod linear;

use std::ops::{Add, Mul};

use crate::invalid::{Invalid, positive, shown};
use crate::math::{Point, Vector};

pub use lattice::Lattice;

/// More octaves make no visible difference: with lacunarity 2, the frequency of the last octave is
/// 2³¹ times that of the first.
pub const MAX_OCTAVES: u32 = 32;

/// A lattice noise and the sum of its octaves.
// the defaults are those of the book
#[kind(Copy, Default, PartialEq)]
pub struct Noise {
    /// The interpolation between the lattice points.
    #[default]
    pub interpolation: Interpolation,
    /// The number of noises of increasing frequency that are added; from 1 to 32.
    #[default(1)]
    pub octaves: u32,
    /// The ratio of the amplitudes of an octave and the previous one; positive. Used by fBm only:
    /// fractal sum and turbulence use 1/2.
    #[default(0.5)]
    pub gain: f64,
    /// The ratio of the frequencies of an octave and the previous one; positive. Used by fBm only:
    /// fractal sum and turbulence use 2.
    #[default(2.0)]
    pub lacunarity: f64,
    /// The seed of the random numbers at the lattice points.
    #[default(253)]
    pub seed: u64,
}

/// The interpolation between lattice points.
#[kind(Default)]
#[schemars(title = "interpolations")]
pub enum Interpolation {
    /// Linear along each axis, of the 8 corners of the cell: continuous, but the planes of the
    /// lattice are visible.
    Linear,
    /// Cubic along each axis, of 64 points: smooth.
    #[default]
    Cubic,
}

impl Noise {
    /// This number of octaves, the rest as in the book.
    pub fn of_octaves(octaves: u32) -> Self {
        Self { octaves, ..Self::default() }
    }

    /// Checks the data and fills the tables.
    ///
    /// # Errors
    /// [`Invalid`] names the invalid field.
    pub fn build(&self) -> Result<LatticeNoise, Invalid> {
        let Self { interpolation, octaves, gain, lacunarity, seed } = *self;
        if !(1..=MAX_OCTAVES).contains(&octaves) {
            let problem = format!("found {octaves}, but 1 to {MAX_OCTAVES} fit");
            return Err(Invalid::field("octaves", problem));
        }
        for (field, factor) in [("gain", gain), ("lacunarity", lacunarity)] {
            positive(field, factor)?;
            if !bound(factor, octaves).is_finite() {
                let found = shown(factor);
                let problem =
                    format!("found {found}, but its powers overflow with {octaves} octaves");
                return Err(Invalid::field(field, problem));
            }
        }
        Ok(LatticeNoise {
            interpolation,
            lattice: Lattice::new(seed),
            octaves,
            gain,
            lacunarity,
            fbm_max: bound(gain, octaves),
            half_max: bound(0.5, octaves),
        })
    }
}

/// `Σ gainʲ` over the octaves: a bound of the sum of noises, because each noise is between −1 and
/// 1.
///
/// It is `(1 − gainⁿ)/(1 − gain)`, or `n` for gain 1. It is added term by term like the noises, so
/// that it bounds also the rounded sum: rounding is monotone.
fn bound(gain: f64, octaves: u32) -> f64 {
    sum(octaves, gain, 1.0, |_| 1.0)
}

/// `Σ gainʲ noise(lacunarityʲ)`, for `j` from 0 to `octaves` − 1.
fn sum<T>(octaves: u32, gain: f64, lacunarity: f64, noise: impl Fn(f64) -> T) -> T
where
    T: Add<Output = T>,
    f64: Mul<T, Output = T>,
{
    let mut sum = noise(1.0);
    let (mut amplitude, mut frequency) = (1.0, 1.0);
    for _ in 1..octaves {
        amplitude *= gain;
        frequency *= lacunarity;
        sum = sum + amplitude * noise(frequency);
    }
    sum
}

/// A built noise. It has the period 256 along each axis.
#[derive(Clone, Debug)]
pub struct LatticeNoise {
    interpolation: Interpolation,
    lattice: Lattice,
    octaves: u32,
    gain: f64,
    lacunarity: f64,
    /// The bound of the fBm sum; its negative is the lower bound.
    fbm_max: f64,
    /// The bound for a gain of 1/2, of fractal sum and turbulence.
    half_max: f64,
}

impl LatticeNoise {
    /// The values at the lattice points.
    pub fn lattice(&self) -> &Lattice {
        &self.lattice
    }

    /// The same noise over other values at the lattice points.
    #[must_use]
    pub fn with_lattice(self, lattice: Lattice) -> Self {
        Self { lattice, ..self }
    }

    /// One octave, from −1 to 1.
    pub fn value(&self, p: Point) -> f64 {
        match self.interpolation {
            Interpolation::Linear => linear::noise(p, |corner| self.lattice.value(corner)),
            // the splines overshoot
            Interpolation::Cubic => {
                cubic::noise(p, |knot| self.lattice.value(knot)).clamp(-1.0, 1.0)
            }
        }
    }

    /// One octave of vectors; each component from −1 to 1.
    pub fn vector(&self, p: Point) -> Vector {
        match self.interpolation {
            Interpolation::Linear => linear::noise(p, |corner| self.lattice.vector(corner)),
            Interpolation::Cubic => {
                let vector = cubic::noise(p, |knot| self.lattice.vector(knot));
                Vector::from(vector.to_array().map(|c| c.clamp(-1.0, 1.0)))
            }
        }
    }

    /// `Σ 2⁻ʲ noise(2ʲ p)`, scaled from its bounds to 0 … 1.
    pub fn value_fractal_sum(&self, p: Point) -> f64 {
        let sum = sum(self.octaves, 0.5, 2.0, |frequency| self.value(p.scaled(frequency)));
        normalised(-self.half_max, self.half_max, sum)
    }

    /// `Σ 2⁻ʲ noise(2ʲ p)` of vectors, not scaled to a range.
    pub fn vector_fractal_sum(&self, p: Point) -> Vector {
        sum(self.octaves, 0.5, 2.0, |frequency| self.vector(p.scaled(frequency)))
    }

    /// `Σ 2⁻ʲ |noise(2ʲ p)|`, scaled from its bounds to 0 … 1.
    pub fn value_turbulence(&self, p: Point) -> f64 {
        let sum = sum(self.octaves, 0.5, 2.0, |frequency| self.value(p.scaled(frequency)).abs());
        normalised(0.0, self.half_max, sum)
    }

    /// Fractional Brownian motion: `Σ gainʲ noise(lacunarityʲ p)`, scaled from its bounds to 0 … 1.
    pub fn value_fbm(&self, p: Point) -> f64 {
        let noise = |frequency| self.value(p.scaled(frequency));
        let sum = sum(self.octaves, self.gain, self.lacunarity, noise);
        normalised(-self.fbm_max, self.fbm_max, sum)
    }

    /// `Σ gainʲ noise(lacunarityʲ p)` of vectors, not scaled to a range.
    pub fn vector_fbm(&self, p: Point) -> Vector {
        let noise = |frequency| self.vector(p.scaled(frequency));
        sum(self.octaves, self.gain, self.lacunarity, noise)
    }
}

/// Maps `sum` from `min` … `max` to 0 … 1.
fn normalised(min: f64, max: f64, sum: f64) -> f64 {
    (sum - min) / (max - min)
}
