//! Damaged files: they give an error or a valid mesh, never a panic, and never take much memory.

use super::obj::soup;
use super::samples::*;
use crate::prelude::*;
use formats::meshes::{MeshFileError, parse_obj, parse_ply};

/// The module's promise, in bytes of memory for each byte of the file.
const MEMORY_FACTOR: usize = 64;

/// Checks what `MeshData` promises about every mesh that was read.
fn assert_valid(mesh: &MeshData, file: usize) {
    let count = mesh.vertices.len();
    assert!(mesh.vertices.iter().flatten().all(|x| x.is_finite()));
    assert!(mesh.normals.iter().flatten().flatten().all(|x| x.is_finite()));
    assert!(mesh.uvs.iter().flatten().flatten().all(|x| x.is_finite()));
    assert!(mesh.normals.as_ref().is_none_or(|normals| normals.len() == count));
    assert!(mesh.uvs.as_ref().is_none_or(|uvs| uvs.len() == count));
    assert!(!mesh.triangles.is_empty());
    assert!(mesh.triangles.iter().flatten().all(|&corner| (corner as usize) < count));
    let memory = 24 * mesh.vertices.capacity()
        + 24 * mesh.normals.as_ref().map_or(0, Vec::capacity)
        + 16 * mesh.uvs.as_ref().map_or(0, Vec::capacity)
        + 12 * mesh.triangles.capacity();
    assert!(memory <= MEMORY_FACTOR * file, "{memory} bytes from a file of {file}");
}

fn files() -> Vec<Vec<u8>> {
    let mut files: Vec<_> = ENCODINGS.map(ornate_pyramid_ply).into();
    files.push(pyramid_obj().into_bytes());
    files
}

fn parse(bytes: &[u8], obj: bool) -> Result<MeshData, MeshFileError> {
    if obj { parse_obj(bytes) } else { parse_ply(bytes) }
}

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

/// 20 000 files with one to four bytes changed, taken out or put in.
#[test]
fn random_damage_gives_an_error_or_a_valid_mesh() {
    let mut random = SplitMix64(23);
    let mut errors = 0;
    for (number, file) in files().iter().enumerate() {
        for _ in 0..5_000 {
            let mut bytes = file.clone();
            for _ in 0..1 + random.below(4) {
                let at = random.below(bytes.len());
                match random.below(4) {
                    0 => bytes[at] ^= 1 << random.below(8),
                    1 => bytes[at] = random.next() as u8,
                    2 => drop(bytes.remove(at)),
                    _ => bytes.insert(at, b"0123456789 \n/-.e\xff"[random.below(17)]),
                }
            }
            match parse(&bytes, number == 3) {
                Ok(mesh) => assert_valid(&mesh, bytes.len()),
                Err(error) => {
                    errors += 1;
                    assert!(error.to_string().len() < 600, "{error}");
                }
            }
        }
    }
    // most damage falls on something that matters; without this the test could be idle
    assert!((5_000..20_000).contains(&errors), "{errors} errors");
}

#[test]
fn garbage_is_an_error() {
    let mut random = SplitMix64(5);
    for length in 0..500 {
        let garbage: Vec<u8> = (0..length).map(|_| random.next() as u8).collect();
        parse_ply(&garbage).unwrap_err();
        parse_obj(&garbage).unwrap_err();
        parse_ply(&[b"ply\n", &garbage[..]].concat()).unwrap_err();
    }
}

/// Each count of a header, replaced by a huge number, is refused before anything is allocated or read. A
/// reader that believed it would take minutes or all memory.
#[test]
fn counts_that_lie_are_refused_at_once() {
    let largest =
        ["4000000000", "4294967295", "4294967296", "18446744073709551615", "99999999999999999999"];
    for encoding in ENCODINGS {
        let file = ornate_pyramid_ply(encoding);
        let header = file.windows(10).position(|w| w == b"end_header").unwrap();
        let text = std::str::from_utf8(&file[..header]).unwrap();
        for element in ["sensor 2", "vertex 5", "face 5", "tail 1"] {
            for count in largest {
                let (name, _) = element.split_once(' ').unwrap();
                let lie =
                    text.replace(&format!("element {element}"), &format!("element {name} {count}"));
                let bytes = [lie.as_bytes(), &file[header..]].concat();
                let error = parse_ply(&bytes).unwrap_err();
                assert!(
                    matches!(
                        error,
                        MeshFileError::DeclaredCount { .. }
                            | MeshFileError::TooMany { .. }
                            | MeshFileError::Syntax { .. }
                    ),
                    "{error}"
                );
            }
        }
        // elements without properties take no memory, however many there are
        let lie = text.replace("element nothing 3", "element nothing 18446744073709551615");
        assert_eq!(parse_ply(&[lie.as_bytes(), &file[header..]].concat()).unwrap(), pyramid());
    }
}

#[test]
fn list_lengths_that_lie_are_refused() {
    for encoding in ENCODINGS {
        for (list, name) in [("vertex_indices", "a face"), ("other", "a list passed over")] {
            let mut file = Writer::new(encoding);
            let property = format!("property list uint int {list}");
            file.header(&[
                "element vertex 1",
                "property char x",
                "property char y",
                "property char z",
                "element face 1",
                &property,
                "property list char char vertex_index",
            ]);
            file.i8(0).i8(0).i8(0).end();
            file.u32(u32::MAX).i32(0).i32(0).i32(0).i8(0).end();
            let error = parse_ply(&file.bytes).unwrap_err();
            assert!(
                matches!(
                    error,
                    MeshFileError::CutOff { .. }
                        | MeshFileError::MissingValue { .. }
                        | MeshFileError::Index { .. }
                ),
                "{name}, {encoding:?}: {error}"
            );
        }
    }
}
