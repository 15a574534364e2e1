//! Files as programs write them: what has one meaning is read, and a note says what was ignored.

use super::obj::soup;
use super::samples::*;
use crate::prelude::*;
use formats::meshes::{parse_obj, parse_ply};

const SQUARE: &str = "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\n";

#[track_caller]
fn assert_noted(mesh: &MeshData, start: &str, end: &str) {
    let found = mesh.notes.iter().any(|note| note.starts_with(start) && note.ends_with(end));
    assert!(found, "no note `{start} … {end}` in {:?}", mesh.notes);
}

fn without_notes(mesh: MeshData) -> MeshData {
    MeshData { notes: Vec::new(), ..mesh }
}

/// Law: values beyond the declared ones on any lines of an ASCII file change nothing but the note, which has
/// the first such line and their number. Oracle: the file without them.
#[test]
fn surplus_values_of_a_line_are_ignored() {
    let file = String::from_utf8(ornate_pyramid_ply(formats::meshes::Encoding::Ascii));
    let file = file.unwrap();
    let (header, body) = file.split_once("end_header\n").unwrap();
    let first_line = header.lines().count() + 2;
    let mut random = SplitMix64(1);
    for _ in 0..200 {
        let mut longer = Vec::new();
        let lines = body.lines().enumerate().map(|(index, line)| {
            let surplus = if random.below(3) == 0 { 1 + random.below(4) } else { 0 };
            if surplus > 0 {
                longer.push(first_line + index);
            }
            format!("{line}{}\n", " 0.5".repeat(surplus))
        });
        let lines: String = lines.collect();
        let mesh = parse_ply(format!("{header}end_header\n{lines}").as_bytes()).unwrap();
        match longer.first() {
            Some(first) => {
                let (start, end) =
                    (format!("line {first}: "), format!("({} in all)", longer.len()));
                assert_noted(&mesh, &start, &end);
            }
            None => assert!(mesh.notes.is_empty()),
        }
        assert_eq!(without_notes(mesh), pyramid());
    }
}

/// Law: strips mean the triangles that they spell out, every second one wound the other way; a strip starts anew
/// after −1 in each signed type and after 4294967295, which is −1 in 32 bits without a sign, in every encoding; so
/// the last may end in one. Oracle: the triangles counted here.
#[test]
fn strips_are_the_triangles_that_they_spell_out() {
    let mut random = SplitMix64(2);
    for round in 0..600 {
        let encoding = ENCODINGS[round % 3];
        let kind = ["char", "short", "int", "uint"][round % 4];
        let strips: Vec<Vec<u32>> = (0..1 + random.below(4))
            .map(|_| (0..3 + random.below(6)).map(|_| random.below(20) as u32).collect())
            .collect();
        let mut expected = Vec::new();
        for (index, t) in strips.iter().flat_map(|strip| strip.windows(3).enumerate()) {
            let corners = if index % 2 == 0 { [t[0], t[1], t[2]] } else { [t[1], t[0], t[2]] };
            if t[0] != t[1] && t[1] != t[2] && t[2] != t[0] {
                expected.push(corners);
            }
        }
        let anew = if kind == "uint" { 4294967295.0 } else { -1.0 };
        let mut list: Vec<f64> = Vec::new();
        for strip in &strips {
            list.extend(strip.iter().map(|&index| f64::from(index)).chain([anew]));
        }
        list.truncate(list.len() - random.below(2));
        let strips = format!("element tristrips 1\nproperty list int {kind} vertex_indices\n");
        let mut file = Writer::new(encoding, &format!("element vertex 20\n{XYZ}{strips}"));
        (0..20).for_each(|v| file.row("char", &[v.into(), (v % 5).into(), 0.0]));
        file.row(&format!("int {kind}"), &[&[list.len() as f64][..], &list].concat());
        match parse_ply(&file.bytes) {
            Ok(mesh) => assert_eq!((mesh.triangles, mesh.notes), (expected, Vec::new())),
            Err(error) => assert!(expected.is_empty(), "{kind}, {encoding:?}: {error}"),
        }
    }
}

/// Law: texture coordinates of corners are those of the same mesh as OBJ; a corner of a face without any has those of its
/// vertex, if the file gives vertices some, whatever other faces say there, and so has a strip before the faces;
/// positions stay shared for smoothing. Oracle: the OBJ file, whose corners have an index of their own.
#[test]
fn coordinates_of_corners_are_those_of_the_same_mesh_as_obj() {
    let mut random = SplitMix64(3);
    for round in 0..600 {
        let (vertices_have_some, has_strip) = (round % 2 == 1, round % 4 >= 2);
        let said = |is_said: bool, lines| if is_said { lines } else { "" };
        let of_vertices = said(vertices_have_some, "property float u\nproperty float v\n");
        let list = "property list uchar int vertex_indices\n";
        let strip =
            said(has_strip, "element tristrips 1\nproperty list uchar int vertex_indices\n");
        let xyz = XYZ.replace("char", "double");
        let header = format!(
            "element vertex 5\n{xyz}{of_vertices}{strip}element face 5\n{list}property list uchar float texcoord\n"
        );
        let mut file = Writer::new(ENCODINGS[round % 3], &header);
        let (mut obj, mut faces, mut given) = (String::new(), String::new(), 0);
        for [x, y, z] in pyramid().vertices {
            let mut values = vec![x, y, z];
            obj += &format!("v {x} {y} {z}\n");
            if vertices_have_some {
                let [u, v] = [0.5, 0.25].map(|step| step * random.below(3) as f64);
                values.extend([u, v]);
                given += 1;
                obj += &format!("vt {u} {v}\n");
            }
            file.row("double double double float", &values);
        }
        let own = |corner: u32| match vertices_have_some {
            true => format!(" {0}/{0}", corner + 1),
            false => format!(" {}", corner + 1),
        };
        if has_strip {
            file.row("uchar int", &[4.0, 0.0, 1.0, 2.0, 3.0]);
            for triangle in [[0, 1, 2], [2, 1, 3]] {
                faces += &format!("f{}\n", triangle.map(own).concat());
            }
        }
        // the first face has coordinates, so that the mesh has some
        for (face, corners) in PYRAMID_FACES.into_iter().enumerate() {
            let has_uvs = face == 0 || random.below(3) > 0;
            let count = corners.len() as f64;
            file.put("uchar", count);
            corners.iter().for_each(|&corner| file.put("int", corner.into()));
            let mut values = vec![if has_uvs { 2.0 * count } else { 0.0 }];
            faces += "f";
            for corner in corners {
                if !has_uvs {
                    faces += &own(*corner);
                    continue;
                }
                let [u, v] = [0.5, 0.25].map(|step| step * random.below(3) as f64);
                values.extend([u, v]);
                given += 1;
                obj += &format!("vt {u} {v}\n");
                faces += &format!(" {}/{given}", corner + 1);
            }
            file.row("uchar float", &values);
            faces += "\n";
        }
        let (ply, obj) = (parse_ply(&file.bytes).unwrap(), parse_obj((obj + &faces).as_bytes()));
        let obj = obj.unwrap();
        assert_eq!(soup(&ply), soup(&obj));
        let uvs = |mesh: &MeshData| {
            let uvs = mesh.uvs.clone().unwrap();
            mesh.triangles.iter().flatten().map(|&c| uvs[c as usize]).collect::<Vec<_>>()
        };
        assert_eq!(uvs(&ply), uvs(&obj));
        assert!(ply.vertices.len() > 5 && ply.notes.is_empty(), "round {round}: {ply:?}");
        for (vertex, &first) in ply.first_at_position.iter().enumerate() {
            assert!(first < 5 && ply.vertices[vertex] == ply.vertices[first as usize]);
        }
        assert_eq!(ply.first_at_position.len(), ply.vertices.len());
    }
}

/// Law: a normal, uv or unused position that is not a number, in any spelling, is as if it were missing, with
/// a note. Oracle: the file without it.
#[test]
fn what_is_not_a_number_is_missing_where_it_may_be() {
    let words = "nan -NaN inf -infinity 1e999 -nan(ind) nan(snan) -nan(0x8000) 1.#QNAN -1.#IND 1.#INF -1.#IND00 1.#J";
    let expected = parse_obj(format!("{SQUARE}vn 0 0 1\nf 1//1 2//1 3//1 4\n").as_bytes()).unwrap();
    for word in words.split(' ') {
        let bad = format!("vn 0 {word} 0 # x\nvt {word}\nv 0 0 {word}\n");
        let text = format!("{SQUARE}vn 0 0 1\n{bad}f 1//1 2/1/1 3//1 4//2\n");
        let mesh = parse_obj(text.as_bytes()).unwrap();
        assert_noted(&mesh, "line 6: ", "(1 in all)");
        assert_noted(&mesh, "line 7: ", "(1 in all)");
        assert_eq!(without_notes(mesh), expected, "{word}");
        let ply = format!(
            "ply\nformat ascii 1.0\n\nelement vertex 4\nproperty float x\nproperty float y\n\
             property float z\nproperty float nx\nproperty float ny\nproperty float nz\n\
             element face 1\nproperty list uchar int vertex_index\nend_header\n\
             {word} 0 0 0 0 1\n0 0 0 {word} 0 0\n1 0 0 0 0 1\n0 1 0 0 0 1\n3 1 2 3\n"
        );
        let mesh = parse_ply(ply.as_bytes()).unwrap();
        assert_noted(&mesh, "line 14: ", "(1 in all)");
        assert_noted(&mesh, "line 15: ", "(1 in all)");
        assert_eq!(mesh.normals.unwrap()[1], [0.0; 3], "{word}");
        let error = parse_ply(ply.replace("3 1 2 3", "3 0 2 3").as_bytes()).unwrap_err();
        assert!(error.to_string().starts_with("line 14: "), "{error}");
    }
}

/// Law: faces of fewer than three corners, references to what is never given, groups and materials change
/// nothing but the notes. Oracle: the file without them.
#[test]
fn faces_without_area_references_to_nothing_and_groups_are_noted() {
    let expected = parse_obj(format!("{SQUARE}f 1 2 3 4\nf 1 2 3\n").as_bytes()).unwrap();
    let text = format!(
        "mtllib a.mtl\n{SQUARE}g one\nf 1 2\nf\nf 1/1/1 2/2/2 3/3/3 4/4/4\nusemtl b\nl 1 2\nfo 1 2 3//7\n"
    );
    let mesh = parse_obj(text.as_bytes()).unwrap();
    assert_eq!(mesh.faces, [0, 0, 1].map(|face| face + 2));
    for (start, end) in [
        ("line 1: `mtllib`", "(3 in all)"),
        ("line 7: a face of fewer than 3 corners", "(2 in all)"),
        ("line 9: a corner names a texture coordinate", "(4 in all)"),
        ("line 9: a corner names a normal", "(5 in all)"),
        ("line 11: points, lines", "(1 in all)"),
    ] {
        assert_noted(&mesh, start, end);
    }
    assert_eq!(mesh.notes.len(), 5);
    assert_eq!((soup(&mesh), mesh.uvs, mesh.normals), (soup(&expected), None, None));
}

/// Law: a text of UTF-16 is named as such, with a mark or without. Oracle: the text.
#[test]
fn a_text_of_two_bytes_a_character_is_named() {
    for text in [format!("{SQUARE}f 1 2 3 4\n"), "ply\n".to_owned()] {
        for mark in ["", "\u{feff}"] {
            let units: Vec<u16> = format!("{mark}{text}").encode_utf16().collect();
            let little: Vec<u8> = units.iter().flat_map(|unit| unit.to_le_bytes()).collect();
            let big: Vec<u8> = units.iter().flat_map(|unit| unit.to_be_bytes()).collect();
            for bytes in [little, big] {
                let told = "the text is UTF-16; save it again as UTF-8 or ASCII";
                assert_eq!(parse_obj(&bytes).unwrap_err().to_string(), told);
                assert_eq!(parse_ply(&bytes).unwrap_err().to_string(), told);
            }
        }
    }
}
