//! Vertex normals of meshes (Suffern, ch. 23): `n = Σ n_i / |Σ n_i|` over the normals `n_i` of the
//! faces around the vertex, unweighted; (0, 1, 0) where the sum is zero. Also the winding of
//! triangles.
//!
//! The book's faces are triangles. Here a polygon of the file is one face, whatever its number of
//! triangles, so that the normal does not depend on how the polygon was split.

use std::ops::Add;

use crate::math::watertight;
use crate::math::{Normal, Point, Vector};

/// The vertex normals. Consecutive triangles with the same index in `faces` are one face; if
/// `faces` is empty, each triangle is one.
pub fn mean_normals(vertices: &[Point], triangles: &[[u32; 3]], faces: &[u32]) -> Vec<Normal> {
    let corners = |triangle: [u32; 3]| triangle.map(|vertex| vertices[vertex as usize]);
    let mut sums = vec![Vector::ZERO; vertices.len()];
    let mut add = |face: &[[u32; 3]]| {
        let normal = match *face {
            [triangle] => watertight::normal(corners(triangle)),
            _ => {
                let sum = face.iter().map(|&t| doubled_area(corners(t)));
                Normal::new(sum.fold(Vector::ZERO, Add::add))
            }
        };
        let Some(normal) = normal else { return };
        let mut around: Vec<u32> = face.iter().flatten().copied().collect();
        around.sort_unstable();
        around.dedup();
        around.into_iter().for_each(|vertex| sums[vertex as usize] += normal.into());
    };
    if faces.is_empty() {
        triangles.chunks(1).for_each(add);
    } else {
        let mut rest = triangles;
        for face in faces.chunk_by(|a, b| a == b) {
            let (first, others) = rest.split_at(face.len());
            add(first);
            rest = others;
        }
    }
    sums.into_iter().map(|sum| Normal::new(sum).unwrap_or(Normal::Y)).collect()
}

/// The vector `(b − a) × (c − a)`: along the normal, twice the area long.
fn doubled_area([a, b, c]: [Point; 3]) -> Vector {
    (b - a).cross(c - a)
}

/// Whether the vertex normals are on the back of most of the area.
pub fn are_opposed(vertices: &[Point], triangles: &[[u32; 3]], normals: &[Option<Normal>]) -> bool {
    let votes = triangles.iter().map(|triangle| {
        let given = triangle.iter().filter_map(|&vertex| normals[vertex as usize]);
        let sum = given.map(Vector::from).fold(Vector::ZERO, Add::add);
        doubled_area(triangle.map(|vertex| vertices[vertex as usize])).dot(sum)
    });
    votes.sum::<f64>() < 0.0
}

/// Reverses the winding of all triangles.
pub fn reverse_winding(triangles: &mut [[u32; 3]]) {
    for [_, b, c] in triangles {
        std::mem::swap(b, c);
    }
}
