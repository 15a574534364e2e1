//! The instance of a texture, the book's `TInstance` (Suffern, ch. 30): a transformed texture.

use super::{Color, Made, Paint, Specification, Texel, Texture, TexturePoint, made};
use crate::kinds::Resources;
use crate::math::{Step, Transform};
use crate::rgb::Rgb;
use crate::shapes::transform_of;

/// A texture that is translated, rotated, scaled or sheared relative to its object: the colour at a
/// local point p is that of the texture at M⁻¹p. The texture coordinates and the triangles of a
/// mesh belong to the surface and are not transformed.
#[kind]
pub struct TextureInstance {
    /// The texture to transform; it may be an instance itself, whose steps are applied first.
    pub of: Paint,
    /// The steps, in the order in which they are applied, about the origin of the object's own
    /// coordinates.
    pub transform: Vec<Step>,
}

impl TextureInstance {
    /// A texture after these steps.
    pub fn new(of: impl Into<Paint>, transform: Vec<Step>) -> Self {
        Self { of: of.into(), transform }
    }
}

#[derive(Debug)]
struct TextureInstanceTexture {
    of: Color,
    transform: Transform,
}

impl Specification for TextureInstance {
    fn make(&self, resources: &mut Resources) -> Made {
        let transform = transform_of("transform", &self.transform)?;
        made(TextureInstanceTexture { of: self.of.build("of", resources)?, transform })
    }
}

impl TextureInstanceTexture {
    fn inside<'a>(&self, at: &TexturePoint<'a>) -> TexturePoint<'a> {
        at.moved_to(self.transform.inverse().point(at.local))
    }
}

impl Texture for TextureInstanceTexture {
    fn color(&self, at: &TexturePoint<'_>) -> Rgb {
        self.of.at(&self.inside(at))
    }

    fn number(&self, at: &TexturePoint<'_>) -> f64 {
        self.of.number(&self.inside(at))
    }

    fn texel(&self, at: &TexturePoint<'_>) -> Option<Texel> {
        self.of.texel(&self.inside(at))
    }
}
