//! Bumps: normals turned as if the surface were rough, while it stays as it is (Suffern, ch. 31; Blinn,
//! "Simulation of wrinkled surfaces", SIGGRAPH 1978).
//!
//! All is done in the coordinates in which textures live, so that bumps move, turn and grow with their
//! object: lengths and heights are in its own unit, as the size of a texture is.

mod height;
mod noise;

use std::fmt::Debug;

use crate::math::{Normal, Vector};
use crate::resources::Resources;
use crate::textures::TexturePoint;

/// A way to turn normals. Contract: `tests/contracts/bump.rs`.
pub trait Bump: Debug + Send + Sync {
    /// A vector along the normal of the bumped surface, of any length. Point and normal `n` are in the
    /// coordinates of the texture.
    fn turned(&self, at: &TexturePoint<'_>, n: Normal) -> Vector;
}

crate::kinds! {
    /// Normals turned as if the surface were rough.
    Kind builds dyn Bump with Resources;
    ch31 noise::Noise,
    ch31 height::Height,
}
