//! Texture points: the input of textures.

use crate::math::{Point, Vector};
use crate::shapes::{Candidate, Facet, Shape, Surface};

/// A point of a surface with the data for textures: a hit, or a sample point on an area light.
#[derive(Clone, Copy, Debug)]
pub struct TexturePoint<'a> {
    /// The surface at the point.
    pub surface: &'a Surface,
    /// The point in the coordinates of the texture: the surface's local point, transformed by
    /// texture instances.
    pub local: Point,
    details: Details<'a>,
}

/// Texture coordinates, computed only when a texture needs them.
#[derive(Clone, Copy, Debug)]
enum Details<'a> {
    /// Known texture coordinates, if there are any.
    Known(Option<[f64; 2]>),
    /// The texture coordinates of a shape at a hit, displaced by a vector in local coordinates.
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

    /// A hit of a shape.
    pub fn of_hit(surface: &'a Surface, shape: &'a dyn Shape, at: &'a Candidate) -> Self {
        Self { details: Details::Of(shape, at, Vector::ZERO), ..Self::new(surface) }
    }

    /// The same point of the surface with another `local` point, for texture instances.
    #[must_use]
    pub fn moved_to(self, local: Point) -> Self {
        Self { local, ..self }
    }

    /// The point displaced along the surface by a short vector in local coordinates, for finite
    /// differences.
    #[must_use]
    pub fn displaced(self, by: Vector) -> Self {
        let details = match self.details {
            Details::Of(shape, at, so_far) => Details::Of(shape, at, so_far + by),
            known @ Details::Known(_) => known,
        };
        Self { local: self.local + by, details, ..self }
    }

    /// The texture coordinates of the shape; `None` if it has none. Meshes may have them.
    pub fn uv(&self) -> Option<[f64; 2]> {
        match self.details {
            Details::Known(uv) => uv,
            Details::Of(shape, at, by) => shape.facet(at, by)?.uv(),
        }
    }

    /// The triangle of the point, if one is hit.
    pub fn facet(&self) -> Option<Facet> {
        match self.details {
            Details::Known(_) => None,
            Details::Of(shape, at, by) => shape.facet(at, by),
        }
    }

    /// The index of the nested shape of the point, as in [`Candidate::leaf`].
    pub fn leaf(&self) -> u64 {
        match self.details {
            Details::Known(_) => 0,
            Details::Of(_, at, _) => at.leaf,
        }
    }
}
