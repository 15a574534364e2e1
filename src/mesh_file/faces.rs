//! The faces of a mesh file: polygons, and their triangulation.
//!
//! A convex polygon becomes a triangle fan around its first corner. Any other polygon is
//! triangulated by ear clipping (Meisters, *Polygons have ears*, American Mathematical Monthly 82,
//! 1975): an ear is a triangle of three consecutive corners that lies inside the polygon and
//! contains no other corner. Every side of the polygon becomes a side of one triangle, also where
//! corners are collinear: a triangle that skipped such a corner would leave a crack beside the
//! neighbouring face. `earcut` 0.4 skips collinear corners, so it is not used.

use std::iter::repeat_n;

use super::{Location, MeshFileError};

/// The largest number of corners of a polygon that is not convex: the time of ear clipping can grow
/// as the cube of this number.
const MAX_CORNERS: usize = 10_000;

const TWO_TO_600: f64 = f64::from_bits((600 + 1023) << 52);

/// Polygons, as indices into a list of vertices.
#[derive(Default)]
pub(super) struct Faces {
    corners: Vec<u32>,
    /// For each polygon the end of its range of `corners`.
    ends: Vec<usize>,
}

impl Faces {
    /// No polygons, with capacity for this many triangles.
    pub(super) fn with_capacity(triangles: usize) -> Self {
        Self { corners: Vec::with_capacity(3 * triangles), ends: Vec::with_capacity(triangles) }
    }

    /// Appends a polygon.
    pub(super) fn push(
        &mut self,
        corners: &[u32],
        location: impl FnOnce() -> Location,
    ) -> Result<(), MeshFileError> {
        if corners.len() < 3 {
            return Err(MeshFileError::FewCorners { location: location(), count: corners.len() });
        }
        self.corners.extend(corners);
        self.ends.push(self.corners.len());
        Ok(())
    }

    /// The triangles of all polygons, with the winding of the polygons; a polygon of n corners has
    /// n − 2. The triangles of a polygon that crosses itself are unspecified.
    pub(super) fn triangles(&self, vertices: &[[f64; 3]]) -> Result<Vec<[u32; 3]>, MeshFileError> {
        let mut triangles = Vec::with_capacity(self.corners.len() - 2 * self.ends.len());
        let mut start = 0;
        for (index, &end) in self.ends.iter().enumerate() {
            let corners = &self.corners[start..end];
            start = end;
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
        if self.corners.len() == 3 * self.ends.len() {
            return Vec::new();
        }
        let starts = [0].into_iter().chain(self.ends.iter().copied());
        let corners = self.ends.iter().zip(starts).map(|(end, start)| end - start);
        (0..).zip(corners).flat_map(|(face, corners)| repeat_n(face, corners - 2)).collect()
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
