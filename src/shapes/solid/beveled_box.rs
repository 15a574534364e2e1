//! The beveled box (Suffern, ch. 21): the union of 6 rectangles, 12 edges and 8 corners.
//!
//! With the bevel `r_b` the inner box is `[min + r_b, max − r_b]`. The surface is all points at the
//! distance `r_b` from it: a rectangle beside each face of the inner box, a quarter of a cylinder
//! of radius `r_b` about each edge, an eighth of a sphere about each corner. (The book takes whole
//! cylinders and spheres: see [`edges`](super::edges).)

use super::edges::{Named, check_bevel, corner, inset, left_of, quarter, wall};
use crate::invalid::Invalid;
use crate::math::{Length, Point, Step, Vector};
use crate::shapes::composite::assembly::{Materials, solid};
use crate::shapes::{Context, Instance, Made, Rectangle, Specification};

/// A box with round edges and corners: the points at most `bevel` away from the box that is smaller
/// by `bevel` on each side. Its parts are the six faces `left`, `right`, `bottom`, `top`, `back`
/// and `front`, twelve `edges` and eight `corners`, 26 in all; normals point outward.
#[kind(PartialEq)]
pub struct BeveledBox {
    /// The corner with the least coordinates.
    pub min: Point,
    /// The corner with the largest coordinates, each above that of `min`.
    pub max: Point,
    /// The radius of the edges: at most half of the shortest side.
    pub bevel: Length,
    /// The names of materials of parts that have one of their own, as `{ wall = "red" }`.
    #[optional]
    pub materials: Materials,
}

/// The lower and the higher end of an axis, and the sign of the outward direction there.
const ENDS: [(usize, f64); 2] = [(0, -1.0), (1, 1.0)];

impl BeveledBox {
    pub(super) fn check(&self) -> Result<(), Invalid> {
        let Self { min, max, bevel, .. } = *self;
        for (i, axis) in ["x", "y", "z"].into_iter().enumerate() {
            let (low, high) = (min.along(i), max.along(i));
            if low >= high {
                let problem = format!("found {axis} = {high}, but it must be above min's, {low}");
                return Err(Invalid::field("max", problem));
            }
        }
        let largest = min.to_vector().max_abs().max(max.to_vector().max_abs());
        let names = ["side along x", "side along y", "side along z"];
        let extents: [_; 3] = std::array::from_fn(|i| (names[i], self.extent(i)));
        check_bevel(bevel, largest, &extents)
    }

    fn extent(&self, axis: usize) -> [f64; 2] {
        [self.min.along(axis), self.max.along(axis)]
    }

    /// The ends of the inner box along this axis.
    fn inner(&self, axis: usize) -> [f64; 2] {
        inset(self.extent(axis), self.bevel)
    }

    /// The extent of the inner box along this axis, unless it is zero.
    fn left(&self, axis: usize) -> Option<[f64; 2]> {
        left_of(self.extent(axis), self.bevel)
    }

    fn faces(&self) -> Vec<Named> {
        const NAMES: [[&str; 2]; 3] = [["left", "right"], ["bottom", "top"], ["back", "front"]];
        let mut faces = Vec::new();
        for (axis, names) in NAMES.into_iter().enumerate() {
            let (first, second) = ((axis + 1) % 3, (axis + 2) % 3);
            let (Some([a0, a1]), Some([b0, b1])) = (self.left(first), self.left(second)) else {
                continue;
            };
            for ((end, sign), name) in ENDS.into_iter().zip(names) {
                let corner = Point::ORIGIN
                    .with(axis, self.extent(axis)[end])
                    .with(first, a0)
                    .with(second, b0);
                let (a, b) = ((a1 - a0) * unit(first), (b1 - b0) * unit(second));
                // unit(first) × unit(second) = unit(axis)
                let (a, b) = if sign > 0.0 { (a, b) } else { (b, a) };
                faces.push((name, Rectangle { corner, a, b }.into()));
            }
        }
        faces
    }

    /// A quarter of a cylinder along each edge of the inner box.
    fn edges(&self) -> Vec<Named> {
        let mut edges = Vec::new();
        for (axis, [first, second]) in [[1, 2], [0, 2], [0, 1]].into_iter().enumerate() {
            let Some(ends) = self.left(axis) else { continue };
            for ((i, u), (j, v)) in ENDS.into_iter().flat_map(|a| ENDS.map(|b| (a, b))) {
                let (turn, phi) = match axis {
                    0 => (Some(Step::RotateZ(-90.0)), quarter(-u, v)), // y → x, x → −y
                    1 => (None, quarter(u, v)),
                    _ => (Some(Step::RotateX(90.0)), quarter(u, -v)), // y → z, z → −y
                };
                let place =
                    self.inner(first)[i] * unit(first) + self.inner(second)[j] * unit(second);
                let steps = turn.into_iter().chain([Step::Translate(place)]).collect();
                edges.push(("edges", Instance::new(wall(ends, self.bevel, phi), steps).into()));
            }
        }
        edges
    }

    /// An eighth of a sphere about each corner of the inner box.
    fn corners(&self) -> Vec<Named> {
        let [x, y, z] = [0, 1, 2].map(|axis| self.inner(axis));
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

fn unit(axis: usize) -> Vector {
    [Vector::X, Vector::Y, Vector::Z][axis]
}

impl Specification for BeveledBox {
    fn make(&self, context: &mut Context) -> Made {
        self.check()?;
        let parts = [self.faces(), self.edges(), self.corners()].concat();
        solid(&parts, &self.materials, None, context)
    }
}
