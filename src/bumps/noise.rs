//! Bump mapping by noise (Suffern, ch. 31): the book's `FBMBump`.

use super::{Bump, Made, Specification, made};
use crate::kinds::Resources;
use crate::math::{Finite, Length, Normal, Point, Vector};
use crate::noise::{self, LatticeNoise};
use crate::textures::TexturePoint;

/// `n' = n + a · fBm(p)`, normalised: a random vector is added to the normal. No surface has these
/// normals, but it looks rough.
#[kind(PartialEq)]
#[schemars(rename = "NoiseBump")]
pub struct Noise {
    /// The noise.
    #[default]
    pub noise: noise::Noise,
    /// The edge of a cell of the noise lattice, in the unit of the scene; positive.
    #[default(1.0)]
    pub size: Length,
    /// The book's perturbation `a`: the factor of the noise that is added to the unit normal.
    pub perturbation: Finite,
}

#[derive(Debug)]
struct NoiseBump {
    noise: LatticeNoise,
    size: f64,
    perturbation: f64,
}

impl Specification for Noise {
    fn make(&self, _: &mut Resources) -> Made {
        made(NoiseBump {
            noise: self.noise.build().map_err(|e| e.inside("noise"))?,
            size: self.size,
            perturbation: self.perturbation,
        })
    }
}

impl Bump for NoiseBump {
    fn perturbed(&self, at: &TexturePoint<'_>, n: Normal) -> Vector {
        let p = Point::from(at.local.to_array().map(|c| c / self.size));
        n + self.perturbation * self.noise.vector_fbm(p)
    }
}
