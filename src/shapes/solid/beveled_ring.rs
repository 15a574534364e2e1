//! The beveled ring (Suffern, ch. 21): the union of two annuli, two walls and four quarters of
//! tori.
//!
//! With radii `r0 < r1` and bevel `r_b` the annuli at `y0` and `y1` go from `r0 + r_b` to
//! `r1 − r_b`, the walls from `y0 + r_b` to `y1 − r_b`, and the tori have `a = r0 + r_b` or
//! `r1 − r_b`, and `b = r_b`.

use super::edges::{Named, check_bevel, inset, left_of, moved, tube};
use crate::math::{Coordinate, Length, Point, Vector};
use crate::shapes::composite::assembly::{Materials, solid};
use crate::shapes::part::angles::full_turn;
use crate::shapes::plain::annulus::radii;
use crate::shapes::{Annulus, Context, Made, OpenCylinder, Specification};

/// A thick ring with round edges, as the parts `bottom`, `top`, `inner_wall`, `outer_wall` and four
/// `edges`; normals point out of the ring.
#[kind(PartialEq)]
pub struct BeveledRing {
    /// The height of the bottom.
    pub y0: Coordinate,
    /// The height of the top, above `y0`.
    pub y1: Coordinate,
    /// The radius of the hole; positive.
    pub inner_radius: Length,
    /// The outer radius, above `inner_radius`.
    pub outer_radius: Length,
    /// The radius of the edges: at most half of the height and of the distance between the radii.
    pub bevel: Length,
    /// The names of materials of parts that have one of their own, as `{ wall = "red" }`.
    #[optional]
    pub materials: Materials,
}

impl Specification for BeveledRing {
    fn make(&self, context: &mut Context) -> Made {
        let Self { y0, y1, inner_radius, outer_radius, bevel, .. } = *self;
        radii(inner_radius, outer_radius)?;
        // names the height that does not fit
        OpenCylinder { y0, y1, radius: outer_radius, inward: false }.checked()?;
        let extents =
            [("height", [y0, y1]), ("distance between the radii", [inner_radius, outer_radius])];
        let largest = y0.abs().max(y1.abs()).max(outer_radius);
        check_bevel(bevel, largest, &extents)?;
        let mut parts: Vec<Named> = Vec::new();
        let radii = [inner_radius, outer_radius];
        if let Some([inner_radius, outer_radius]) = left_of(radii, bevel) {
            for (name, y, normal) in [("bottom", y0, -Vector::Y), ("top", y1, Vector::Y)] {
                let center = Point::new(0.0, y, 0.0);
                parts.push((name, Annulus { center, normal, inner_radius, outer_radius }.into()));
            }
        }
        if let Some([y0, y1]) = left_of([y0, y1], bevel) {
            let wall = |radius, inward| OpenCylinder { y0, y1, radius, inward }.into();
            parts.push(("inner_wall", wall(inner_radius, true)));
            parts.push(("outer_wall", wall(outer_radius, false)));
        }
        let [low, high] = inset([y0, y1], bevel);
        let [near, far] = inset(radii, bevel);
        for (swept, y, theta) in [
            (far, high, [0.0, 90.0]),
            (near, high, [90.0, 180.0]),
            (near, low, [180.0, 270.0]),
            (far, low, [270.0, 360.0]),
        ] {
            let edge = tube(swept, bevel, full_turn(), theta);
            parts.push(("edges", moved(edge, y * Vector::Y)));
        }
        solid(&parts, &self.materials, None, context)
    }
}
