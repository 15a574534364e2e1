//! The thick ring (Suffern, ch. 19), a solid cylinder with a hole: the points with
//! `r_in² ≤ x² + z² ≤ r_out²` and `y0 ≤ y ≤ y1`.
//!
//! Its surface is a compound of two annuli, at y0 and y1, and two open cylinders, as in the book.

use crate::math::{Coordinate, Length, Point, Vector};
use crate::shapes::composite::assembly::{Materials, solid};
use crate::shapes::plain::annulus::radii;
use crate::shapes::{Annulus, Context, Kind, Made, OpenCylinder, Specification};

/// The points from `inner_radius` to `outer_radius` away from the y axis with `y0 ≤ y ≤ y1`, as the
/// parts `bottom`, `top`, `inner_wall` and `outer_wall`; normals point out of the ring, those of
/// the inner wall to the axis.
#[kind(PartialEq)]
pub struct ThickRing {
    /// The height of the bottom.
    pub y0: Coordinate,
    /// The height of the top, above `y0`.
    pub y1: Coordinate,
    /// The radius of the hole; positive.
    pub inner_radius: Length,
    /// The outer radius, above `inner_radius`.
    pub outer_radius: Length,
    /// The names of materials of parts that have one of their own, as `{ wall = "red" }`.
    #[optional]
    pub materials: Materials,
}

impl Specification for ThickRing {
    fn make(&self, context: &mut Context) -> Made {
        let Self { y0, y1, inner_radius, outer_radius, .. } = *self;
        radii(inner_radius, outer_radius)?;
        let wall = |radius, inward| OpenCylinder { y0, y1, radius, inward };
        wall(outer_radius, false).checked()?; // names the height that does not fit
        let side = |y, normal| {
            let center = Point::new(0.0, y, 0.0);
            Kind::from(Annulus { center, normal, inner_radius, outer_radius })
        };
        let parts = [
            ("bottom", side(y0, -Vector::Y)),
            ("top", side(y1, Vector::Y)),
            ("inner_wall", wall(inner_radius, true).into()),
            ("outer_wall", wall(outer_radius, false).into()),
        ];
        solid(&parts, &self.materials, None, context)
    }
}
