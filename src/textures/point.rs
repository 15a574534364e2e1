//! Where textures are asked for their colours.

use crate::math::Point;
use crate::shapes::{Candidate, Facet, Shape, Surface};

/// A point of a surface, with what textures may ask of it: a hit, or a point drawn on a lamp.
#[derive(Clone, Copy, Debug)]
pub struct TexturePoint<'a> {
    /// The surface there.
    pub surface: &'a Surface,
    /// The point in the coordinates of the texture: the surface's local point, moved by texture
    /// instances.
    pub local: Point,
    details: Details<'a>,
}

/// What is worked out only when a texture asks.
#[derive(Clone, Copy, Debug)]
enum Details<'a> {
    /// Texture coordinates that are known, if there are any.
    Known(Option<[f64; 2]>),
    /// Those of a shape at this hit.
    Of(&'a dyn Shape, &'a Candidate),
}

impl<'a> TexturePoint<'a> {
    /// A point of a surface without texture coordinates.
    pub fn new(surface: &'a Surface) -> Self {
        Self { surface, local: surface.local, details: Details::Known(None) }
    }

    /// A point of a surface with these texture coordinates.
    pub fn with_uv(surface: &'a Surface, uv: [f64; 2]) -> Self {
        Self { details: Details::Known(Some(uv)), ..Self::new(surface) }
    }

    /// The hit of a shape.
    pub fn of_hit(surface: &'a Surface, shape: &'a dyn Shape, at: &'a Candidate) -> Self {
        Self { details: Details::Of(shape, at), ..Self::new(surface) }
    }

    /// The same point for a texture that is moved against its object.
    #[must_use]
    pub fn moved_to(self, local: Point) -> Self {
        Self { local, ..self }
    }

    /// The texture coordinates of the shape itself, if it has any, as meshes have.
    pub fn uv(&self) -> Option<[f64; 2]> {
        match self.details {
            Details::Known(uv) => uv,
            Details::Of(shape, at) => shape.uv(at),
        }
    }

    /// The triangle it is on, if it is on one.
    pub fn facet(&self) -> Option<Facet> {
        match self.details {
            Details::Known(_) => None,
            Details::Of(shape, at) => shape.facet(at),
        }
    }

    /// Which of the shapes nested in the object's it is on, as in [`Candidate::leaf`].
    pub fn leaf(&self) -> u64 {
        match self.details {
            Details::Known(_) => 0,
            Details::Of(_, at) => at.leaf,
        }
    }
}
