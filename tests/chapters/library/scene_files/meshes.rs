//! Scenes with missing or damaged mesh files.

use super::{SCENE, with};
use crate::prelude::*;

const PLY: &str = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n\
    property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n\
    0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

/// The error of a scene with this mesh file; the folder is left out of it.
fn error_of_mesh(name: &str, contents: Option<&str>) -> String {
    let folder = tempfile::tempdir().expect("a folder");
    if let Some(contents) = contents {
        std::fs::write(folder.path().join(name), contents).expect("it can be written");
    }
    let shape = "[objects.shape.sphere]\ncenter = [0, 0, 0]\nradius = 1\n";
    let text = with(shape, &format!("[objects.shape.mesh]\nfile = \"{name}\"\n"));
    let error = match world::from_toml(&text, &folder.path().join("scene.toml")) {
        Err(error) => error.to_string(),
        Ok(_) => return "none".to_owned(),
    };
    error.replace(&format!("{}/", folder.path().display()), "")
}

#[test]
fn the_mesh_they_are_made_of_is_right() {
    assert!(SCENE.contains("ball"));
    assert_eq!(error_of_mesh("mesh.ply", Some(PLY)), "none");
}

#[test]
fn errors_name_the_object_the_file_and_its_line() {
    let place = "scene.toml:30: objects[0] \"ball\", shape.mesh.file: ";
    let ply = |part: &str, replacement: &str| {
        assert!(PLY.contains(part));
        error_of_mesh("mesh.ply", Some(&PLY.replacen(part, replacement, 1)))
    };
    let strips = "element tristrips 1\nproperty list int int vertex_indices\nend_header";
    for (found, expected) in [
        (
            ply("3 0 1 2\n", ""),
            "mesh.ply: element `face`: the header promises 1 of at least 2 bytes each, but only 0 bytes are left; the file is cut off or its header is wrong",
        ),
        (
            ply("vertex 3", "vertex 4000000000"),
            "mesh.ply: element `vertex`: the header promises 4000000000 of at least 6 bytes each, but only 26 bytes are left; the file is cut off or its header is wrong",
        ),
        (
            ply("0 1 2", "0 1 3"),
            "mesh.ply: line 13: vertex 3 does not exist; indices go from 0 to 2",
        ),
        (
            ply("1 0 0", "1 nan 0"),
            "mesh.ply: line 11: `NaN` found for `y`, expected a finite number",
        ),
        (
            ply("end_header", strips),
            "mesh.ply: element `tristrips`: the header promises 1 of at least 2 bytes each, but only 0 bytes are left; the file is cut off or its header is wrong",
        ),
        (
            error_of_mesh("mesh.ply", Some("hello")),
            "mesh.ply: line 1: not a PLY file; the first line of a PLY file is `ply`",
        ),
        (
            error_of_mesh("mesh.obj", Some("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n")),
            "mesh.obj: line 4: vertex 4 does not exist; indices go from 1 to 3",
        ),
        (
            error_of_mesh("mesh.obj", Some("v 0 0 inf\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")),
            "mesh.obj: line 1: `inf` found for `z`, expected a finite number",
        ),
        (
            error_of_mesh("mesh.stl", Some("")),
            "mesh.stl: the name of a mesh file ends in .ply or .obj",
        ),
        (
            error_of_mesh("no.ply", None),
            "no.ply: the file cannot be read: No such file or directory (os error 2)",
        ),
    ] {
        assert_eq!(found, format!("{place}{expected}"));
    }
}
