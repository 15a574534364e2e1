//! Marble and sandstone (Suffern, ch. 31): the book's `RampFBmTexture`.

use std::sync::Arc;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::color_table::{ColorTable, Columns};
use super::noise_field::NoiseField;
use super::{Specification, Texture, TexturePoint};
use crate::invalid::{Invalid, finite};
use crate::kinds::{self, Resources};
use crate::math::{Length, sin};
use crate::noise::Noise;
use crate::rgb::Rgb;

/// Layers perpendicular to the y axis, perturbed by noise: the colour of a ramp at `(1 + sin(y + a
/// fBm))/2`. With a large perturbation `a` it is marble, with a small one and many octaves
/// sandstone. The layers have the period 2π in units of `size`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RampFbm {
    /// The colours.
    pub ramp: ColorTable,
    /// The noise.
    #[serde(default)]
    pub noise: Noise,
    /// The edge of a cell of the noise lattice and the unit of y, in the unit of the scene;
    /// positive.
    #[serde(default = "kinds::one")]
    #[schemars(with = "Length")]
    pub size: f64,
    /// The book's perturbation `a`, in units of `size`: the displacement of the layers by the
    /// noise.
    #[serde(default = "three")]
    pub perturbation: f64,
}

fn three() -> f64 {
    3.0
}

#[derive(Debug)]
struct RampFbmTexture {
    columns: Columns,
    field: NoiseField,
    perturbation: f64,
}

impl Specification for RampFbm {
    fn build(&self, _: &mut Resources) -> Result<Arc<dyn Texture>, Invalid> {
        Ok(Arc::new(RampFbmTexture {
            columns: self.ramp.build("ramp")?,
            field: NoiseField::build(&self.noise, self.size)?,
            perturbation: finite("perturbation", self.perturbation)?,
        }))
    }
}

impl Texture for RampFbmTexture {
    fn color(&self, at: &TexturePoint<'_>) -> Rgb {
        let p = self.field.point(at);
        let noise = self.field.noise.value_fbm(p);
        let y = p.y() + self.perturbation * noise;
        let u = (1.0 + sin(y)) / 2.0;
        self.columns.color(u)
    }
}
