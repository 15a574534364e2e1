//! Meshes from files: the encoding does not matter.

use formats::meshes::{parse_ply, write_ply};

use crate::prelude::*;
use crate::support::solids::refusal;

/// Law: the three encodings of PLY give the same mesh, and the same hits and shading normals, bit
/// for bit, with the file's normals and with mean ones. Oracle: each other, and the mesh that was
/// written.
/// Book: PLY files.
#[test]
fn the_three_encodings_of_ply_give_the_same_hits() {
    let mesh = TessellatedSphere { radius: 1.3, ..TessellatedSphere::new(12, 8, true) }.mesh();
    let mut data = MeshData {
        vertices: mesh.vertices().iter().map(|p| p.to_array()).collect(),
        triangles: mesh.triangles().to_vec(),
        ..MeshData::default()
    };
    let folder = tempfile::tempdir().expect("a folder");
    for with_normals in [false, true] {
        if with_normals {
            let normals = mesh.normals().expect("smooth");
            data.normals = Some(normals.iter().map(|n| n.to_array()).collect());
        }
        let encodings = [Encoding::Ascii, Encoding::LittleEndian, Encoding::BigEndian];
        let shapes = encodings.map(|encoding| {
            let bytes = write_ply(&data, encoding);
            assert_eq!(parse_ply(&bytes).expect("readable"), data);
            let file = folder.path().join(format!("{encoding:?}-{with_normals}.ply"));
            std::fs::write(&file, bytes).expect("writable");
            let mesh = Mesh { scale: 0.5, smooth: true, ..Mesh::of_file(file) };
            shape_of(mesh)
        });
        let mut draw = Draw::new(2340);
        let mut hits = 0;
        for _ in 0..2_000 {
            let origin = draw.point(3.0);
            let ray = Ray::new(origin, draw.point(0.5) - origin);
            let seen = shapes.each_ref().map(|shape| first(&**shape, &ray));
            assert_eq!(seen[0], seen[1]);
            assert_eq!(seen[0], seen[2]);
            hits += u32::from(seen[0].is_some());
        }
        assert!(hits > 1_000, "only {hits} hits");
    }
}

/// Law: a file in which no triangle has an area is refused, and the message says so. Oracle: the
/// message.
#[test]
fn a_file_of_flat_triangles_is_refused() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("flat.obj");
    let text = "v 0 0 0\nv 1 1 1\nv 2 2 2\nf 1 2 3\nf 1 1 2\n";
    std::fs::write(&file, text).expect("writable");
    let mesh = Mesh::of_file(file);
    let problem = refusal(mesh);
    assert!(problem.contains("file") && problem.contains("area zero"), "{problem}");
}
