//! Small files, built here byte by byte, and the meshes they hold.

use crate::prelude::*;

pub const ENCODINGS: [Encoding; 3] = [Encoding::Ascii, Encoding::LittleEndian, Encoding::BigEndian];

/// A pyramid: 5 vertices, a square and 4 triangles. Every coordinate is exact in `f32`.
pub fn pyramid() -> MeshData {
    MeshData {
        vertices: vec![
            [0., 0., 0.],
            [2., 0., 0.],
            [2., 0., 2.],
            [0., 0., 2.],
            [1., 1.5, -1e-3_f32 as f64],
        ],
        normals: Some(vec![[0., -1., 0.], [1., 0., 0.], [0.5, 0., 0.], [0., 0., 1.], [0., 1., 0.]]),
        uvs: Some(vec![[0., 0.], [1., 0.], [1., 1.], [0., 1.], [0.5, 0.5]]),
        triangles: vec![[0, 1, 2], [0, 2, 3], [0, 4, 1], [1, 4, 2], [2, 4, 3], [3, 4, 0]],
        faces: vec![0, 0, 1, 2, 3, 4],
        first_at_position: Vec::new(),
        notes: Vec::new(),
    }
}

/// The faces of the pyramid before they are split.
pub const PYRAMID_FACES: [&[u32]; 5] =
    [&[0, 1, 2, 3], &[0, 4, 1], &[1, 4, 2], &[2, 4, 3], &[3, 4, 0]];

/// Three coordinates of one byte.
pub const XYZ: &str = "property char x\nproperty char y\nproperty char z\n";

/// The pyramid as PLY, with elements and properties that a reader has to skip.
pub fn ornate_pyramid_ply(encoding: Encoding) -> Vec<u8> {
    let mesh = pyramid();
    let mut file = Writer::new(
        encoding,
        "comment made by hand\nobj_info num_cols 512\n\
         element sensor 2\nproperty double focal\nproperty list ushort short pixels\n\
         element vertex 5\nproperty uchar red\nproperty float32 x\nproperty float64 y\n\
         comment element vertex 99\nproperty float z\nproperty list uint8 int16 bones\n\
         property float nx\nproperty float ny\nproperty double nz\nproperty float s\nproperty float t\n\
         element nothing 3\n\
         element face 5\nproperty int32 flags\nproperty list uchar int vertex_index\n\
         property list int8 float weights\nelement tail 1\nproperty uint32 end\n",
    );
    file.row("double ushort", &[1.0, 0.0]);
    file.row("double ushort short", &[1.0, 2.0, -7.0, 300.0]);
    let (normals, uvs) = (mesh.normals.unwrap(), mesh.uvs.unwrap());
    for (i, [x, y, z]) in mesh.vertices.into_iter().enumerate() {
        let ([nx, ny, nz], [s, t]) = (normals[i], uvs[i]);
        let values = [200.0 + i as f64, x, y, z, 1.0, -1.0, nx, ny, nz, s, t];
        file.row("uchar float double float uchar short float float double float", &values);
    }
    for corners in PYRAMID_FACES {
        file.put("int", -5.0);
        file.put("uchar", corners.len() as f64);
        corners.iter().for_each(|&corner| file.put("int", corner.into()));
        file.row("uchar float", &[2.0, 0.25, f64::NAN]);
    }
    file.row("uint", &[4_000_000_000.0]);
    file.bytes
}

/// The pyramid as OBJ; every corner is `v/vt/vn` with three equal numbers.
pub fn pyramid_obj() -> String {
    let mesh = pyramid();
    let mut file = String::from("# a pyramid\nmtllib missing.mtl\no pyramid\n");
    mesh.vertices.iter().for_each(|[x, y, z]| file += &format!("v {x} {y} {z}\n"));
    mesh.uvs.unwrap().iter().for_each(|[u, v]| file += &format!("vt {u} {v}\n"));
    mesh.normals.unwrap().iter().for_each(|[x, y, z]| file += &format!("vn {x} {y} {z}\n"));
    file += "usemtl stone\ns off\n";
    for corners in PYRAMID_FACES {
        file += "f";
        corners.iter().map(|c| c + 1).for_each(|c| file += &format!(" {c}/{c}/{c}"));
        file += "\n";
    }
    file
}

/// Writes numbers in an encoding. It shares no code with the library's reader and writer.
pub struct Writer {
    encoding: Encoding,
    pub bytes: Vec<u8>,
}

impl Writer {
    /// A file that begins with these lines of a header, without the first and the last ones.
    pub fn new(encoding: Encoding, header: &str) -> Writer {
        let format = match encoding {
            Encoding::Ascii => "ascii",
            Encoding::LittleEndian => "binary_little_endian",
            Encoding::BigEndian => "binary_big_endian",
        };
        let header = format!("ply\nformat {format} 1.0\n{header}end_header\n");
        Writer { encoding, bytes: header.into_bytes() }
    }

    /// A number of the type of this name.
    pub fn put(&mut self, kind: &str, value: f64) {
        macro_rules! number {
            ($type:ty) => {{
                let value = value as $type;
                match self.encoding {
                    Encoding::Ascii => self.bytes.extend(format!("{value} ").bytes()),
                    Encoding::LittleEndian => self.bytes.extend(value.to_le_bytes()),
                    Encoding::BigEndian => self.bytes.extend(value.to_be_bytes()),
                }
            }};
        }
        match kind {
            "char" | "int8" => number!(i8),
            "uchar" | "uint8" => number!(u8),
            "short" | "int16" => number!(i16),
            "ushort" | "uint16" => number!(u16),
            "int" | "int32" => number!(i32),
            "uint" | "uint32" => number!(u32),
            "float" | "float32" => number!(f32),
            _ => number!(f64),
        }
    }

    /// Numbers of these types, of which the last is that of all further ones; and the end of the line.
    pub fn row(&mut self, kinds: &str, values: &[f64]) {
        let last = kinds.split(' ').next_back();
        let kinds = kinds.split(' ').chain(last.into_iter().cycle());
        kinds.zip(values).for_each(|(kind, value)| self.put(kind, *value));
        if self.encoding == Encoding::Ascii {
            self.bytes.push(b'\n');
        }
    }
}

/// Steele, Lea and Flood, *Fast splittable pseudorandom number generators*, 2014.
pub struct SplitMix64(pub u64);

impl SplitMix64 {
    pub fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    pub fn below(&mut self, end: usize) -> usize {
        (self.next() % end as u64) as usize
    }
}
