//! Marble and sandstone (Suffern, ch. 31): the book's `RampFBmTexture`.

use super::color_table::{ColorTable, Columns};
use super::noise_field::NoiseField;
use super::{Made, Specification, Texture, TexturePoint, made};
use crate::kinds::Resources;
use crate::math::{Finite, Length, sin};
use crate::noise::Noise;
use crate::rgb::Rgb;

/// Layers perpendicular to the y axis, perturbed by noise: the colour of a ramp at `(1 + sin(y + a
/// fBm))/2`. With a large perturbation `a` it is marble, with a small one and many octaves
/// sandstone. The layers have the period 2π in units of `size`.
#[kind(PartialEq)]
pub struct RampFbm {
    /// The colours.
    pub ramp: ColorTable,
    /// The noise.
    #[default]
    pub noise: Noise,
    /// The edge of a cell of the noise lattice and the unit of y, in the unit of the scene;
    /// positive.
    #[default(1.0)]
    pub size: Length,
    /// The book's perturbation `a`, in units of `size`: the displacement of the layers by the
    /// noise.
    #[default(3.0)]
    pub perturbation: Finite,
}

#[derive(Debug)]
struct RampFbmTexture {
    columns: Columns,
    field: NoiseField,
    perturbation: f64,
}

impl Specification for RampFbm {
    fn make(&self, _: &mut Resources) -> Made {
        made(RampFbmTexture {
            columns: self.ramp.build("ramp")?,
            field: NoiseField::build(&self.noise, self.size)?,
            perturbation: self.perturbation,
        })
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
