//! Textures: colours that vary over a surface (Suffern, ch. 29–31). Every colour or number of a
//! material may be a texture.

mod checker;
mod checker3d;
mod constant;
mod fbm;
mod image;
mod plane_checker;
mod ramp;
mod ramp_fbm;
mod random_colors;
mod sphere_checker;
mod sphere_textures;
mod stripes;
mod texture_instance;
mod three_colors;
mod turbulence;
mod two_colors;
mod wireframe;
mod wood;
mod wrapped_fbm;
mod wrapped_ramp;

// shared by the kinds
mod cells;
mod color_table;
mod field;
mod mapping;
mod noise_field;
mod point;
mod sampling;
mod sphere_cells;

use std::fmt::Debug;

use crate::kinds::Resources;
use crate::rgb::Rgb;

pub use cells::Lines;
pub use color_table::ColorTable;
pub use field::{Amount, Color, Paint, Textured, Value, Varying};
pub use mapping::Mapping;
pub use point::TexturePoint;
pub(crate) use sampling::Sampling;
pub use sampling::{Filtering, Rule, Wrap};
pub(crate) use sphere_cells::SphereCells;

/// A colour for each point of a surface. Contract: `tests/contracts/texture.rs`.
pub trait Texture: Debug + Send + Sync {
    /// The colour at a point; solid textures use the local point.
    fn color(&self, at: &TexturePoint<'_>) -> Rgb;

    /// The number at a point, for a field that is not a colour: the red channel.
    fn number(&self, at: &TexturePoint<'_>) -> f64 {
        self.color(at).r
    }

    /// The texel at a point, for explanations; `None` for textures without an image.
    fn texel(&self, _at: &TexturePoint<'_>) -> Option<Texel> {
        None
    }
}

/// A texture that chooses one of several colours at each point.
trait Chooser: Debug + Send + Sync {
    /// The chosen colour at a point.
    fn chosen(&self, at: &TexturePoint<'_>) -> &Color;
}

impl<T: Chooser> Texture for T {
    fn color(&self, at: &TexturePoint<'_>) -> Rgb {
        self.chosen(at).at(at)
    }

    fn number(&self, at: &TexturePoint<'_>) -> f64 {
        self.chosen(at).number(at)
    }

    fn texel(&self, at: &TexturePoint<'_>) -> Option<Texel> {
        self.chosen(at).texel(at)
    }
}

/// The position of a look-up in an image.
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
    /// A colour of a material that varies over a surface, or a number: the red channel.
    Kind builds dyn Texture with Resources;
    ch29 constant::Constant,
    ch29 image::Image,
    ch30 checker3d::Checker3d,
    ch30 plane_checker::PlaneChecker,
    ch30 sphere_checker::SphereChecker,
    ch30 checker::CylinderChecker,
    ch30 checker::ConeChecker,
    ch30 checker::DiskChecker,
    ch30 checker::RectangleChecker,
    ch30 stripes::Stripes,
    ch30 ramp::Ramp,
    ch30 wireframe::Wireframe,
    ch30 sphere_textures::SphereTextures,
    ch30 texture_instance::TextureInstance,
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
