//! Stripes (Suffern, ch. 30).

use super::cells::{self, OFFSET, is_even};
use super::{Chooser, Color, Made, Paint, Specification, TexturePoint, made};
use crate::kinds::{self, Resources};
use crate::math::{Axis, Distance, floor};

/// Layers of two alternating colours, perpendicular to an axis of the object's own coordinates. As
/// for `checker3d`, the borders are slightly above the multiples of the size, so that a face at
/// such a multiple has one colour.
#[kind]
pub struct Stripes {
    /// The axis along which the colours change.
    pub axis: Axis,
    /// The width of a stripe, in the unit of the scene; positive.
    #[default(1.0)]
    pub size: Distance,
    /// The colour of the stripe from 0 to `size`.
    #[default(kinds::white())]
    pub color1: Paint,
    /// The colour of the stripes beside it.
    #[default(cells::half_grey())]
    pub color2: Paint,
}

#[derive(Debug)]
struct StripesTexture {
    axis: Axis,
    size: f64,
    color1: Color,
    color2: Color,
}

impl Specification for Stripes {
    fn make(&self, resources: &mut Resources) -> Made {
        made(StripesTexture {
            axis: self.axis,
            size: self.size,
            color1: self.color1.build("color1", resources)?,
            color2: self.color2.build("color2", resources)?,
        })
    }
}

impl Chooser for StripesTexture {
    fn chosen(&self, at: &TexturePoint<'_>) -> &Color {
        let x = at.local.along(self.axis as usize);
        if is_even(floor(x / self.size + OFFSET)) { &self.color1 } else { &self.color2 }
    }
}
