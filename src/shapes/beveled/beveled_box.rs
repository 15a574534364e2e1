//! The beveled box (Suffern, ch. 21).

use std::sync::Arc;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::edges::{Named, check_bevel, corner, extended, inset, overlap, quarter, rounding, wall};
use crate::invalid::{Invalid, finite_point};
use crate::kinds::Specification;
use crate::math::{Point, Step, Vector};
use crate::shapes::composite::assembly::{Materials, smooth_solid};
use crate::shapes::{Context, Instance, Kind, Rectangle, Shape};

/// A box with round edges and corners: the points at most `bevel` away from the box that is smaller
/// by `bevel` on each side. Its parts are the six faces `left`, `right`, `bottom`, `top`, `back` and
/// `front`, twelve `edges` and eight `corners`, 26 in all; normals point outward.
///
/// The book's edges and corners are whole cylinders and spheres, of which three quarters and seven
/// eighths are hidden inside; here they are the parts that can be seen.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BeveledBox {
    /// The corner with the least coordinates.
    pub min: Point,
    /// The corner with the largest coordinates, each above that of `min`.
    pub max: Point,
    /// The radius of the edges: at most half of the shortest side.
    pub bevel: f64,
    /// The names of materials of parts that have one of their own, as `{ wall = "red" }`.
    #[serde(default, skip_serializing_if = "Materials::is_empty")]
    pub materials: Materials,
}

impl Specification for BeveledBox {
    type Built = Arc<dyn Shape>;
    type Context = Context;

    fn build(&self, context: &mut Context) -> Result<Arc<dyn Shape>, Invalid> {
        let Self { min, max, bevel, .. } = *self;
        finite_point("min", min)?;
        finite_point("max", max)?;
        for (i, axis) in ["x", "y", "z"].into_iter().enumerate() {
            let (low, high) = (min.along(i), max.along(i));
            if low >= high {
                let problem = format!("found {axis} = {high}, but it must be above min's, {low}");
                return Err(Invalid::field("max", problem));
            }
        }
        let sides = ["side along x", "side along y", "side along z"];
        let extents = [0, 1, 2].map(|i| (sides[i], [min.along(i), max.along(i)]));
        let outer = extents.map(|(_, extent)| extent);
        check_bevel(bevel, largest(outer), &extents)?;
        let rounded = RoundedBox::new(outer, bevel);
        let parts: Vec<Named> =
            rounded.faces().into_iter().chain(rounded.edges()).chain(rounded.corners()).collect();
        smooth_solid(&parts, &self.materials, None, rounding(largest(outer)), context)
    }

    fn scaled(&self, factor: f64) -> Self {
        Self {
            min: self.min.scaled(factor),
            max: self.max.scaled(factor),
            bevel: factor * self.bevel,
            materials: self.materials.clone(),
        }
    }

    fn specimens() -> Vec<Self> {
        let beveled = |min, max, bevel| Self { min, max, bevel, materials: Materials::new() };
        vec![
            beveled(Point::new(-1.0, -1.0, -1.0), Point::new(1.0, 1.0, 1.0), 0.25),
            beveled(Point::new(0.25, -0.5, 1.0), Point::new(1.0, 0.7, 1.5), 0.125),
            beveled(Point::new(-0.5, 0.25, -1.0), Point::new(0.5, 0.75, 2.0), 0.25),
        ]
    }
}

/// The box within, on which the edges turn, and what is around it.
pub struct RoundedBox {
    /// From the lowest to the highest coordinate, along each axis.
    outer: [[f64; 2]; 3],
    inner: [[f64; 2]; 3],
    /// The same, for what reaches over a seam.
    reaching: [[f64; 2]; 3],
    bevel: f64,
}

/// The lower and the higher end of an axis.
const ENDS: [(usize, f64); 2] = [(0, -1.0), (1, 1.0)];

impl RoundedBox {
    /// The bevel fits.
    pub fn new(outer: [[f64; 2]; 3], bevel: f64) -> Self {
        let inner = outer.map(|extent| inset(extent, bevel));
        let reaching = inner.map(|extent| extended(extent, overlap(largest(outer), bevel)));
        Self { outer, inner, reaching, bevel }
    }

    /// What a bevel of half a side leaves of it, perhaps less than nothing by rounding, is no part.
    fn is_left(&self, axis: usize) -> bool {
        self.inner[axis][0] < self.inner[axis][1]
    }

    /// The faces that are not just an edge or a corner.
    pub fn faces(&self) -> Vec<Named> {
        const NAMES: [[&str; 2]; 3] = [["left", "right"], ["bottom", "top"], ["back", "front"]];
        let mut faces = Vec::new();
        for (axis, names) in NAMES.into_iter().enumerate() {
            let (first, second) = ((axis + 1) % 3, (axis + 2) % 3);
            if !(self.is_left(first) && self.is_left(second)) {
                continue;
            }
            for ((end, sign), name) in ENDS.into_iter().zip(names) {
                let mut corner = self.reaching.map(|[low, _]| low);
                corner[axis] = self.outer[axis][end];
                let [a, b] = [first, second].map(|side| {
                    let [low, high] = self.reaching[side];
                    (high - low) * along(side)
                });
                // the cross product of the next two axes is the axis itself
                let (a, b) = if sign > 0.0 { (a, b) } else { (b, a) };
                faces.push((name, Rectangle { corner: Point::from(corner), a, b }.into()));
            }
        }
        faces
    }

    /// A quarter of a cylinder along each edge.
    pub fn edges(&self) -> Vec<Named> {
        let [x, y, z] = self.inner;
        let reaching = self.reaching;
        let mut edges = Vec::new();
        let ends = || ENDS.into_iter().flat_map(|a| ENDS.map(|b| (a, b)));
        for ((i, first), (j, second)) in ends() {
            // turned from the y axis: x by y → x, x → −y; z by y → z, z → −y
            if self.is_left(0) {
                let place = Vector::new(0.0, y[i], z[j]);
                let turn = Step::RotateZ(-90.0);
                edges.push(self.edge(reaching[0], quarter(-first, second), Some(turn), place));
            }
            if self.is_left(1) {
                edges.push(self.edge(
                    reaching[1],
                    quarter(first, second),
                    None,
                    Vector::new(x[i], 0.0, z[j]),
                ));
            }
            if self.is_left(2) {
                let place = Vector::new(x[i], y[j], 0.0);
                let turn = Step::RotateX(90.0);
                edges.push(self.edge(reaching[2], quarter(first, -second), Some(turn), place));
            }
        }
        edges
    }

    fn edge(&self, ends: [f64; 2], phi: [f64; 2], turn: Option<Step>, place: Vector) -> Named {
        let upright = wall(ends, self.bevel, phi, false);
        let steps = turn.into_iter().chain([Step::Translate(place)]).collect();
        ("edges", Kind::from(Instance::new(upright, steps)))
    }

    /// An eighth of a sphere at each corner.
    pub fn corners(&self) -> Vec<Named> {
        let [x, y, z] = self.inner;
        let mut corners = Vec::new();
        for (i, right) in ENDS {
            for (j, up) in ENDS {
                for (k, front) in ENDS {
                    let center = Point::new(x[i], y[j], z[k]);
                    let eighth = corner(center, self.bevel, quarter(right, front), up > 0.0);
                    corners.push(("corners", eighth));
                }
            }
        }
        corners
    }
}

/// The largest coordinate.
fn largest(extents: [[f64; 2]; 3]) -> f64 {
    extents.into_iter().flatten().fold(0.0, |all: f64, c| all.max(c.abs()))
}

fn along(axis: usize) -> Vector {
    [Vector::X, Vector::Y, Vector::Z][axis]
}
