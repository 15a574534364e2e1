//! Meshes whose vertices and triangles are listed in the scene instead of in a file.

use formats::meshes::write_ply;

use crate::prelude::*;

/// A bumpy sheet with everything a file can have; one triangle of it has no area.
fn sheet(draw: &mut Draw) -> MeshData {
    let mut data = MeshData::default();
    for i in 0..36_u32 {
        data.vertices.push([f64::from(i % 6), draw.between(-0.3, 0.3), f64::from(i / 6)]);
    }
    for i in (0..30).filter(|i| i % 6 != 5) {
        data.triangles.extend([[i, i + 6, i + 1], [i + 1, i + 6, i + 7]]);
    }
    data.triangles.insert(7, [3, 4, 3]);
    let normals = |_| {
        let long = draw.between(0.5, 2.0);
        let normal = [draw.between(-0.3, 0.3), 1.0, draw.between(-0.3, 0.3)];
        if draw.below(5) == 0 { [0.0; 3] } else { normal.map(|x| long * x) }
    };
    data.normals = Some((0..36).map(normals).collect());
    data.uvs = Some((0..36).map(|_| [draw.between(0.0, 1.0), draw.between(0.0, 1.0)]).collect());
    data
}

/// Law: a mesh from lists equals the mesh from a file with the same lists: equal hits, surfaces, texture
/// coordinates and triangle numbers, to the last bit, with and without normals, smooth, scaled and
/// reversed. Oracle: the file.
#[test]
fn a_mesh_of_lists_is_the_mesh_of_the_file_with_them() {
    let mut draw = Draw::new(2351);
    let folder = tempfile::tempdir().expect("a folder");
    let mut hits = 0;
    for case in 0..8 {
        let mut data = sheet(&mut draw);
        if case & 1 != 0 {
            (data.normals, data.uvs) = (None, None);
        }
        let file = folder.path().join(format!("{case}.ply"));
        std::fs::write(&file, write_ply(&data, Encoding::LittleEndian)).expect("writable");
        let (smooth, reverse_normals) = (case & 2 != 0, case & 4 != 0);
        let vertices = data.vertices.iter().map(|&v| Point::from(v)).collect();
        let normals = data.normals.as_ref().map(|all| all.iter().map(|&n| n.into()).collect());
        let of_lists = Mesh::of_lists(vertices, data.triangles.clone());
        let of_lists = Mesh { normals, uvs: data.uvs.clone(), ..of_lists };
        let shapes = [Mesh::of_file(file), of_lists].map(|mesh| {
            let mesh = Mesh { smooth, reverse_normals, scale: 0.3, ..mesh };
            shape_of(mesh)
        });
        for _ in 0..500 {
            let to = Point::new(draw.between(0.0, 1.5), 0.0, draw.between(0.0, 1.5));
            let from = to + 5.0 * Vector::from(draw.direction());
            let ray = Ray::new(from, to - from);
            let [of_file, of_lists] = shapes.each_ref().map(|shape| {
                let at = shape.hit(&ray, Span::AHEAD)?;
                Some((
                    at,
                    shape.surface(&ray, &at),
                    shape.facet(&at, Vector::ZERO),
                    shape.path(&at),
                ))
            });
            assert_eq!(of_file, of_lists);
            hits += u32::from(of_file.is_some());
        }
    }
    assert!(hits > 2_000, "only {hits} hits");
}
