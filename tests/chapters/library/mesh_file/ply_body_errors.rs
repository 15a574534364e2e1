//! Every error message for a bad PLY body, in full.

use super::ply_header_errors::{TRIANGLE, assert_ply_error, assert_spoilt};
use super::samples::*;
use crate::prelude::*;
use formats::meshes::write_ply;

#[test]
fn a_line_of_the_body_that_is_wrong_has_its_number() {
    assert_spoilt("1 0 0\n", "1 0\n", "line 11: the line ends before the value of `z`");
    assert_spoilt(
        "3 0 1 2\n",
        "3 0 1\n",
        "line 13: the line ends before the value of `vertex_indices`",
    );
    assert_spoilt("1 0 0\n", "1 o 0\n", "line 11: `o` found for `y`, expected a number");
    assert_spoilt("1 0 0\n", "1 nan 0\n", "line 11: `NaN` found for `y`, expected a finite number");
    assert_spoilt(
        "1 0 0\n",
        "1 0 -1e39\n",
        "line 11: `-inf` found for `z`, expected a finite number",
    );
    assert_spoilt(
        "3 0 1 2",
        "300 0 1 2",
        "line 13: `300` found for `vertex_indices`, expected an integer from 0 to 255",
    );
    assert_spoilt(
        "3 0 1 2",
        "3 0 1 2.0",
        "line 13: `2.0` found for `vertex_indices`, expected an integer of 32 bits",
    );
    let with_empty_lines = TRIANGLE.replace("\n1 0 0", "\n\n\r\n1 0 x");
    assert_ply_error(with_empty_lines, "line 13: `x` found for `z`, expected a number");
    assert_spoilt(
        "3 0 1 2\n",
        "3 0 1 2\n3 0 1 2\n",
        "8 bytes are left over after the last element; the header's counts are too small, or the file is damaged",
    );
    assert_ply_error(
        TRIANGLE.replace("face 1", "face 2") + " \n\n",
        "line 16: the file ends here; it is cut off: copy or export it again",
    );
    for (name, expected) in [
        ("char", "an integer from -128 to 127"),
        ("short", "an integer of 16 bits"),
        ("ushort", "an integer from 0 to 65535"),
        ("uint", "an integer from 0 to 4294967295"),
        ("double", "a number"),
    ] {
        let message = format!("line 10: `!` found for `x`, expected {expected}");
        assert_ply_error(
            TRIANGLE.replace("float x", &format!("{name} x")).replace("\n0 0 0", "\n! 0 0"),
            &message,
        );
    }
}

#[test]
fn a_face_that_is_wrong_has_its_line() {
    let missing = "does not exist; indices go from 0 to 2";
    assert_spoilt("3 0 1 2", "3 0 1 3", &format!("line 13: vertex 3 {missing}"));
    assert_spoilt("3 0 1 2", "3 0 -1 2", &format!("line 13: vertex -1 {missing}"));
    assert_ply_error(
        TRIANGLE.replace("uchar int", "char int").replace("3 0 1 2", "-3 0 1 2"),
        "line 13: `-3` found for `vertex_indices`, expected the length of a list",
    );
    let no_faces =
        "no faces; a mesh needs at least one triangle (is it a point cloud, or damaged?)";
    assert_ply_error(TRIANGLE.replace("face 1", "face 0").replace("3 0 1 2\n", ""), no_faces);
    assert_spoilt("3 0 1 2", "2 0 1", no_faces);
    assert_spoilt("3 0 1 2", "0", no_faces);
    assert_ply_error(
        TRIANGLE.replace("vertex 3", "vertex 0").replace("0 0 0\n1 0 0\n0 1 0\n", ""),
        "line 10: vertex 0 does not exist; there are no vertices",
    );
}

/// Oracle: the file's layout is known, and so is where the test damages it.
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
        assert_ply_error(
            with(body + 2 * 24 + 8, &nan),
            "vertex 2 (counted from 0): `NaN` found for `y`, expected a finite number",
        );
        let allowed = "does not exist; indices go from 0 to 4";
        assert_ply_error(
            with(faces + 4 * 13 + 9, &[0xff; 4]),
            &format!("face 4 (counted from 0): vertex 4294967295 {allowed}"),
        );
        assert_ply_error(
            with(faces + 5 * 13, &[4]),
            "face 5 (counted from 0): the file ends here; it is cut off: copy or export it again",
        );
        assert_ply_error(
            [&file[..], &[1, 2, 3]].concat(),
            "3 bytes are left over after the last element; the header's counts are too small, or the file is damaged",
        );
    }
}
