//! Bump mapping by noise (Suffern, ch. 31): the book's `FBMBump`.

use std::sync::Arc;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{Bump, Specification};
use crate::invalid::{Invalid, finite, length};
use crate::kinds::{self, Resources};
use crate::math::{Length, Normal, Point, Vector};
use crate::noise::{self, LatticeNoise};
use crate::textures::TexturePoint;

/// `n' = n + a · fBm(p)`, normalised: a random vector is added to the normal. No surface has these
/// normals, but it looks rough.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "NoiseBump")]
pub struct Noise {
    /// The noise.
    #[serde(default)]
    pub noise: noise::Noise,
    /// The edge of a cell of the noise lattice, in the unit of the scene; positive.
    #[serde(default = "kinds::one")]
    #[schemars(with = "Length")]
    pub size: f64,
    /// The book's perturbation `a`: the factor of the noise that is added to the unit normal.
    pub perturbation: f64,
}

#[derive(Debug)]
struct NoiseBump {
    noise: LatticeNoise,
    size: f64,
    perturbation: f64,
}

impl Specification for Noise {
    fn build(&self, _: &mut Resources) -> Result<Arc<dyn Bump>, Invalid> {
        Ok(Arc::new(NoiseBump {
            noise: self.noise.build().map_err(|e| e.inside("noise"))?,
            size: length("size", self.size)?,
            perturbation: finite("perturbation", self.perturbation)?,
        }))
    }
}

impl Bump for NoiseBump {
    fn perturbed(&self, at: &TexturePoint<'_>, n: Normal) -> Vector {
        let p = Point::from(at.local.to_array().map(|c| c / self.size));
        n + self.perturbation * self.noise.vector_fbm(p)
    }
}
