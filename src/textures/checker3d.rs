//! The solid checker (Suffern, ch. 30).

use super::cells::{self, OFFSET, is_even};
use super::{Chooser, Color, Made, Paint, Specification, TexturePoint, made};
use crate::kinds::{self, Resources};
use crate::math::{Distance, floor};

/// Cubes of alternating colours, in the local coordinates of the object. The index of a cube on
/// each axis is `floor(x / size − 0.000187453738)`: the borders are slightly above the multiples of
/// the size, so that rounding cannot give two colours to a face at such a multiple.
#[kind]
pub struct Checker3d {
    /// The side of a cube, in the unit of the scene; positive.
    #[default(1.0)]
    pub size: Distance,
    /// The colour of the cube at the origin.
    #[default(kinds::white())]
    pub color1: Paint,
    /// The colour of the cubes beside it.
    #[default(cells::half_grey())]
    pub color2: Paint,
}

#[derive(Debug)]
struct Checker3dTexture {
    size: f64,
    color1: Color,
    color2: Color,
}

impl Specification for Checker3d {
    fn make(&self, resources: &mut Resources) -> Made {
        made(Checker3dTexture {
            size: self.size,
            color1: self.color1.build("color1", resources)?,
            color2: self.color2.build("color2", resources)?,
        })
    }
}

impl Chooser for Checker3dTexture {
    fn chosen(&self, at: &TexturePoint<'_>) -> &Color {
        let cell = |x: f64| floor(x / self.size + OFFSET);
        let sum = at.local.to_array().into_iter().map(cell).sum();
        if is_even(sum) { &self.color1 } else { &self.color2 }
    }
}
