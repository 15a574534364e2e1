//! Every error message for a bad PLY header, in full.

use super::samples::*;
use crate::prelude::*;
use formats::meshes::parse_ply;

/// A correct ASCII file of one triangle, which the tests damage.
pub const TRIANGLE: &str = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n\
    property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n\
    0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

#[track_caller]
pub fn assert_ply_error(bytes: impl AsRef<[u8]>, message: &str) {
    assert_eq!(parse_ply(bytes.as_ref()).unwrap_err().to_string(), message);
}

/// Checks the error of [`TRIANGLE`] with the first `part` replaced by `by`.
#[track_caller]
pub fn assert_spoilt(part: &str, by: &str, message: &str) {
    assert!(TRIANGLE.contains(part), "{part}");
    assert_ply_error(TRIANGLE.replacen(part, by, 1), message);
}

#[test]
fn a_file_that_is_not_ply_or_is_cut_off_gets_an_error() {
    parse_ply(TRIANGLE.as_bytes()).expect("the triangle itself is right");
    let not_ply = "line 1: not a PLY file; the first line of a PLY file is `ply`";
    assert_ply_error("", not_ply);
    assert_ply_error("solid cube\n", not_ply);
    assert_ply_error([0xff, 0xfe, 0], "the text is UTF-16; save it again as UTF-8 or ASCII");
    let endless =
        "the header has no line `end_header`; the file is cut off: copy or export it again";
    assert_ply_error("ply", endless);
    assert_ply_error(
        "ply\nformat ascii 1.0\nelement vert",
        "line 3: found `element vert`, expected `element NAME COUNT`",
    );
    assert_ply_error("ply\nformat ascii 1.0\nend_hea", endless);
    assert_ply_error("ply\nformat ascii 1.0\nelement vertex 0\nend_header", endless);
}

#[test]
fn a_header_line_that_cannot_be_understood_is_quoted() {
    let format = "expected `format ascii 1.0`, `format binary_little_endian 1.0` or \
        `format binary_big_endian 1.0`";
    assert_spoilt("ascii 1.0", "ascii 2.0", &format!("line 2: found `format ascii 2.0`, {format}"));
    assert_spoilt("format ascii 1.0\n", "", &format!("line 2: found `element vertex 3`, {format}"));
    let element = "expected `element NAME COUNT`";
    assert_spoilt("face 1", "face -1", &format!("line 7: found `element face -1`, {element}"));
    assert_spoilt("face 1", "face", &format!("line 7: found `element face`, {element}"));
    assert_spoilt(
        "element vertex 3\n",
        "",
        &format!("line 3: found `property float x`, {element}"),
    );
    let property = "expected `property TYPE NAME` or `property list TYPE TYPE NAME` (TYPE is char, \
        uchar, short, ushort, int, uint, float or double; a list's first TYPE is an integer)";
    assert_spoilt("float x", "half x", &format!("line 4: found `property half x`, {property}"));
    assert_spoilt(
        "list uchar",
        "list float",
        &format!("line 8: found `property list float int vertex_indices`, {property}"),
    );
    let keyword = "expected `comment`, `obj_info`, `element`, `property` or `end_header`, after \
        one line `format`";
    assert_spoilt(
        "property float y",
        "proprety y",
        &format!("line 5: found `proprety y`, {keyword}"),
    );
    assert_spoilt(
        "element vertex",
        "format ascii 1.0\nelement vertex",
        &format!("line 3: found `format ascii 1.0`, {keyword}"),
    );
    // long lines are shortened, and control characters are replaced
    assert_spoilt(
        "property float y",
        &format!("\u{1b}[2J{}", "y".repeat(99)),
        &format!("line 5: found `\u{fffd}[2J{}…`, {keyword}", "y".repeat(36)),
    );
}

#[test]
fn a_missing_element_or_property_is_named() {
    assert_spoilt(
        "element vertex",
        "element corner",
        "the header has no element `vertex`; a mesh needs `vertex` and `face` (or `tristrips`)",
    );
    assert_spoilt(
        "element face",
        "element edge",
        "the header has no element `face`; a mesh needs `vertex` and `face` (or `tristrips`)",
    );
    assert_spoilt(
        "property float x",
        "property float a",
        "element `vertex` has no property `x`; export the mesh again with it",
    );
    assert_spoilt(
        "property float y",
        "property float a",
        "element `vertex` has no property `y`; export the mesh again with it",
    );
    assert_spoilt(
        "property float z",
        "property float a",
        "element `vertex` has no property `z`; export the mesh again with it",
    );
    assert_spoilt(
        "vertex_indices",
        "corners",
        "element `face` has no property `vertex_indices` or `vertex_index`; export the mesh again with it",
    );
}

#[test]
fn duplicate_and_mistyped_header_entries_are_named() {
    assert_spoilt(
        "element face",
        "element face 0\nelement face",
        "the header has two elements `face`; remove or rename one",
    );
    assert_spoilt(
        "property float y",
        "property float x",
        "element `vertex` has two properties `x`; remove or rename one",
    );
    assert_spoilt(
        "property float z",
        "property list char char z",
        "property `z` of element `vertex` has to be a single number, not a list",
    );
    let list = "property `vertex_indices` of element `face` has to be a list of integers, as \
        `property list uchar int vertex_indices`";
    assert_spoilt("list uchar int", "list uchar float", list);
    assert_spoilt("list uchar int", "int", list);
}

#[test]
fn a_header_that_promises_too_much_says_how_much() {
    assert_spoilt(
        "vertex 3",
        "vertex 4000000000",
        "element `vertex`: the header promises 4000000000 of at least 6 bytes each, but only 26 bytes are left; the file is cut off or its header is wrong",
    );
    assert_spoilt(
        "vertex 3",
        "vertex 4294967296",
        "4294967296 vertices are too many: 4294967295 is the most; split the mesh into parts",
    );
    let mut file = Writer::new(Encoding::BigEndian);
    file.header(&[
        "element vertex 1000000",
        "property double x",
        "property float y",
        "property short z",
        "element face 1",
        "property list uchar int vertex_indices",
    ]);
    file.bytes.extend([0; 100]);
    assert_ply_error(
        file.bytes,
        "element `vertex`: the header promises 1000000 of at least 14 bytes each, but only 100 bytes are left; the file is cut off or its header is wrong",
    );
    // a name is quoted like any other text of the file: short, and without control characters
    let name = format!("\u{1b}{}", "n".repeat(500));
    let shown = format!("\u{fffd}{}…", "n".repeat(39));
    assert_spoilt(
        "element vertex",
        &format!("element {name} 99\nproperty char c\nelement vertex"),
        &format!(
            "element `{shown}`: the header promises 99 of at least 2 bytes each, but only 26 bytes are left; the file is cut off or its header is wrong"
        ),
    );
    assert_spoilt(
        "property float z",
        &format!("property float z\nproperty float {name}"),
        &format!("line 11: the line ends before the value of `{shown}`"),
    );
}
