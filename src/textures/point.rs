//! Texture points: the input of textures.

use crate::math::{Point, Vector};
use crate::shapes::{Candidate, Facet, Shape, Surface};

/// A point of a surface with the data for textures: a hit, or a point drawn on a lamp.
#[derive(Clone, Copy, Debug)]
pub struct TexturePoint<'a> {
    /// The surface there.
    pub surface: &'a Surface,
    /// The point in the coordinates of the texture: the surface's local point, moved by texture
    /// instances.
    pub local: Point,
    details: Details<'a>,
}

/// Texture coordinates, computed only when a texture needs them.
#[derive(Clone, Copy, Debug)]
enum Details<'a> {
    /// Texture coordinates that are known, if there are any.
    Known(Option<[f64; 2]>),
    /// Those of a shape at this hit, or beside it by this vector in local coordinates.
    Of(&'a dyn Shape, &'a Candidate, Vector),
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
        Self { details: Details::Of(shape, at, Vector::ZERO), ..Self::new(surface) }
    }

    /// The same point for a texture that is moved against its object.
    #[must_use]
    pub fn moved_to(self, local: Point) -> Self {
        Self { local, ..self }
    }

    /// A point beside this one on the surface, for slopes: by a short vector in the surface's local
    /// coordinates.
    #[must_use]
    pub fn beside(self, by: Vector) -> Self {
        let details = match self.details {
            Details::Of(shape, at, so_far) => Details::Of(shape, at, so_far + by),
            known @ Details::Known(_) => known,
        };
        Self { local: self.local + by, details, ..self }
    }

    /// The texture coordinates of the shape itself, if it has any, as meshes have.
    pub fn uv(&self) -> Option<[f64; 2]> {
        match self.details {
            Details::Known(uv) => uv,
            Details::Of(shape, at, Vector::ZERO) => shape.uv(at),
            Details::Of(shape, at, by) => shape.uv(&shape.beside(at, by)),
        }
    }

    /// The triangle it is on, if it is on one.
    pub fn facet(&self) -> Option<Facet> {
        match self.details {
            Details::Known(_) => None,
            Details::Of(shape, at, Vector::ZERO) => shape.facet(at),
            Details::Of(shape, at, by) => shape.facet(&shape.beside(at, by)),
        }
    }

    /// Which of the shapes nested in the object's it is on, as in [`Candidate::leaf`].
    pub fn leaf(&self) -> u64 {
        match self.details {
            Details::Known(_) => 0,
            Details::Of(_, at, _) => at.leaf,
        }
    }
}
