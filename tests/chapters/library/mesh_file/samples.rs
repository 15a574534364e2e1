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

/// The pyramid as PLY, with elements and properties that a reader has to skip.
pub fn ornate_pyramid_ply(encoding: Encoding) -> Vec<u8> {
    let mesh = pyramid();
    let mut file = Writer::new(encoding);
    file.header(&[
        "comment made by hand",
        "obj_info num_cols 512",
        "element sensor 2",
        "property double focal",
        "property list ushort short pixels",
        "element vertex 5",
        "property uchar red",
        "property float32 x",
        "property float64 y",
        "comment element vertex 99",
        "property float z",
        "property list uint8 int16 bones",
        "property float nx",
        "property float ny",
        "property double nz",
        "property float s",
        "property float t",
        "element nothing 3",
        "element face 5",
        "property int32 flags",
        "property list uchar int vertex_index",
        "property list int8 float weights",
        "element tail 1",
        "property uint32 end",
    ]);
    for pixels in [&[][..], &[-7, 300][..]] {
        file.f64(1.0).u16(pixels.len() as u16);
        for &pixel in pixels {
            file.i16(pixel);
        }
        file.end();
    }
    let (normals, uvs) = (mesh.normals.unwrap(), mesh.uvs.unwrap());
    for (i, [x, y, z]) in mesh.vertices.into_iter().enumerate() {
        file.u8(200 + i as u8).f32(x).f64(y).f32(z).u8(1).i16(-1);
        file.f32(normals[i][0]).f32(normals[i][1]).f64(normals[i][2]);
        file.f32(uvs[i][0]).f32(uvs[i][1]).end();
    }
    for corners in PYRAMID_FACES {
        file.i32(-5).u8(corners.len() as u8);
        for &corner in corners {
            file.i32(corner as i32);
        }
        file.u8(2).f32(0.25).f32(f64::NAN).end();
    }
    file.u32(4_000_000_000).end();
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

macro_rules! numbers {
    ($($name:ident($argument:ty)),*) => {
        $(pub fn $name(&mut self, value: $argument) -> &mut Self {
            let value = value as $name;
            match self.encoding {
                Encoding::Ascii => self.bytes.extend(format!("{value} ").bytes()),
                Encoding::LittleEndian => self.bytes.extend(value.to_le_bytes()),
                Encoding::BigEndian => self.bytes.extend(value.to_be_bytes()),
            }
            self
        })*
    };
}

impl Writer {
    pub fn new(encoding: Encoding) -> Writer {
        Writer { encoding, bytes: Vec::new() }
    }

    pub fn header(&mut self, lines: &[&str]) {
        let format = match self.encoding {
            Encoding::Ascii => "ascii",
            Encoding::LittleEndian => "binary_little_endian",
            Encoding::BigEndian => "binary_big_endian",
        };
        let lines = lines.join("\n");
        self.bytes.extend(format!("ply\nformat {format} 1.0\n{lines}\nend_header\n").bytes());
    }

    pub fn end(&mut self) {
        if self.encoding == Encoding::Ascii {
            self.bytes.push(b'\n');
        }
    }

    numbers!(i8(i8), u8(u8), i16(i16), u16(u16), i32(i32), u32(u32), f32(f64), f64(f64));
}

/// Twice the area vector of a triangle or flat polygon (Newell); splitting must preserve it.
pub fn doubled_area(vertices: &[[f64; 3]], corners: &[u32]) -> [f64; 3] {
    let mut sum = [0.0; 3];
    for (i, &a) in corners.iter().enumerate() {
        let (a, b) = (vertices[a as usize], vertices[corners[(i + 1) % corners.len()] as usize]);
        for (axis, sum) in sum.iter_mut().enumerate() {
            let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
            *sum += a[j] * b[k] - a[k] * b[j];
        }
    }
    sum
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
