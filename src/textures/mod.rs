//! Textures: colours that vary over a surface (Suffern, ch. 29–31). Every colour or number of a
//! material may be one.

mod checker3d;
mod constant;
mod fbm;
mod image;
mod plane_checker;
mod ramp_fbm;
mod random_colors;
mod three_colors;
mod turbulence;
mod two_colors;
mod wood;
mod wrapped_fbm;
mod wrapped_ramp;

// shared by the kinds
mod amount;
mod mapping;
mod noise_field;
mod paint;
mod point;
mod ramp;
mod sampling;

use std::fmt::Debug;

use crate::resources::Resources;
use crate::rgb::Rgb;

pub use amount::{Amount, Value};
pub use mapping::Mapping;
pub use paint::{Color, Paint};
pub use point::TexturePoint;
pub use ramp::Ramp;
pub use sampling::{Filtering, Rule, Wrap};

/// A colour for each point of a surface. Contract: `tests/contracts/texture.rs`.
pub trait Texture: Debug + Send + Sync {
    /// The colour at a point; solid textures look at the local point.
    fn color(&self, at: &TexturePoint<'_>) -> Rgb;

    /// What of an image is seen at a point, for those who ask why it has its colour; `None` for
    /// textures without images.
    fn texel(&self, _at: &TexturePoint<'_>) -> Option<Texel> {
        None
    }
}

/// Where in an image a texture looks.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct Texel {
    /// The texture coordinates: u to the right, v up.
    pub uv: [f64; 2],
    /// The column, from 0 at the left. Of a bilinear look-up, the texel of the largest weight.
    pub column: u32,
    /// The row, from 0 at the bottom, as in the book.
    pub row: u32,
}

crate::kinds! {
    /// A colour that varies over a surface. It may be written wherever a material has a colour; where
    /// it has a number, the red channel is that number.
    Kind builds dyn Texture with Resources;
    ch29 constant::Constant,
    ch29 image::Image,
    ch30 checker3d::Checker3d,
    ch30 plane_checker::PlaneChecker,
    ch31 fbm::Fbm,
    ch31 turbulence::Turbulence,
    ch31 wrapped_fbm::WrappedFbm,
    ch31 two_colors::TwoColors,
    ch31 three_colors::ThreeColors,
    ch31 ramp_fbm::RampFbm,
    ch31 wrapped_ramp::WrappedRamp,
    ch31 wood::Wood,
    ch22 random_colors::RandomColors,
}
