//! The solid checker (Suffern, ch. 30).

use std::sync::Arc;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::cells::{self, OFFSET, is_even};
use super::{Chooser, Color, Paint, Specification, Texture, TexturePoint};
use crate::invalid::{Invalid, positive};
use crate::kinds::{self, Resources};
use crate::math::{Length, floor};

/// Cubes of alternating colours, in the local coordinates of the object. The index of a cube on
/// each axis is `floor(x / size − 0.000187453738)`: the borders are slightly above the multiples of
/// the size, so that rounding cannot give two colours to a face at such a multiple.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Checker3d {
    /// The side of a cube, in the unit of the scene; positive.
    #[serde(default = "kinds::one")]
    #[schemars(with = "Length")]
    pub size: f64,
    /// The colour of the cube at the origin.
    #[serde(default = "kinds::white::<Paint>")]
    pub color1: Paint,
    /// The colour of the cubes beside it.
    #[serde(default = "cells::half_grey")]
    pub color2: Paint,
}

#[derive(Debug)]
struct Checker3dTexture {
    size: f64,
    color1: Color,
    color2: Color,
}

impl Specification for Checker3d {
    fn build(&self, resources: &mut Resources) -> Result<Arc<dyn Texture>, Invalid> {
        Ok(Arc::new(Checker3dTexture {
            size: positive("size", self.size)?,
            color1: self.color1.build("color1", resources)?,
            color2: self.color2.build("color2", resources)?,
        }))
    }
}

impl Chooser for Checker3dTexture {
    fn chosen(&self, at: &TexturePoint<'_>) -> &Color {
        let cell = |x: f64| floor(x / self.size + OFFSET);
        let sum = at.local.to_array().into_iter().map(cell).sum();
        if is_even(sum) { &self.color1 } else { &self.color2 }
    }
}
