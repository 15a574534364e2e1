//! Meshes whose lists are in the scene file itself.

use scenefile::from_toml;
use scenefile::to_toml;

use super::{SCENE, error_of};
use crate::prelude::*;

/// The scene with this mesh, as a text.
fn written(mesh: Mesh) -> String {
    let (mut scene, _) = from_toml(SCENE, Path::new("scene.toml")).expect("a scene");
    scene.objects[0].shape = mesh.into();
    to_toml(&scene).expect("plain")
}

/// A sheet of `n` × `n` squares, whose coordinates have as many digits as an `f64` can have.
fn sheet(n: u32) -> Mesh {
    let place = |i: u32| f64::from(i) / 3.0 - 1e-7;
    let side = n + 1;
    let vertex = |i: u32| Point::new(place(i % side), -0.0, place(i / side));
    let corners = (0..side * n).filter(|i| i % side != n);
    let triangles = corners.flat_map(|i| [[i, i + side, i + 1], [i + 1, i + side, i + side + 1]]);
    Mesh::of_lists((0..side * side).map(vertex).collect(), triangles.collect())
}

/// Law: a scene with a mesh of lists, with normals and uv, is written to a text that is read back bit for
/// bit. Oracle: the original mesh.
#[test]
fn lists_are_written_and_read_back_bit_for_bit() {
    let mut mesh = sheet(20);
    let count = mesh.vertices.as_ref().map_or(0, Vec::len);
    let share = |i: usize| (i as f64 + 0.1) / 7.0;
    mesh.normals = Some((0..count).map(|i| [share(i), 1.0 / 3.0, -0.0].into()).collect());
    mesh.uvs = Some((0..count).map(|i| [share(i), 1e-300]).collect());
    let again =
        from_toml(&written(mesh.clone()), Path::new("scene.toml")).expect("the same scene").0;
    // printed with every digit and the sign of zero
    assert_eq!(format!("{:?}", again.objects[0].shape), format!("{:?}", Kind::from(mesh)));
}

/// Law: lists of a hundred thousand triangles are read and built, and the error for an index that does not
/// exist gives its position. Oracle: the position at which the test put it.
#[test]
fn large_lists_are_read_and_their_errors_name_the_place() {
    let mut large = sheet(224);
    let text = written(large.clone());
    assert!(text.len() > 1 << 22 && text.len() < 8 << 20, "{}", text.len());
    from_toml(&text, Path::new("scene.toml")).expect("valid");
    large.triangles.as_mut().expect("lists")[100_000][1] = 50_625;
    let error = error_of(&written(large));
    assert!(
        error.ends_with(
            "objects[0] \"ball\", shape.mesh.triangles[100000][1]: found 50625, but vertices go \
             from 0 to 50624"
        ),
        "{error}"
    );
}
