//! OBJ: the three indices of a corner (position, texture coordinates, normal) become one.

use super::samples::*;
use crate::prelude::*;
use formats::meshes::{parse_obj, parse_ply};

/// Four points of a square in the plane z = 0.
const SQUARE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

fn square(rest: &str) -> MeshData {
    parse_obj(format!("{SQUARE}{rest}").as_bytes()).unwrap()
}

/// The mesh of a file, without the notes on what was ignored.
fn without_notes(bytes: &[u8]) -> MeshData {
    MeshData { notes: Vec::new(), ..parse_obj(bytes).unwrap() }
}

/// The corner points of all triangles: they do not depend on how vertices are numbered.
pub fn soup(mesh: &MeshData) -> Vec<[[f64; 3]; 3]> {
    mesh.triangles.iter().map(|t| t.map(|i| mesh.vertices[i as usize])).collect()
}

#[test]
fn a_file_with_texture_coordinates_and_normals_is_the_mesh() {
    let mesh = parse_obj(pyramid_obj().as_bytes()).unwrap();
    let expected = pyramid();
    let (normals, uvs) = (mesh.normals.as_ref().unwrap(), mesh.uvs.as_ref().unwrap());
    assert_eq!(soup(&mesh), soup(&expected));
    for (found, meant) in mesh.triangles.iter().flatten().zip(expected.triangles.iter().flatten()) {
        let (found, meant) = (*found as usize, *meant as usize);
        assert_eq!(normals[found], expected.normals.as_ref().unwrap()[meant]);
        assert_eq!(uvs[found], expected.uvs.as_ref().unwrap()[meant]);
    }
    assert_eq!([mesh.vertices.len(), normals.len(), uvs.len()], [5, 5, 5], "none is split");
}

#[test]
fn a_position_with_two_normals_becomes_two_vertices() {
    let normals = "vn 0 0 1\nvn 0 0 -1\n";
    let mesh = square(&format!("{normals}f 1//1 2//1 3//1\nf 1//2 3//2 2//2\nf 1//1 3//1 4//1\n"));
    assert_eq!(mesh.triangles, [[0, 1, 2], [3, 4, 5], [0, 2, 6]]);
    assert_eq!(mesh.vertices[0], mesh.vertices[3]);
    let up_and_down = mesh.normals.unwrap();
    assert_eq!([up_and_down[0], up_and_down[3]], [[0., 0., 1.], [0., 0., -1.]]);
    assert_eq!(mesh.uvs, None);
}

#[test]
fn texture_coordinates_are_taken_by_their_own_index() {
    let mesh = square("vt 0.1 0.2\nvt 0.3 0.4 0.5\nvt 0.6 0.7\nf 1/3 2/1 3/2\n");
    assert_eq!(mesh.uvs.unwrap(), [[0.6, 0.7], [0.1, 0.2], [0.3, 0.4]]);
    assert_eq!(mesh.normals, None);
}

/// Oracle: the same face with positive indices.
#[test]
fn negative_indices_count_back_from_the_face() {
    let expected = soup(&square("f 2 3 4\n"));
    assert_eq!(soup(&square("f -3 -2 -1\n")), expected);
    // points that come later do not change it, and may be named
    assert_eq!(soup(&square("f -3 -2 -1\nv 9 9 9\n")), expected);
    let later = parse_obj(format!("f 2 3 4\n{SQUARE}").as_bytes()).unwrap();
    assert_eq!(soup(&later), expected);
    let with_all =
        square("vt 0 0\nvt 1 1\nvn 0 0 1\nf -4/-2/-1 -3/-1/-1 -2/-2/1\nvt 5 5\nvn 1 0 0\n");
    assert_eq!(with_all.uvs.unwrap(), [[0., 0.], [1., 1.], [0., 0.]]);
    assert_eq!(with_all.normals.unwrap(), [[0., 0., 1.]; 3]);
}

/// Oracle: the file without them.
#[test]
fn comments_groups_materials_lines_and_line_ends_change_nothing() {
    let bare = format!("{SQUARE}f 1 2 3\nf 1 3 4\n");
    let expected = parse_obj(bare.as_bytes()).unwrap();
    let dressed = "mtllib no such file.mtl\no \nv 0 0 0 1.0 # weight\nv 1 0 0 0.5 0.5 0.5\n#v 9 9 9\n\
        v 1 1 0\n  v\t0 1 0  \ng a b\nusemtl \u{e4}\ns 1\nl 1 2 3\np 1\nvp 0.1\nf 1 2 \\\n3 # half\n\
        f 1// 3// 4//\ncstype bezier\nzzz\n";
    assert_eq!(without_notes(dressed.as_bytes()), expected);
    for end in ["\r\n", "\r", " \n\n"] {
        let other = dressed.replace('\n', end).replace("\\ \n\n", "\\\n");
        assert_eq!(without_notes(other.as_bytes()), expected, "{end:?}");
    }
    assert_eq!(parse_obj(bare.trim_end().as_bytes()).unwrap(), expected, "no end of the last line");
    let latin1 = [b"g Z\xfcrich\n", bare.as_bytes()].concat();
    assert_eq!(without_notes(&latin1), expected);
}

#[test]
fn numbers_are_read_as_doubles() {
    let mesh = parse_obj(b"v 0.1 -1e-300 .5\nv 1. +2 3E2\nv 0 0 -0\nf 1 2 3\n").unwrap();
    assert_eq!(mesh.vertices[..2], [[0.1, -1e-300, 0.5], [1.0, 2.0, 300.0]]);
    assert!(mesh.vertices[2][2].is_sign_negative());
}

#[test]
fn points_that_no_face_uses_are_left_out() {
    let mesh = square("f 4 2 1\n");
    assert_eq!(mesh.vertices, [[0., 1., 0.], [1., 0., 0.], [0., 0., 0.]]);
    assert_eq!(mesh.triangles, [[0, 1, 2]]);
}

/// Law: a UTF-8 byte order mark at the start of a file changes nothing. Oracle: the file without it.
#[test]
fn a_byte_order_mark_changes_nothing() {
    let bytes = format!("{SQUARE}f 1 2 3 4\n").into_bytes();
    let marked = [b"\xef\xbb\xbf", bytes.as_slice()].concat();
    assert_eq!(parse_obj(&marked).unwrap(), parse_obj(&bytes).unwrap());
    for encoding in ENCODINGS {
        let bytes = ornate_pyramid_ply(encoding);
        let marked = [b"\xef\xbb\xbf", bytes.as_slice()].concat();
        assert_eq!(parse_ply(&marked).unwrap(), pyramid(), "{encoding:?}");
    }
}

/// Law: a missing texture coordinate v is 0; if only some corners have a normal or texture coordinates, the
/// others get zeros. Oracle: by hand.
#[test]
fn what_corners_lack_is_zero() {
    let mesh = square("vt 0.5\nvt 0.25 0.75\nvn 0 0 2\nf 1/1 2/2/1 3\n");
    assert_eq!(mesh.vertices.len(), 3);
    assert_eq!(mesh.uvs, Some(vec![[0.5, 0.0], [0.25, 0.75], [0.0, 0.0]]));
    assert_eq!(mesh.normals, Some(vec![[0.0; 3], [0.0, 0.0, 2.0], [0.0; 3]]));
    let plain = square("vt 0.5\nvn 0 0 2\nf 1 2 3\n");
    assert_eq!((plain.uvs, plain.normals), (None, None));
}
