//! Every error message for a missing or bad mesh file, in full.

use super::samples::*;
use crate::library::check_refused;
use crate::prelude::*;
use formats::meshes::{parse_obj, parse_ply, read, write_ply};

/// A correct ASCII file of one triangle, which the tests damage.
const TRIANGLE: &str = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n\
    property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n\
    0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

fn ply_error(bytes: impl AsRef<[u8]>) -> String {
    match parse_ply(bytes.as_ref()) {
        Ok(mesh) => format!("no error, but {mesh:?}"),
        Err(error) => error.to_string(),
    }
}

/// Law: a wrong PLY file has one error with its line and what would be right, in words that a terminal does not
/// obey. Oracle: the table.
#[test]
fn a_ply_file_that_is_wrong_has_the_error_of_the_table() {
    parse_ply(TRIANGLE.as_bytes()).expect("the triangle itself is right");
    check_refused(include_str!("ply_refused.toml"), |part, by| {
        assert!(TRIANGLE.contains(part), "{part}");
        ply_error(TRIANGLE.replacen(part, by, 1))
    });
}

/// Law: the same of OBJ files. Oracle: the table.
#[test]
fn an_obj_file_that_is_wrong_has_the_error_of_the_table() {
    check_refused(include_str!("obj_refused.toml"), |beginning, rest| {
        match parse_obj(format!("{beginning}{rest}").as_bytes()) {
            Ok(mesh) => format!("no error, but {mesh:?}"),
            Err(error) => error.to_string(),
        }
    });
}

/// Law: an element of a binary file that is wrong has its name and number. Oracle: the file's layout is known,
/// and so is where the test damages it.
#[test]
fn an_element_of_a_binary_file_that_is_wrong_has_its_name_and_index() {
    for encoding in [Encoding::LittleEndian, Encoding::BigEndian] {
        let file = write_ply(&MeshData { normals: None, uvs: None, ..pyramid() }, encoding);
        let body = file.windows(11).position(|w| w == b"end_header\n").unwrap() + 11;
        let faces = body + 5 * 24;
        let with = |at: usize, bytes: &[u8]| {
            let mut file = file.clone();
            file[at..at + bytes.len()].copy_from_slice(bytes);
            file
        };
        let nan = [0x7f, 0xf8, 0, 0, 0, 0, 0xf8, 0x7f]; // a NaN in either byte order
        let file_more = [&file[..], &[1, 2, 3]].concat();
        for (bytes, error) in [
            (
                with(body + 2 * 24 + 8, &nan),
                "vertex 2 (counted from 0): `NaN` found for `y`, expected a finite number",
            ),
            (
                with(faces + 4 * 13 + 9, &[0xff; 4]),
                "face 4 (counted from 0): vertex 4294967295 does not exist; indices go from 0 to 4",
            ),
            (
                with(faces + 5 * 13, &[4]),
                "face 5 (counted from 0): the file ends here; it is cut off: copy or export it again",
            ),
            (
                file_more,
                "3 bytes are left over after the last element; the header's counts are too small, or the file is damaged",
            ),
        ] {
            assert_eq!(ply_error(bytes), error, "{encoding:?}");
        }
    }
}

/// Law: a file is chosen by its extension, in capitals or not; any other is refused, and it is named. Oracle: the
/// meshes; the text.
#[test]
fn a_file_is_chosen_by_its_extension() {
    let folder = tempfile::tempdir().unwrap();
    let ply = ornate_pyramid_ply(Encoding::BigEndian);
    let obj = pyramid_obj().into_bytes();
    for (name, bytes) in [("a.ply", &ply), ("b.PLY", &ply), ("c.d.Ply", &ply), ("b.OBJ", &obj)] {
        let path = folder.path().join(name);
        std::fs::write(&path, bytes).unwrap();
        assert_eq!(read(&path).unwrap().triangles.len(), 6, "{name}");
    }
    for name in ["mesh.stl", "mesh", ".ply"] {
        let error = read(Path::new(name)).unwrap_err().to_string();
        assert_eq!(error, format!("{name}: the name of a mesh file ends in .ply or .obj"));
    }
}
