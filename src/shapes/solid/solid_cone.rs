//! The solid cone (Suffern, ch. 19): the points with `(h/r)² (x² + z²) ≤ (h − y)²` and `0 ≤ y ≤ h`.
//!
//! Its surface is a compound of a disk, at y = 0, and an open cone, as in the book.

use crate::math::{Length, Point, Vector};
use crate::shapes::composite::assembly::{Materials, solid};
use crate::shapes::{Cone, Context, Disk, Kind, Made, Specification};

/// The points with `√(x² + z²) ≤ radius (1 − y/height)` and `y ≥ 0`, as the parts `base` and
/// `wall`; normals point outward.
#[kind(PartialEq)]
pub struct SolidCone {
    /// The height of the apex above the base, which is in the plane y = 0; positive.
    pub height: Length,
    /// The radius of the base; positive.
    pub radius: Length,
    /// The names of materials of parts that have one of their own, as `{ wall = "red" }`.
    #[optional]
    pub materials: Materials,
}

impl Specification for SolidCone {
    fn make(&self, context: &mut Context) -> Made {
        let Self { height, radius, .. } = *self;
        let wall = Cone { height, radius, inward: false };
        wall.build(context)?; // names the field that does not fit
        let base = Disk { center: Point::ORIGIN, normal: -Vector::Y, radius };
        let parts = [("base", Kind::from(base)), ("wall", Kind::from(wall))];
        solid(&parts, &self.materials, None, context)
    }
}
