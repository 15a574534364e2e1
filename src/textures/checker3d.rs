//! The solid checker (Suffern, ch. 30).

use std::sync::Arc;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::Texture;
use crate::invalid::{Invalid, positive};
use crate::kinds::{self, Specification};
use crate::math::floor;
use crate::rgb::Rgb;
use crate::shapes::Surface;

/// Cubes of alternating colours, in the local coordinates of the object. The cube of a point is
/// `floor(x / size − 0.000187453738)` on each axis, so that its borders are a little beyond the
/// multiples of the size: a face at a whole coordinate lies in one cube, whatever way it is rounded.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Checker3d {
    /// The side of a cube, in the unit of the scene; positive.
    #[serde(default = "kinds::one")]
    pub size: f64,
    /// The colour of the cube at the origin.
    #[serde(default = "kinds::white::<Rgb>")]
    pub color1: Rgb,
    /// The colour of its neighbours.
    #[serde(default = "half_grey")]
    pub color2: Rgb,
}

fn half_grey() -> Rgb {
    Rgb::grey(0.5)
}

/// The book's odd offset, added before rounding down, so that a face that lies on a border of cubes has
/// one colour. Here it is a fraction of the size: the book's absolute one would not scale with the
/// scene.
const OFFSET: f64 = -0.000_187_453_738;

impl Specification for Checker3d {
    type Built = Arc<dyn Texture>;
    type Context = ();

    fn build(&self, (): &mut ()) -> Result<Arc<dyn Texture>, Invalid> {
        positive("size", self.size)?;
        self.color1.checked("color1")?;
        self.color2.checked("color2")?;
        Ok(Arc::new(self.clone()))
    }

    fn scaled(&self, factor: f64) -> Self {
        Self { size: factor * self.size, ..*self }
    }

    fn specimens() -> Vec<Self> {
        vec![Self { size: 0.75, color1: Rgb::WHITE, color2: Rgb::new(0.1, 0.4, 0.8) }]
    }
}

impl Texture for Checker3d {
    fn color(&self, at: &Surface) -> Rgb {
        let cell = |x: f64| floor(x / self.size + OFFSET);
        let parity: f64 = at.local.to_array().into_iter().map(cell).sum();
        // Euclidean: the remainder of a negative number is not negative
        if parity.rem_euclid(2.0) == 0.0 { self.color1 } else { self.color2 }
    }
}
