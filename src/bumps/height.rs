//! Bump mapping by a height field (Blinn 1978).

use std::sync::Arc;

use super::{Bump, Made, Specification, made};
use crate::kinds::Resources;
use crate::math::{Coordinate, Frame, Length, Normal, Vector, power_of_two};
use crate::textures::{Kind, Texture, TexturePoint};

/// The normals of a displaced surface: the red channel of a texture is the height `h` of each point
/// along the normal, and `n' = n − ∇ₛh`, normalised, with the gradient along the surface. The
/// texture may be a solid texture or an image. An image needs `bilinear` filtering, because nearest
/// texels give steps, and `encoding = "linear"` if its numbers are heights.
#[kind]
pub struct Height {
    /// The texture whose red channel is the height.
    pub texture: Kind,
    /// The height where the red channel is 1, in the unit of the scene; negative for a dent.
    #[default(1.0)]
    pub height: Coordinate,
    /// The step of the central differences for the slope, in the unit of the scene: much smaller
    /// than the texture's details; positive.
    pub step: Length,
}

impl Height {
    /// This height where the red channel is 1, with a step of 2⁻¹⁰: details must be much larger.
    pub fn new(texture: impl Into<Kind>, height: f64) -> Self {
        Self { texture: texture.into(), height, step: power_of_two(-10) }
    }
}

#[derive(Debug)]
struct HeightBump {
    texture: Arc<dyn Texture>,
    height: f64,
    step: f64,
}

impl Specification for Height {
    fn make(&self, resources: &mut Resources) -> Made {
        made(HeightBump {
            texture: self.texture.build(resources).map_err(|e| e.inside("texture"))?,
            height: self.height,
            step: self.step,
        })
    }
}

impl HeightBump {
    /// `∂h/∂t`, by central differences.
    fn slope(&self, at: &TexturePoint<'_>, t: Vector) -> f64 {
        let h = |by: f64| self.texture.number(&at.displaced(by * t));
        self.height * (h(self.step) - h(-self.step)) / (2.0 * self.step)
    }
}

impl Bump for HeightBump {
    fn perturbed(&self, at: &TexturePoint<'_>, n: Normal) -> Vector {
        let Frame { u, v, .. } = Frame::around(n);
        let gradient = self.slope(at, u) * u + self.slope(at, v) * v;
        Vector::from(n) - gradient
    }
}
