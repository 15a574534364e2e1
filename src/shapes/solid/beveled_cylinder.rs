//! The beveled cylinder (Suffern, ch. 21): the union of two disks, a wall and two round edges.
//!
//! With radius `r` and bevel `r_b` the disks at `y0` and `y1` have the radius `r − r_b`, the wall
//! goes from `y0 + r_b` to `y1 − r_b`, and the edges are parts of tori with `a = r − r_b` and
//! `b = r_b`. Where `b > a` such a torus meets itself; so each edge is a [`Shoulder`], which is the
//! same surface.

use std::sync::Arc;

use super::edges::{Named, check_bevel, inset, left_of, tube};
use super::shoulder::Shoulder;
use crate::invalid::{Invalid, shown};
use crate::kinds::Custom;
use crate::math::{Axis, Coordinate, Length, Point, Step, Vector};
use crate::shapes::composite::assembly::{Materials, solid};
use crate::shapes::part::angles::full_turn;
use crate::shapes::{Context, Disk, Instance, Kind, Made, OpenCylinder, Specification};

/// A solid cylinder with round edges, as the parts `bottom`, `top`, `wall`, `bottom_edge` and
/// `top_edge`; normals point outward. With a bevel as large as the radius it has hemispheres for
/// ends, and figure 21.13's is a sphere.
#[kind(PartialEq)]
pub struct BeveledCylinder {
    /// The height of the bottom.
    pub y0: Coordinate,
    /// The height of the top, above `y0`.
    pub y1: Coordinate,
    /// The radius; positive.
    pub radius: Length,
    /// The radius of the edges: at most the radius and half of the height.
    pub bevel: Length,
    /// The names of materials of parts that have one of their own, as `{ wall = "red" }`.
    #[optional]
    pub materials: Materials,
}

impl Specification for BeveledCylinder {
    fn make(&self, context: &mut Context) -> Made {
        let Self { y0, y1, radius, bevel, .. } = *self;
        let wall = OpenCylinder { y0, y1, radius, inward: false }.checked()?;
        let largest = y0.abs().max(y1.abs()).max(radius);
        check_bevel(bevel, largest, &[("height", [y0, y1])])?;
        if bevel > radius {
            let [found, most] = [bevel, radius].map(shown);
            let problem = format!("found {found}, but at most {most} fits, the radius");
            return Err(Invalid::field("bevel", problem));
        }
        let flat = radius - bevel;
        let [low, high] = inset([y0, y1], bevel);
        let mut parts: Vec<Named> = Vec::new();
        if flat > 0.0 {
            for (name, y, normal) in [("bottom", y0, -Vector::Y), ("top", y1, Vector::Y)] {
                let center = Point::new(0.0, y, 0.0);
                parts.push((name, Disk { center, normal, radius: flat }.into()));
            }
        }
        if let Some([y0, y1]) = left_of([y0, y1], bevel) {
            parts.push(("wall", OpenCylinder { y0, y1, ..wall }.into()));
        }
        // a torus that meets itself is no part torus
        let by_the_book = context.textbook().is_some() && bevel < flat;
        let edge = |steps| {
            let edge = if by_the_book {
                tube(flat, bevel, full_turn(), [0.0, 90.0])
            } else {
                Kind::Custom(Custom(Arc::new(Shoulder { a: flat, b: bevel })))
            };
            Kind::from(Instance::new(edge, steps))
        };
        let up = |y: f64| Step::Translate(y * Vector::Y);
        parts.push(("bottom_edge", edge(vec![Step::Reflect(Axis::Y), up(low)])));
        parts.push(("top_edge", edge(vec![up(high)])));
        solid(&parts, &self.materials, None, context)
    }
}
