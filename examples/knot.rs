//! Makes `scenes/knot.ply`, the small mesh of the examples: `cargo run --example knot`.

use std::f64::consts::PI;

use formats::meshes::{Encoding, MeshData, write_ply};
use groundtruth::math::{Vector, cos, sin};

/// Steps along the knot and around its tube.
const ALONG: u32 = 96;
const AROUND: u32 = 12;

/// The point of the trefoil knot at parameter `s`, from 0 to 1.
fn knot(s: f64) -> Vector {
    let a = 2.0 * PI * s;
    let r = 2.0 + cos(3.0 * a);
    Vector::new(r * cos(2.0 * a), sin(3.0 * a), r * sin(2.0 * a))
}

fn main() -> std::io::Result<()> {
    let mut data = MeshData::default();
    for i in 0..ALONG {
        let s = f64::from(i) / f64::from(ALONG);
        let tangent = (knot(s + 1e-4) - knot(s - 1e-4)).unit().expect("the knot is smooth");
        let side = tangent.cross(Vector::Y).unit().expect("the knot is never vertical");
        let up = side.cross(tangent);
        for j in 0..AROUND {
            let b = 2.0 * PI * f64::from(j) / f64::from(AROUND);
            let p = knot(s) + 0.4 * (cos(b) * side + sin(b) * up);
            // single precision is what most scanners write
            data.vertices.push(p.to_array().map(|x| f64::from(x as f32)));
        }
    }
    let vertex = |i: u32, j: u32| (i % ALONG) * AROUND + j % AROUND;
    for i in 0..ALONG {
        for j in 0..AROUND {
            let [a, b] = [vertex(i, j), vertex(i, j + 1)];
            let [c, d] = [vertex(i + 1, j), vertex(i + 1, j + 1)];
            data.triangles.extend([[a, c, d], [a, d, b]]);
        }
    }
    std::fs::write("scenes/knot.ply", write_ply(&data, Encoding::LittleEndian))
}
