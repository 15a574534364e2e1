//! PLY: the same mesh in three encodings.

use super::samples::*;
use crate::prelude::*;
use formats::meshes::{parse_ply, write_ply};
use testkit::properties::*;

/// Oracle: the test builds the bytes itself, and the expected mesh is written out in full.
#[test]
fn all_three_encodings_give_the_mesh_and_unknown_data_is_skipped() {
    for encoding in ENCODINGS {
        let read = parse_ply(&ornate_pyramid_ply(encoding)).unwrap();
        assert_eq!(read, pyramid(), "{encoding:?}");
    }
}

/// Oracle: bytes written out by hand, from the format's definition.
#[test]
fn binary_numbers_have_the_byte_order_of_the_header() {
    for (format, one, two) in [
        ("binary_little_endian", [0, 0, 0x80, 0x3f], [2, 0]),
        ("binary_big_endian", [0x3f, 0x80, 0, 0], [0, 2]),
    ] {
        let mut file = format!(
            "ply\nformat {format} 1.0\nelement vertex 3\nproperty float x\nproperty float y\n\
             property float z\nelement face 1\nproperty list uchar ushort vertex_indices\nend_header\n"
        )
        .into_bytes();
        (0..9).for_each(|_| file.extend(one));
        file.extend([3, 0, 0, 0, 0]);
        file.extend(two);
        let expected = MeshData {
            vertices: vec![[1.0; 3]; 3],
            triangles: vec![[0, 0, 2]],
            ..MeshData::default()
        };
        assert_eq!(parse_ply(&file).unwrap(), expected, "{format}");
    }
}

/// Oracle: the type's own range; extremes come back as the same number in every encoding.
#[test]
fn every_type_is_read_exactly_at_both_ends_of_its_range() {
    type Write = fn(&mut Writer) -> &mut Writer;
    let extremes: [(&str, &str, Write, [f64; 3]); 8] = [
        ("char", "int8", |w| w.i8(i8::MIN).i8(0).i8(i8::MAX), [-128., 0., 127.]),
        ("uchar", "uint8", |w| w.u8(0).u8(1).u8(u8::MAX), [0., 1., 255.]),
        ("short", "int16", |w| w.i16(i16::MIN).i16(0).i16(i16::MAX), [-32768., 0., 32767.]),
        ("ushort", "uint16", |w| w.u16(0).u16(1).u16(u16::MAX), [0., 1., 65535.]),
        (
            "int",
            "int32",
            |w| w.i32(i32::MIN).i32(-1).i32(i32::MAX),
            [-2147483648., -1., 2147483647.],
        ),
        ("uint", "uint32", |w| w.u32(0).u32(1).u32(u32::MAX), [0., 1., 4294967295.]),
        (
            "float",
            "float32",
            |w| w.f32(-3.4028234663852886e38).f32(1e-45).f32(0.1),
            [-3.4028234663852886e38, 1e-45_f32 as f64, 0.1_f32 as f64],
        ),
        ("double", "float64", |w| w.f64(f64::MIN).f64(5e-324).f64(0.1), [f64::MIN, 5e-324, 0.1]),
    ];
    for (by_c, by_size, write, expected) in extremes {
        for (name, encoding) in [by_c, by_size].iter().flat_map(|n| ENCODINGS.map(|e| (n, e))) {
            let mut file = Writer::new(encoding);
            let [x, y, z] = ["x", "y", "z"].map(|axis| format!("property {name} {axis}"));
            file.header(&[
                "element vertex 1",
                &x,
                &y,
                &z,
                "element face 1",
                "property list char char vertex_indices",
            ]);
            write(&mut file);
            file.end();
            file.i8(3).i8(0).i8(0).i8(0).end();
            assert_eq!(
                parse_ply(&file.bytes).unwrap().vertices,
                [expected],
                "{name}, {encoding:?}"
            );
        }
    }
}

#[test]
fn every_integer_type_can_count_and_index_corners() {
    type Write = fn(&mut Writer, i8) -> &mut Writer;
    let types: [(&str, Write); 6] = [
        ("char", |w, v| w.i8(v)),
        ("uchar", |w, v| w.u8(v as u8)),
        ("short", |w, v| w.i16(v.into())),
        ("ushort", |w, v| w.u16(v as u16)),
        ("int", |w, v| w.i32(v.into())),
        ("uint", |w, v| w.u32(v as u32)),
    ];
    for encoding in ENCODINGS {
        for (length, write_length) in types {
            for (index, write_index) in types {
                let mut file = Writer::new(encoding);
                let list = format!("property list {length} {index} vertex_indices");
                file.header(&[
                    "element face 1",
                    &list,
                    "element vertex 4",
                    "property char x",
                    "property char y",
                    "property char z",
                ]);
                write_length(&mut file, 4);
                for corner in [3, 2, 1, 0] {
                    write_index(&mut file, corner);
                }
                file.end();
                (0..4).for_each(|v| file.i8(v).i8(0).i8(0).end());
                let read = parse_ply(&file.bytes).unwrap();
                assert_eq!(read.triangles, [[3, 2, 1], [3, 1, 0]], "{length} {index} {encoding:?}");
            }
        }
    }
}

/// Oracle: the same file with `\n`; in a binary file only the header has lines.
#[test]
fn line_ends_of_all_systems_mean_the_same() {
    for end in ["\r\n", "\r", " \t\n", "\n"] {
        for encoding in ENCODINGS {
            let file = ornate_pyramid_ply(encoding);
            let header = match encoding {
                Encoding::Ascii => file.len(),
                _ => file.windows(11).position(|w| w == b"end_header\n").unwrap() + 11,
            };
            let text = String::from_utf8(file[..header].to_vec()).unwrap().replace('\n', end);
            let other = [text.as_bytes(), &file[header..]].concat();
            assert_eq!(parse_ply(&other).unwrap(), pyramid(), "{end:?}, {encoding:?}");
        }
    }
}

#[test]
fn empty_lines_spaces_and_foreign_letters_in_comments_change_nothing() {
    let file = String::from_utf8(ornate_pyramid_ply(Encoding::Ascii)).unwrap();
    let spaced =
        file.replace("end_header\n", "end_header \n\n\n").replace("3 0 4 1", " 3\t0  4 1 ");
    assert_eq!(parse_ply(spaced.as_bytes()).unwrap(), pyramid());
    let (before, after) = file.split_once("by hand").unwrap();
    let latin1 = [before.as_bytes(), b"in Z\xfcrich", after.as_bytes(), b"\n \n"].concat();
    assert_eq!(parse_ply(&latin1).unwrap(), pyramid());
}

#[test]
fn the_last_word_of_a_file_needs_no_white_space_after_it() {
    let file = String::from_utf8(ornate_pyramid_ply(Encoding::Ascii)).unwrap();
    let tight = file.replace("4000000000 \n", "4");
    assert!(tight.ends_with("\n4"));
    assert_eq!(parse_ply(tight.as_bytes()).unwrap(), pyramid());
}

#[test]
fn all_common_names_of_texture_coordinates_are_known() {
    for (u, v) in [("u", "v"), ("s", "t"), ("texture_u", "texture_v"), ("texture_s", "texture_t")] {
        let file = String::from_utf8(ornate_pyramid_ply(Encoding::Ascii)).unwrap();
        let file = file
            .replace("float s\n", &format!("float {u}\n"))
            .replace("float t\n", &format!("float {v}\n"));
        assert_eq!(parse_ply(file.as_bytes()).unwrap(), pyramid(), "{u} {v}");
    }
    let file = String::from_utf8(ornate_pyramid_ply(Encoding::Ascii)).unwrap();
    let half = file.replace("float t\n", "float tee\n").replace("float ny\n", "float why\n");
    let expected = MeshData { normals: None, uvs: None, ..pyramid() };
    assert_eq!(parse_ply(half.as_bytes()).unwrap(), expected, "incomplete ones are ignored");
}

/// Oracle: Newell's formula for the area of the whole polygon.
#[test]
fn polygons_are_split_into_triangles_that_cover_the_same_area() {
    for corners in 3..=12_usize {
        let mut file = Writer::new(Encoding::BigEndian);
        let count = format!("element vertex {corners}");
        file.header(&[
            &count,
            "property double x",
            "property double y",
            "property int z",
            "element face 1",
            "property list uchar int vertex_index",
        ]);
        // on the parabola y = x²: convex, with exact and distinct corners
        for x in 0..corners as i32 {
            file.f64(x.into()).f64((x * x).into()).i32(7).end();
        }
        file.u8(corners as u8);
        for corner in 0..corners as i32 {
            file.i32(corner);
        }
        let mesh = parse_ply(&file.bytes).unwrap();
        let whole = doubled_area(&mesh.vertices, &(0..corners as u32).collect::<Vec<_>>());
        let areas: Vec<f64> =
            mesh.triangles.iter().map(|t| doubled_area(&mesh.vertices, t)[2]).collect();
        assert_eq!(mesh.triangles.len(), corners - 2);
        assert!(areas.iter().all(|&area| area > 0.0), "all are wound like the polygon: {areas:?}");
        assert_eq!(areas.iter().sum::<f64>(), whole[2], "{corners} corners");
    }
}

fn any_mesh() -> impl Strategy<Value = MeshData> {
    let number =
        || prop_oneof![-1e3..1e3_f64, any::<f64>().prop_filter("finite", |x| x.is_finite())];
    (1..40_usize, any::<bool>(), any::<bool>()).prop_flat_map(move |(count, normals, uvs)| {
        (
            prop::collection::vec(prop::array::uniform3(number()), count),
            prop::collection::vec(prop::array::uniform3(number()), count),
            prop::collection::vec(prop::array::uniform2(number()), count),
            prop::collection::vec(prop::array::uniform3(0..count as u32), 1..60),
        )
            .prop_map(move |(vertices, n, t, triangles)| MeshData {
                vertices,
                normals: normals.then_some(n),
                uvs: uvs.then_some(t),
                triangles,
                faces: Vec::new(),
                first_at_position: Vec::new(),
                notes: Vec::new(),
            })
    })
}

/// All numbers as bits, because `==` does not distinguish −0 from 0.
fn bits(mesh: &MeshData) -> (Vec<u64>, usize, usize, Vec<[u32; 3]>) {
    let (normals, uvs) = (mesh.normals.iter().flatten(), mesh.uvs.iter().flatten());
    let numbers =
        mesh.vertices.iter().chain(normals.clone()).flatten().chain(uvs.clone().flatten());
    (numbers.map(|x| x.to_bits()).collect(), normals.count(), uvs.count(), mesh.triangles.clone())
}

proptest! {
    // the seed is fixed; failing cases are stored in a file beside this one
    #![proptest_config(ProptestConfig {
        cases: 200,
        rng_seed: proptest::test_runner::RngSeed::Fixed(23),
        failure_persistence: Some(Box::new(
            proptest::test_runner::FileFailurePersistence::WithSource("proptest-regressions"),
        )),
        ..ProptestConfig::default()
    })]

    /// Law: reading is the inverse of writing, bit for bit, in every encoding.
    #[test]
    fn what_is_written_is_read_back_bit_for_bit(mesh in any_mesh()) {
        for encoding in ENCODINGS {
            let read = parse_ply(&write_ply(&mesh, encoding)).unwrap();
            prop_assert_eq!(bits(&read), bits(&mesh), "{:?}", encoding);
        }
    }
}
