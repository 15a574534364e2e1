//! Every error message for a missing or bad OBJ file, in full.

use super::samples::*;
use crate::prelude::*;
use formats::meshes::{parse_obj, read};

#[track_caller]
fn assert_obj_error(text: &str, message: &str) {
    assert_eq!(parse_obj(text.as_bytes()).unwrap_err().to_string(), message);
}

#[test]
fn a_line_of_an_obj_file_that_is_wrong_has_its_number() {
    let v = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    let with = |rest: &str| format!("{v}{rest}");
    let no_faces =
        "no faces; a mesh needs at least one triangle (is it a point cloud, or damaged?)";
    assert_obj_error("", no_faces);
    assert_obj_error(v, no_faces);
    assert_obj_error("v 1 2\n", "line 1: the line ends before the value of `z`");
    assert_obj_error(
        &with("v 1 2 inf\nf 1 2 4\n"),
        "line 4: `inf` found for `z`, expected a finite number",
    );
    assert_obj_error(
        "v 0 0 0\nv 1 -nan(ind) 0\nv 0 1 0\nf 1 2 3\n",
        "line 2: `-nan(ind)` found for `y`, expected a finite number",
    );
    assert_obj_error(&with("vt u 0\n"), "line 4: `u` found for `u`, expected a number");
    assert_obj_error(&with("vn 0 one 0\n"), "line 4: `one` found for `ny`, expected a number");
    assert_obj_error(&with("f 1 2\n"), no_faces);
    assert_obj_error(&with("f\n"), no_faces);
    let corner = "expected a corner `v`, `v/vt`, `v//vn` or `v/vt/vn` of integers";
    for word in ["a", "1.0", "1/2/3/4", "1///4", "/1", "//", "1,2", "99999999999999999999"] {
        assert_obj_error(
            &with(&format!("\n# two more\nf 1 {word} 3\n")),
            &format!("line 6: found `{word}`, {corner}"),
        );
    }
}

#[test]
fn an_obj_index_of_nothing_says_what_there_is() {
    let v = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\n";
    let with = |rest: &str| format!("{v}{rest}");
    let upwards = "indices go from 1 to 3";
    assert_obj_error(&with("f 1 2 4\n"), &format!("line 5: vertex 4 does not exist; {upwards}"));
    assert_obj_error(&with("f 0 1 2\n"), &format!("line 5: vertex 0 does not exist; {upwards}"));
    assert_obj_error(
        &with("f 1 2 9223372036854775807\n"),
        &format!("line 5: vertex 9223372036854775807 does not exist; {upwards}"),
    );
    let back = "negative indices go from -1 to -3 here";
    assert_obj_error(
        &with("f -1 -2 -4\nv 0 0 0\n"),
        &format!("line 5: vertex -4 does not exist; {back}"),
    );
    assert_obj_error(
        &with("f -1 -2 -9223372036854775808\n"),
        &format!("line 5: vertex -9223372036854775808 does not exist; {back}"),
    );
    assert_obj_error(
        &with("f 1/2 2/1 3/1\n"),
        "line 5: texture coordinate 2 does not exist; indices go from 1 to 1",
    );
    assert_obj_error(
        &with("f 1//-1 2//-1 3//-1\nvn 0 0 1\n"),
        "line 5: normal -1 does not exist; none stands before this line",
    );
}

#[test]
fn a_file_is_named_in_its_errors_and_chosen_by_its_extension() {
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str, bytes: &[u8]| {
        let path = folder.path().join(name);
        std::fs::write(&path, bytes).unwrap();
        path
    };
    for name in ["a.ply", "b.PLY", "c.d.Ply"] {
        assert_eq!(
            read(&write(name, &ornate_pyramid_ply(Encoding::BigEndian))).unwrap(),
            pyramid()
        );
    }
    for name in ["a.obj", "b.OBJ"] {
        assert_eq!(read(&write(name, pyramid_obj().as_bytes())).unwrap().triangles.len(), 6);
    }
    let text = |path: &Path| read(path).unwrap_err().to_string();
    let bad = write("bad.ply", b"obj");
    assert_eq!(
        text(&bad),
        format!("{}: line 1: not a PLY file; the first line of a PLY file is `ply`", bad.display())
    );
    let bad = write("bad.obj", b"v 0 0 0\nf 1 2 3\n");
    assert_eq!(
        text(&bad),
        format!("{}: line 2: vertex 2 does not exist; indices go from 1 to 1", bad.display())
    );
    for name in ["mesh.stl", "mesh", ".ply"] {
        assert_eq!(
            text(Path::new(name)),
            format!("{name}: the name of a mesh file ends in .ply or .obj")
        );
    }
    let none = folder.path().join("none.ply");
    let system = std::fs::read(&none).unwrap_err();
    assert_eq!(text(&none), format!("{}: the file cannot be read: {system}", none.display()));
}
