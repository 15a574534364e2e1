//! Normals at the vertices of meshes (Suffern, ch. 23), and which way triangles are wound.

use std::ops::Add;

use crate::math::{Normal, Point, Vector};
use crate::mesh_bvh::watertight;

/// For each vertex the normalised sum of the normals of its faces; (0, 1, 0) where the sum is zero.
/// Triangles in a row with the same number in `faces` are one face, and without numbers each is one.
pub fn mean_normals(vertices: &[Point], triangles: &[[u32; 3]], faces: &[u32]) -> Vec<Normal> {
    let corners = |triangle: [u32; 3]| triangle.map(|vertex| vertices[vertex as usize]);
    let mut sums = vec![Vector::ZERO; vertices.len()];
    let mut add = |face: &[[u32; 3]]| {
        let normal = match *face {
            [triangle] => watertight::normal(corners(triangle)),
            _ => Normal::new(face.iter().map(|&t| area(corners(t))).fold(Vector::ZERO, Add::add)),
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

/// Twice the area of a triangle, along its normal.
fn area([a, b, c]: [Point; 3]) -> Vector {
    (b - a).cross(c - a)
}

/// Whether the winding of most of the area contradicts the vertices' normals.
pub fn are_opposed(vertices: &[Point], triangles: &[[u32; 3]], normals: &[Option<Normal>]) -> bool {
    let votes = triangles.iter().map(|triangle| {
        let given = triangle.iter().filter_map(|&vertex| normals[vertex as usize]);
        let sum = given.map(Vector::from).fold(Vector::ZERO, Add::add);
        area(triangle.map(|vertex| vertices[vertex as usize])).dot(sum)
    });
    votes.sum::<f64>() < 0.0
}

/// Winds triangles the other way.
pub fn turn(triangles: &mut [[u32; 3]]) {
    for [_, b, c] in triangles {
        std::mem::swap(b, c);
    }
}
