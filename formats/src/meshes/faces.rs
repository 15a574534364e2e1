//! The faces of a mesh file: polygons, and their triangulation.
//!
//! A convex polygon becomes a triangle fan around its first corner. Any other polygon is
//! triangulated by ear clipping (Meisters, *Polygons have ears*, American Mathematical Monthly 82,
//! 1975): an ear is a triangle of three consecutive corners that lies inside the polygon and
//! contains no other corner. Every side of the polygon becomes a side of one triangle, also where
//! corners are collinear: a triangle that skipped such a corner would leave a crack beside the
//! neighbouring face. `earcut` 0.4 skips collinear corners, so it is not used.

use std::iter::repeat_n;

use super::notes::{FEW_CORNERS, Tally};
use super::{Location, MeshFileError};

/// The largest number of corners of a polygon that is not convex: the time of ear clipping can grow
/// as the cube of this number.
const MAX_CORNERS: usize = 10_000;

const TWO_TO_600: f64 = f64::from_bits((600 + 1023) << 52);

/// Polygons, as indices into a list of vertices.
#[derive(Default)]
pub(super) struct Faces {
    corners: Vec<u32>,
    /// For each polygon the end of its range of `corners`; an empty range where one was left out.
    ends: Vec<usize>,
    left_out: Tally,
}

impl Faces {
    /// Makes room for this many triangles.
    pub(super) fn reserve(&mut self, triangles: usize) {
        self.corners.reserve_exact(3 * triangles);
        self.ends.reserve_exact(triangles);
    }

    /// Appends a polygon; one of fewer than three corners is left out. Whether it was appended.
    pub(super) fn push(&mut self, corners: &[u32], location: impl FnOnce() -> Location) -> bool {
        let is_polygon = corners.len() >= 3;
        if is_polygon {
            self.corners.extend(corners);
        } else {
            self.left_out.add(location);
        }
        self.ends.push(self.corners.len());
        is_polygon
    }

    /// Appends the triangles of a strip: each corner after the second makes one with the two before
    /// it, wound like the first. Triangles that name a vertex twice only join strips.
    pub(super) fn push_strip(&mut self, strip: &[u32], location: impl FnOnce() -> Location) {
        if matches!(strip.len(), 1 | 2) {
            self.left_out.add(location);
        }
        for (index, corners) in strip.windows(3).enumerate() {
            let [a, b, c] = [corners[0], corners[1], corners[2]];
            if a != b && b != c && c != a {
                self.corners.extend(if index % 2 == 0 { [a, b, c] } else { [b, a, c] });
                self.ends.push(self.corners.len());
            }
        }
    }

    /// The vertices of all corners, polygon after polygon.
    pub(super) fn corners(&self) -> &[u32] {
        &self.corners
    }

    /// The vertices of all corners, to be renumbered.
    pub(super) fn corners_mut(&mut self) -> &mut [u32] {
        &mut self.corners
    }

    /// Appends the note on the polygons that were left out.
    pub(super) fn note(&self, notes: &mut Vec<String>) {
        self.left_out.note(notes, FEW_CORNERS);
    }

    /// The triangles of all polygons, with the winding of the polygons; a polygon of n corners has
    /// n − 2. The triangles of a polygon that crosses itself are unspecified.
    pub(super) fn triangles(&self, vertices: &[[f64; 3]]) -> Result<Vec<[u32; 3]>, MeshFileError> {
        let count = self.counts().map(|corners| corners.saturating_sub(2)).sum();
        let mut triangles = Vec::with_capacity(count);
        let mut start = 0;
        for (index, &end) in self.ends.iter().enumerate() {
            let corners = &self.corners[start..end];
            start = end;
            if corners.is_empty() {
                continue;
            }
            if let &[a, b, c] = corners {
                triangles.push([a, b, c]);
                continue;
            }
            let ring = Ring::new(corners, vertices);
            if ring.is_fan() {
                triangles.extend(fan(corners));
            } else if corners.len() <= MAX_CORNERS {
                ring.clip_ears(&mut triangles);
            } else {
                let location = Location::Element { name: "face".into(), index: index as u64 };
                let (count, max) = (corners.len(), MAX_CORNERS);
                return Err(MeshFileError::ManyCorners { location, count, max });
            }
        }
        Ok(triangles)
    }

    /// For each triangle the number of its polygon; empty if all are triangles.
    pub(super) fn of_triangles(&self) -> Vec<u32> {
        if self.counts().all(|corners| matches!(corners, 0 | 3)) {
            return Vec::new();
        }
        let counts = (0..).zip(self.counts());
        counts.flat_map(|(face, corners)| repeat_n(face, corners.saturating_sub(2))).collect()
    }

    /// The number of corners of each polygon; 0 where one was left out.
    fn counts(&self) -> impl Iterator<Item = usize> {
        let starts = [0].into_iter().chain(self.ends.iter().copied());
        self.ends.iter().zip(starts).map(|(end, start)| end - start)
    }
}

fn fan<T: Copy>(corners: &[T]) -> impl Iterator<Item = [T; 3]> {
    corners[1..].windows(2).map(|side| [corners[0], side[0], side[1]])
}

/// A corner of a polygon, and its projection to a coordinate plane in which the polygon is
/// counter-clockwise.
#[derive(Clone, Copy)]
struct Corner {
    vertex: u32,
    position: [f64; 2],
}

/// The corners of a polygon that ear clipping has not removed yet.
struct Ring(Vec<Corner>);

impl Ring {
    /// Projects to the coordinate plane in which the polygon has the largest area. This copies two
    /// coordinates of each vertex without rounding, so collinear corners stay collinear.
    fn new(corners: &[u32], vertices: &[[f64; 3]]) -> Self {
        let points = corners.iter().map(|&corner| vertices[corner as usize]);
        let largest = points.clone().flatten().fold(0.0, |most: f64, x| most.max(x.abs()));
        // prevents overflow and underflow of areas; exact, because it is a power of two
        let unit = match largest {
            ..1e-100 => TWO_TO_600,
            1e100.. => 1.0 / TWO_TO_600,
            _ => 1.0,
        };
        let points: Vec<_> = points.map(|point| point.map(|x| unit * x)).collect();
        let projected_along = |axis: usize, p: [f64; 3]| [p[(axis + 1) % 3], p[(axis + 2) % 3]];
        let areas = [0, 1, 2].map(|axis| {
            let projected = |triangle: [_; 3]| triangle.map(|p| projected_along(axis, p));
            fan(&points).map(|triangle| doubled_area(projected(triangle))).sum::<f64>()
        });
        let largest = |a: &usize, b: &usize| areas[*a].abs().total_cmp(&areas[*b].abs());
        let axis = (0..3).max_by(largest).expect("three axes");
        let corner = |(&vertex, &point)| {
            let [x, y] = projected_along(axis, point);
            Corner { vertex, position: if areas[axis] < 0.0 { [y, x] } else { [x, y] } }
        };
        Self(corners.iter().zip(&points).map(corner).collect())
    }

    /// Whether all triangles of the fan around the first corner have a positive area.
    fn is_fan(&self) -> bool {
        fan(&self.0).all(|triangle| doubled_area(triangle.map(|corner| corner.position)) > 0.0)
    }

    /// Clips ears until a triangle is left. If there is no ear, the polygon crosses itself or has
    /// no area, and the rest becomes a fan.
    fn clip_ears(mut self, triangles: &mut Vec<[u32; 3]>) {
        let (mut at, mut tried) = (0, 0);
        while self.0.len() > 3 && tried < self.0.len() {
            at %= self.0.len();
            if let Some(ear) = self.ear(at) {
                triangles.push(ear.map(|corner| corner.vertex));
                self.0.remove(at);
                tried = 0;
            } else {
                at += 1;
                tried += 1;
            }
        }
        triangles.extend(fan(&self.0).map(|triangle| triangle.map(|corner| corner.vertex)));
    }

    /// The triangle of the corner and its neighbours, if it is an ear.
    fn ear(&self, at: usize) -> Option<[Corner; 3]> {
        let count = self.0.len();
        let ear = [at + count - 1, at, at + 1].map(|i| self.0[i % count]);
        let [a, b, c] = ear.map(|corner| corner.position);
        // a corner at the same position as a, b or c is the other end of a cut to a hole
        let inside = |p: [f64; 2]| {
            ![a, b, c].contains(&p)
                && [[a, b, p], [b, c, p], [c, a, p]].into_iter().all(|t| doubled_area(t) >= 0.0)
        };
        let is_ear =
            doubled_area([a, b, c]) > 0.0 && !self.0.iter().any(|corner| inside(corner.position));
        is_ear.then_some(ear)
    }
}

/// Twice the area, negative if the corners follow each other clockwise.
fn doubled_area([a, b, c]: [[f64; 2]; 3]) -> f64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}
