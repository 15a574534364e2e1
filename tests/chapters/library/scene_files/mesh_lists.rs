//! Meshes whose lists are in the scene file itself.

use groundtruth::scene::{self, to_toml};
use groundtruth::world::from_toml;

use super::{error_of, with};
use crate::prelude::*;

const SPHERE: &str = "[objects.shape.sphere]\ncenter = [0, 0, 0]\nradius = 1\n";

/// The scene with a mesh of these fields.
fn of(fields: &str) -> String {
    with(SPHERE, &format!("[objects.shape.mesh]\n{fields}"))
}

const VERTICES: &str = "vertices = [[0, 0, 0],\n[1, 0, 0],\n[0, 1, 0]]\n";
const TRIANGLES: &str = "triangles = [[0, 1, 2]]\n";

#[test]
fn errors_name_the_list_and_the_place_in_it() {
    let file = "file = \"mesh.ply\"\n";
    let lists = format!("{VERTICES}{TRIANGLES}");
    for (fields, expected) in [
        (
            String::new(),
            "29: objects[0] \"ball\", shape.mesh: needs either `file`, or `vertices` and `triangles`",
        ),
        (
            VERTICES.to_owned(),
            "29: objects[0] \"ball\", shape.mesh: needs either `file`, or `vertices` and `triangles`",
        ),
        (
            TRIANGLES.to_owned(),
            "29: objects[0] \"ball\", shape.mesh: needs either `file`, or `vertices` and `triangles`",
        ),
        (
            format!("{file}{lists}"),
            "31: objects[0] \"ball\", shape.mesh.vertices: found beside `file`; leave one of them out",
        ),
        (
            format!("{file}normals = []\n"),
            "31: objects[0] \"ball\", shape.mesh.normals: found beside `file`; leave one of them out",
        ),
        (
            format!("{VERTICES}triangles = [[0, 1, 2],\n[2, 1, 3]]\n"),
            "34: objects[0] \"ball\", shape.mesh.triangles[1][2]: found 3, but vertices go from 0 to 2",
        ),
        (
            format!("vertices = []\n{TRIANGLES}"),
            "31: objects[0] \"ball\", shape.mesh.triangles[0][0]: found 0, but there are no vertices",
        ),
        (
            format!("{VERTICES}triangles = []\n"),
            "33: objects[0] \"ball\", shape.mesh.triangles: found none, but a mesh has at least one",
        ),
        (
            format!("{VERTICES}triangles = [[0, 1, -2]]\n"),
            "33: objects[0] \"ball\", shape.mesh.triangles: invalid value: integer `-2`, expected a whole number from 0 to 4294967295",
        ),
        (
            format!("{VERTICES}triangles = [[0, 1, 2, 0]]\n"),
            "33: objects[0] \"ball\", shape.mesh.triangles: invalid length 4, expected an array of length 3",
        ),
        (
            format!("vertices = [[0, 0, 0],\n[1, 0, nan],\n[0, 1, 0]]\n{TRIANGLES}"),
            "31: objects[0] \"ball\", shape.mesh.vertices[1]: found [1.0, 0.0, NaN], but finite numbers are needed",
        ),
        (
            format!("vertices = [[0, 0], [1, 0], [0, 1]]\n{TRIANGLES}"),
            "30: objects[0] \"ball\", shape.mesh.vertices: invalid length 2, expected an array of length 3",
        ),
        (
            format!("{lists}normals = [[0, 0, 1], [0, 0, 1]]\n"),
            "34: objects[0] \"ball\", shape.mesh.normals: found 2, but each of the 3 vertices needs one",
        ),
        (
            format!("{lists}normals = [[0, 0, 1], [0, 0, 1],\n[inf, 0, 1]]\n"),
            "35: objects[0] \"ball\", shape.mesh.normals[2]: found [inf, 0.0, 1.0], but finite numbers are needed",
        ),
        (
            format!("{lists}uvs = [[0, 0]]\n"),
            "34: objects[0] \"ball\", shape.mesh.uvs: found 1, but each of the 3 vertices needs one",
        ),
        (
            format!("{lists}uvs = [[0, 0], [-inf, 0], [0, 1]]\n"),
            "34: objects[0] \"ball\", shape.mesh.uvs[1]: found [-inf, 0.0], but finite numbers are needed",
        ),
        (
            format!("{VERTICES}triangles = [[0, 1, 1]]\n"),
            "33: objects[0] \"ball\", shape.mesh.triangles: found only triangles of area zero, which no ray can hit",
        ),
        (
            format!("{lists}scale = 0\n"),
            "34: objects[0] \"ball\", shape.mesh.scale: found 0, but a positive, finite number is needed",
        ),
    ] {
        assert_eq!(error_of(&of(&fields)), format!("scene.toml:{expected}"), "{fields}");
    }
}

/// The mesh of a scene's only object.
fn mesh(scene: &scene::Scene) -> &Mesh {
    match &scene.objects[0].shape {
        Kind::Mesh(mesh) => mesh,
        other => panic!("{other:?}"),
    }
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
    let (mut scene, _) = from_toml(&of(&format!("{VERTICES}{TRIANGLES}")), Path::new("scene.toml"))
        .expect("a scene");
    let mut mesh = sheet(20);
    let count = mesh.vertices.as_ref().map_or(0, Vec::len);
    let share = |i: usize| (i as f64 + 0.1) / 7.0;
    mesh.normals = Some((0..count).map(|i| [share(i), 1.0 / 3.0, -0.0].into()).collect());
    mesh.uvs = Some((0..count).map(|i| [share(i), 1e-300]).collect());
    scene.objects[0].shape = mesh.clone().into();
    let text = to_toml(&scene).expect("plain");
    let (again, _) = from_toml(&text, Path::new("scene.toml")).expect("the same scene");
    // printed with every digit and the sign of zero
    assert_eq!(format!("{:?}", self::mesh(&again)), format!("{mesh:?}"));
}

/// Law: lists of a hundred thousand triangles are read and built, and the error for an index that does not
/// exist gives its position. Oracle: the position at which the test put it.
#[test]
fn large_lists_are_read_and_their_errors_name_the_place() {
    let (mut scene, _) = from_toml(&of(&format!("{VERTICES}{TRIANGLES}")), Path::new("scene.toml"))
        .expect("a scene");
    let mut large = sheet(224);
    scene.objects[0].shape = large.clone().into();
    let text = to_toml(&scene).expect("plain");
    assert!(text.len() > 1 << 22 && text.len() < 8 << 20, "{}", text.len());
    from_toml(&text, Path::new("scene.toml")).expect("valid");
    large.triangles.as_mut().expect("lists")[100_000][1] = 50_625;
    scene.objects[0].shape = large.into();
    let error = error_of(&to_toml(&scene).expect("plain"));
    assert!(
        error.ends_with(
            "objects[0] \"ball\", shape.mesh.triangles[100000][1]: found 50625, but vertices go \
             from 0 to 50624"
        ),
        "{error}"
    );
}
