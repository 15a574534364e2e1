//! Bump mapping: perturbed shading normals on an unchanged surface (Suffern, ch. 31; Blinn,
//! "Simulation of wrinkled surfaces", SIGGRAPH 1978).
//!
//! Bumps are computed in texture coordinates, so that they are transformed with their object:
//! lengths and heights are in the object's own unit, like the size of a texture.

mod height;
mod noise;

use std::fmt::Debug;

use crate::kinds::Resources;
use crate::math::{Normal, Vector};
use crate::textures::TexturePoint;

/// A perturbation of normals. Contract: `tests/contracts/bump.rs`.
pub trait Bump: Debug + Send + Sync {
    /// A vector along the normal of the bumped surface, of any length. Point and normal `n` are in
    /// the coordinates of the texture.
    fn perturbed(&self, at: &TexturePoint<'_>, n: Normal) -> Vector;
}

crate::kinds! {
    /// Perturbed normals, so that the surface looks rough.
    Kind builds dyn Bump with Resources;
    ch31 noise::Noise,
    ch31 height::Height,
}
