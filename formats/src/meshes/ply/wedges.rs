//! Texture coordinates of corners (`property list uchar float texcoord` of faces, as MeshLab writes
//! them): a vertex whose corners differ is split.

use std::collections::HashMap;

use super::super::faces::Faces;
use super::super::{MeshData, MeshFileError, at_most_u32};

/// No coordinates are given for a corner: its vertex keeps its own.
pub(super) const NONE: [f64; 2] = [f64::NAN; 2];

/// Gives the corners their coordinates, one pair for each corner of the faces in order. The first
/// pair stays with the vertex; for each other one a vertex is appended.
pub(super) fn apply(
    uvs_of_corners: &[[f64; 2]],
    data: &mut MeshData,
    faces: &mut Faces,
) -> Result<(), MeshFileError> {
    if uvs_of_corners.iter().all(|uv| uv[0].is_nan()) {
        return Ok(());
    }
    let given = data.vertices.len();
    let mut uvs = data.uvs.take().unwrap_or_else(|| vec![[0.0; 2]; given]);
    let mut is_taken = vec![false; given];
    let mut appended: HashMap<(u32, [u64; 2]), u32> = HashMap::new();
    let mut first: Vec<u32> = Vec::new();
    let own = uvs.clone();
    for (corner, &uv) in faces.corners_mut().iter_mut().zip(uvs_of_corners) {
        let vertex = *corner as usize;
        let uv = if uv[0].is_nan() { own[vertex] } else { uv };
        if !is_taken[vertex] {
            (is_taken[vertex], uvs[vertex]) = (true, uv);
        }
        if uvs[vertex] == uv {
            continue;
        }
        let next = (given + first.len()) as u32;
        // −0 and 0 are one coordinate
        let key = (*corner, uv.map(|x| (x + 0.0).to_bits()));
        let index = *appended.entry(key).or_insert(next);
        if index == next {
            at_most_u32("vertices", u64::from(next) + 1)?;
            first.push(*corner);
            data.vertices.push(data.vertices[vertex]);
            data.normals.iter_mut().for_each(|normals| normals.push(normals[vertex]));
            uvs.push(uv);
        }
        *corner = index;
    }
    if !first.is_empty() {
        data.first_at_position = (0..given as u32).chain(first).collect();
    }
    data.uvs = Some(uvs);
    Ok(())
}
