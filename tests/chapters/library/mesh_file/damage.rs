//! Damaged files: they give an error or a valid mesh, never a panic, and never take much memory.

use super::obj::soup;
use super::samples::*;
use crate::prelude::*;
use formats::meshes::{MeshFileError, parse_obj, parse_ply};

/// Law: no proper prefix of a file is accepted, except a prefix without only the last white space (or, in a
/// text file, without the end of the last word, because a prefix of a number is a number).
#[test]
fn a_ply_file_cut_anywhere_is_an_error_or_the_same_mesh() {
    for encoding in ENCODINGS {
        let file = ornate_pyramid_ply(encoding);
        let whole = file.trim_ascii_end().len();
        for end in 0..file.len() {
            match parse_ply(&file[..end]) {
                Ok(mesh) => {
                    assert_eq!(mesh, pyramid(), "cut at {end}, {encoding:?}");
                    let last_word = whole - "4000000000".len();
                    assert!(encoding == Encoding::Ascii && end > last_word, "cut at {end}");
                }
                Err(error) => assert!(end < whole, "{error}"),
            }
        }
    }
}

/// Law: an OBJ file has no counts, so a file that is cut gives an error or the mesh without its last faces,
/// perhaps also without normals of the last one left; the positions of the corners are right.
#[test]
fn an_obj_file_cut_anywhere_is_an_error_or_the_first_faces() {
    let file = pyramid_obj();
    let whole = parse_obj(file.as_bytes()).unwrap();
    for end in 0..file.len() {
        if let Ok(mesh) = parse_obj(&file.as_bytes()[..end]) {
            assert!(soup(&whole).starts_with(&soup(&mesh)), "cut at {end}");
        }
    }
}

/// Law: each count of a header, replaced by a huge number, is refused before anything is allocated or read.
/// Oracle: a reader that believed it would take minutes or all memory.
#[test]
fn counts_that_lie_are_refused_at_once() {
    use MeshFileError::{DeclaredCount, Syntax, TooMany};
    let largest =
        ["4000000000", "4294967295", "4294967296", "18446744073709551615", "99999999999999999999"];
    for encoding in ENCODINGS {
        let file = ornate_pyramid_ply(encoding);
        let header = file.windows(10).position(|w| w == b"end_header").unwrap();
        let text = std::str::from_utf8(&file[..header]).unwrap();
        for (element, count) in ["sensor", "vertex", "face", "tail"]
            .iter()
            .flat_map(|it| largest.map(|count| (it, count)))
        {
            let lie = text
                .replace(&format!("\nelement {element} "), &format!("\nelement {element} {count}"));
            let error = parse_ply(&[lie.as_bytes(), &file[header..]].concat()).unwrap_err();
            let is_right = matches!(error, DeclaredCount { .. } | TooMany { .. } | Syntax { .. });
            assert!(is_right, "{element} {count}: {error}");
        }
        // elements without properties take no memory, however many there are
        let lie = text.replace("element nothing 3", "element nothing 18446744073709551615");
        assert_eq!(parse_ply(&[lie.as_bytes(), &file[header..]].concat()).unwrap(), pyramid());
    }
}

/// Law: the length of a list that is not there is refused, also of a list that is skipped. Oracle: 2³² − 1 in place of 3.
#[test]
fn list_lengths_that_lie_are_refused() {
    use MeshFileError::{CutOff, Index, MissingValue};
    for (list, encoding) in
        ["vertex_indices", "other"].into_iter().flat_map(|list| ENCODINGS.map(|it| (list, it)))
    {
        let face = format!("element face 1\nproperty list uint int {list}\n");
        let corners = "property list char char vertex_index\n";
        let mut file = Writer::new(encoding, &format!("element vertex 1\n{XYZ}{face}{corners}"));
        file.row("char", &[0.; 3]);
        file.row("uint int int int char", &[4294967295., 0., 0., 0., 0.]);
        let error = parse_ply(&file.bytes).unwrap_err();
        let is_right = matches!(error, CutOff { .. } | MissingValue { .. } | Index { .. });
        assert!(is_right, "{list}, {encoding:?}: {error}");
    }
}
