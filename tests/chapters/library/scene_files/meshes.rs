//! Scenes with missing or damaged mesh files.

use super::with;

/// The error of a scene with this mesh file; the folder is left out of it.
fn error_of_mesh(name: &str, contents: Option<&str>) -> String {
    let folder = tempfile::tempdir().expect("a folder");
    if let Some(contents) = contents {
        std::fs::write(folder.path().join(name), contents).expect("it can be written");
    }
    let shape = "[objects.shape.sphere]\ncenter = [0, 0, 0]\nradius = 1\n";
    let text = with(shape, &format!("[objects.shape.mesh]\nfile = \"{name}\"\n"));
    let error = match scenefile::from_toml(&text, &folder.path().join("scene.toml")) {
        Err(error) => error.to_string(),
        Ok(_) => return "none".to_owned(),
    };
    error.replace(&format!("{}/", folder.path().display()), "")
}

/// Law: the error of a scene with a mesh file names line, object and field, and the file with what is wrong in it.
/// Oracle: the texts; those of files alone are in `mesh_file`.
#[test]
fn errors_name_the_object_the_file_and_its_line() {
    let vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    assert_eq!(error_of_mesh("mesh.obj", Some(&format!("{vertices}f 1 2 3\n"))), "none");
    let of_nothing = format!("{vertices}f 1 2 4\n");
    for (name, contents, expected) in [
        (
            "mesh.ply",
            Some("hello"),
            "line 1: not a PLY file; the first line of a PLY file is `ply`",
        ),
        ("mesh.obj", Some(&*of_nothing), "line 4: vertex 4 does not exist; indices go from 1 to 3"),
        ("mesh.stl", Some(""), "the name of a mesh file ends in .ply or .obj"),
        ("no.ply", None, "the file cannot be read: No such file or directory (os error 2)"),
    ] {
        let place = "scene.toml:30: objects[0] \"ball\", shape.mesh.file: ";
        assert_eq!(error_of_mesh(name, contents), format!("{place}{name}: {expected}"));
    }
}
