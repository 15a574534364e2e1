//! The rosette (Suffern, ch. 21): a compound of rings of beveled wedges, as in a stone floor.
//!
//! Ring `i` goes from the radius `hole_radius + i ring_width` to the next; its `n` wedges are
//! `360/n` degrees wide each. The book's wedges touch; here a narrow joint is between them.

use super::beveled_wedge::BeveledWedge;
use super::edges::{Named, check_fits, half_joint, inset};
use crate::accel::Method;
use crate::invalid::Invalid;
use crate::math::{Coordinate, Length, to_degrees};
use crate::shapes::composite::assembly::{Materials, solid};
use crate::shapes::{Context, Made, Specification};

/// How many wedges each ring has, from the innermost.
const WEDGES: [u32; 6] = [10, 12, 15, 18, 24, 36];
const NAMES: [&str; 6] = ["ring_1", "ring_2", "ring_3", "ring_4", "ring_5", "ring_6"];

/// Rings of 10, 12, 15, 18, 24 and 36 beveled wedges about a hole, as the parts `ring_1` (the
/// innermost) to `ring_6`; normals point outward. Between the wedges are joints, about a thousandth
/// of the bevel wide.
#[kind(PartialEq)]
pub struct Rosette {
    /// How many rings there are: from 1 to 6.
    pub rings: u32,
    /// The radius of the hole in the middle; positive.
    pub hole_radius: Length,
    /// From the inner to the outer wall of each ring; positive.
    pub ring_width: Length,
    /// The radius of the wedges' edges: positive, at most half of the height, of the ring's width
    /// and of the width of a wedge's inner wall.
    pub bevel: Length,
    /// The height of the bottom.
    pub y0: Coordinate,
    /// The height of the top, above `y0`.
    pub y1: Coordinate,
    /// How rays find the wedges, `"grid"` in the book; as the scene if left out.
    pub accel: Option<Method>,
    /// The names of materials of rings that have one of their own, as `{ ring_1 = "red" }`.
    #[optional]
    pub materials: Materials,
}

impl Rosette {
    /// The wedges of a ring; the innermost is ring 0.
    fn ring(&self, ring: u32) -> impl Iterator<Item = BeveledWedge> {
        let Self { rings, bevel, y0, y1, .. } = *self;
        let radius = |ring: u32| self.hole_radius + f64::from(ring) * self.ring_width;
        let half = half_joint(bevel);
        let inner_radius = if ring == 0 { radius(0) } else { radius(ring) + half };
        let outer_radius = if ring + 1 == rings { radius(rings) } else { radius(ring + 1) - half };
        let count = WEDGES[ring as usize];
        let azimuth = move |wedge: u32| f64::from(wedge) * 360.0 / f64::from(count);
        let wedge = move |i| BeveledWedge {
            y0,
            y1,
            inner_radius,
            outer_radius,
            phi: inset([azimuth(i), azimuth(i + 1)], to_degrees(half / (inner_radius + bevel))),
            bevel,
            materials: Materials::new(),
        };
        (0..count).map(wedge)
    }
}

impl Specification for Rosette {
    fn make(&self, context: &mut Context) -> Made {
        if !(1..=6).contains(&self.rings) {
            let problem = format!("found {}, but from 1 to 6 rings are needed", self.rings);
            return Err(Invalid::field("rings", problem));
        }
        check_fits(self.bevel, &[("width of a ring", [0.0, self.ring_width])])?;
        let mut parts: Vec<Named> = Vec::new();
        for ring in 0..self.rings {
            for wedge in self.ring(ring) {
                wedge.checked()?; // names the field that does not fit
                parts.push((NAMES[ring as usize], wedge.into()));
            }
        }
        solid(&parts, &self.materials, self.accel, context)
    }
}
