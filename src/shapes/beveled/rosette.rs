//! The rosette (Suffern, ch. 21): rings of beveled wedges, as in a stone floor.

use std::sync::Arc;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::beveled_wedge::heights;
use super::edges::{Named, overlap, rounding, uncovered, widened};
use super::wedge_parts::{Sides, Wedge};
use crate::accel::Method;
use crate::invalid::{Invalid, length};
use crate::kinds::Specification;
use crate::shapes::composite::assembly::{Materials, smooth_solid};
use crate::shapes::{Context, Shape};

/// How many wedges each ring has, from the innermost.
const WEDGES: [u32; 6] = [10, 12, 15, 18, 24, 36];
const NAMES: [&str; 6] = ["ring_1", "ring_2", "ring_3", "ring_4", "ring_5", "ring_6"];

/// Rings of 10, 12, 15, 18, 24 and 36 beveled wedges about a hole, as the parts `ring_1` (the
/// innermost) to `ring_6`; normals point outward.
///
/// Wedges touch. Where they do, the book's have two faces in one place, and a ray that leaves one
/// would be in the other; here such faces are left out, so that the rosette is one solid.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Rosette {
    /// How many rings there are: from 1 to 6.
    pub rings: u32,
    /// The radius of the hole in the middle; positive.
    pub hole_radius: f64,
    /// From the inner to the outer wall of each ring; positive.
    pub ring_width: f64,
    /// The radius of the wedges' edges: positive, at most half of the height, of the ring's width and of
    /// what the inner wall of a wedge is wide.
    pub bevel: f64,
    /// The height of the bottom.
    pub y0: f64,
    /// The height of the top, above `y0`.
    pub y1: f64,
    /// How rays find its parts, `"grid"` in the book; as the scene if left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub accel: Option<Method>,
    /// The names of materials of rings that have one of their own, as `{ ring_1 = "red" }`.
    #[serde(default, skip_serializing_if = "Materials::is_empty")]
    pub materials: Materials,
}

impl Rosette {
    /// The wedges of a ring, the innermost being 0.
    fn wedges(&self, ring: u32) -> Vec<Wedge> {
        let radius = |rings: u32| self.hole_radius + f64::from(rings) * self.ring_width;
        let count = WEDGES[ring as usize];
        let azimuth = |wedge: u32| f64::from(wedge) * (360.0 / f64::from(count));
        // into the stones that it touches: see [`Archway`](super::archway)
        let largest = self.y0.abs().max(self.y1.abs()).max(radius(ring + 1));
        let over = 0.5 * overlap(largest, self.bevel);
        let [inside, outside] =
            [ring > 0, ring + 1 < self.rings].map(|t| if t { over } else { 0.0 });
        let wedge = |i| Wedge {
            y: [self.y0, self.y1],
            r: [radius(ring) - inside, radius(ring + 1) + outside],
            phi: widened([azimuth(i), azimuth(i + 1)], over, radius(ring)),
            bevel: self.bevel,
        };
        (0..count).map(wedge).collect()
    }

    /// What of the walls between a ring and the next can be seen in the grooves of the other.
    fn walls_between(&self, ring: u32) -> Vec<Named> {
        let (inside, outside) = (self.wedges(ring), self.wedges(ring + 1));
        let Some(y) = inside[0].heights() else { return Vec::new() };
        let convex: Vec<[f64; 2]> = inside.iter().filter_map(Wedge::outer_wall).collect();
        let concave: Vec<[f64; 2]> = outside.iter().filter_map(Wedge::inner_wall).collect();
        let (name, next) = (NAMES[ring as usize], NAMES[ring as usize + 1]);
        let convex_left = uncovered(&convex, &concave).into_iter();
        let concave_left = uncovered(&concave, &convex).into_iter();
        convex_left
            .map(|phi| (name, inside[0].wall(y, inside[0].r[1], phi, false)))
            .chain(concave_left.map(|phi| (next, outside[0].wall(y, outside[0].r[0], phi, true))))
            .collect()
    }
}

impl Specification for Rosette {
    type Built = Arc<dyn Shape>;
    type Context = Context;

    fn build(&self, context: &mut Context) -> Result<Arc<dyn Shape>, Invalid> {
        if !(1..=6).contains(&self.rings) {
            let problem = format!("found {}, but from 1 to 6 rings are needed", self.rings);
            return Err(Invalid::field("rings", problem));
        }
        length("hole_radius", self.hole_radius)?;
        length("ring_width", self.ring_width)?;
        length("bevel", self.bevel)?;
        heights(self.y0, self.y1)?;
        let mut parts: Vec<Named> = Vec::new();
        for ring in 0..self.rings {
            let is_last = ring + 1 == self.rings;
            let seen = Sides { inner_wall: ring == 0, outer_wall: is_last, ends: false };
            for wedge in self.wedges(ring) {
                wedge.check()?;
                let name = NAMES[ring as usize];
                parts.extend(wedge.parts(seen).into_iter().map(|(_, part)| (name, part)));
            }
            if !is_last {
                parts.extend(self.walls_between(ring));
            }
        }
        let rounding = rounding(self.wedges(self.rings - 1)[0].largest());
        smooth_solid(&parts, &self.materials, self.accel, rounding, context)
    }

    fn scaled(&self, factor: f64) -> Self {
        let lengths = [self.hole_radius, self.ring_width, self.bevel, self.y0, self.y1];
        let [hole_radius, ring_width, bevel, y0, y1] = lengths.map(|length| factor * length);
        let materials = self.materials.clone();
        Self { hole_radius, ring_width, bevel, y0, y1, materials, ..*self }
    }

    fn specimens() -> Vec<Self> {
        let rosette = |rings, hole_radius, bevel, accel| Self {
            rings,
            hole_radius,
            ring_width: 1.0,
            bevel,
            y0: -0.25,
            y1: 0.25,
            accel,
            materials: Materials::new(),
        };
        vec![rosette(3, 0.75, 0.1, None), rosette(1, 1.25, 0.125, Some(Method::Bvh))]
    }
}
