//! Writes PLY files, for example meshes and for the tests.

use super::super::MeshData;
use super::Encoding;

/// The mesh as a PLY file of triangles, without its `faces`. [`parse_ply`](super::parse_ply)
/// returns the same numbers bit for bit.
///
/// # Panics
/// If there are fewer normals or texture coordinates than vertices.
pub fn write_ply(data: &MeshData, encoding: Encoding) -> Vec<u8> {
    let mut out = header(data, encoding).into_bytes();
    for (i, position) in data.vertices.iter().enumerate() {
        let mut row = position.to_vec();
        data.normals.iter().for_each(|normals| row.extend(normals[i]));
        data.uvs.iter().for_each(|uvs| row.extend(uvs[i]));
        push_vertex(&mut out, &row, encoding);
    }
    for corners in &data.triangles {
        push_triangle(&mut out, *corners, encoding);
    }
    out
}

fn header(data: &MeshData, encoding: Encoding) -> String {
    let format = match encoding {
        Encoding::Ascii => "ascii",
        Encoding::LittleEndian => "binary_little_endian",
        Encoding::BigEndian => "binary_big_endian",
    };
    let mut header = format!("ply\nformat {format} 1.0\nelement vertex {}\n", data.vertices.len());
    let normals = if data.normals.is_some() { &["nx", "ny", "nz"][..] } else { &[] };
    let uvs = if data.uvs.is_some() { &["u", "v"][..] } else { &[] };
    for name in ["x", "y", "z"].iter().chain(normals).chain(uvs) {
        header += &format!("property double {name}\n");
    }
    header += &format!("element face {}\n", data.triangles.len());
    header + "property list uchar uint vertex_indices\nend_header\n"
}

fn push_vertex(out: &mut Vec<u8>, row: &[f64], encoding: Encoding) {
    match encoding {
        Encoding::Ascii => {
            // `{:?}` is the shortest text that reads back as the same number
            let words: Vec<String> = row.iter().map(|value| format!("{value:?}")).collect();
            out.extend(words.join(" ").bytes());
            out.push(b'\n');
        }
        Encoding::LittleEndian => row.iter().for_each(|value| out.extend(value.to_le_bytes())),
        Encoding::BigEndian => row.iter().for_each(|value| out.extend(value.to_be_bytes())),
    }
}

fn push_triangle(out: &mut Vec<u8>, corners: [u32; 3], encoding: Encoding) {
    let [a, b, c] = corners;
    match encoding {
        Encoding::Ascii => out.extend(format!("3 {a} {b} {c}\n").bytes()),
        Encoding::LittleEndian => {
            out.push(3);
            corners.iter().for_each(|corner| out.extend(corner.to_le_bytes()));
        }
        Encoding::BigEndian => {
            out.push(3);
            corners.iter().for_each(|corner| out.extend(corner.to_be_bytes()));
        }
    }
}
