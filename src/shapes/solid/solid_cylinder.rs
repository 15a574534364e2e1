//! The solid cylinder (Suffern, ch. 19): the points with `x² + z² ≤ r²` and `y0 ≤ y ≤ y1`.
//!
//! Its surface is a compound of two disks, at y0 and y1, and an open cylinder, as in the book.

use crate::math::{Coordinate, Length, Point, Vector};
use crate::shapes::composite::assembly::{Materials, solid};
use crate::shapes::{Context, Disk, Kind, Made, OpenCylinder, Specification};

/// The points with `x² + z² ≤ radius²` and `y0 ≤ y ≤ y1`, as the parts `bottom`, `top` and `wall`;
/// normals point outward.
#[kind(PartialEq)]
pub struct SolidCylinder {
    /// The height of the bottom.
    pub y0: Coordinate,
    /// The height of the top, above `y0`.
    pub y1: Coordinate,
    /// The radius; positive.
    pub radius: Length,
    /// The names of materials of parts that have one of their own, as `{ wall = "red" }`.
    #[optional]
    pub materials: Materials,
}

impl Specification for SolidCylinder {
    fn make(&self, context: &mut Context) -> Made {
        let Self { y0, y1, radius, .. } = *self;
        let wall = OpenCylinder { y0, y1, radius, inward: false };
        wall.build(context)?; // names the field that does not fit
        let cap = |y, normal| Disk { center: Point::new(0.0, y, 0.0), normal, radius };
        let parts = [
            ("bottom", Kind::from(cap(y0, -Vector::Y))),
            ("top", Kind::from(cap(y1, Vector::Y))),
            ("wall", Kind::from(wall)),
        ];
        solid(&parts, &self.materials, None, context)
    }
}
