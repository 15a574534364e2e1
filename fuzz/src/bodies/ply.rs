//! PLY: any bytes give a valid mesh or an error. The memory is in proportion to the file.

use formats::meshes::{Encoding, MeshData, parse_ply, write_ply};

/// Reads a file and checks the mesh, then writes it in every encoding and reads it back.
pub fn run(data: &[u8]) {
    let Ok(mesh) = parse_ply(data) else { return };
    super::obj::assert_in_order(&mesh, data.len());
    let (faces, first_at_position, notes) = (Vec::new(), Vec::new(), Vec::new());
    let triangles = MeshData { faces, first_at_position, notes, ..mesh };
    for encoding in [Encoding::Ascii, Encoding::LittleEndian, Encoding::BigEndian] {
        let again =
            parse_ply(&write_ply(&triangles, encoding)).expect("what is written can be read");
        assert_eq!(triangles, again, "{encoding:?}");
    }
}
