//! Triangles as the file of a mesh.

use groundtruth::math::{Point, Transform};

use crate::export::number;

/// The triangles after a map. The front is the side from which the corners run counter-clockwise, there and here; after a
/// reflection they run the other way round.
pub fn of_triangles(corners: &[Point], triangles: &[[u32; 3]], map: &Transform) -> Vec<u8> {
    let mut lines = vec!["ply".to_owned(), "format ascii 1.0".to_owned()];
    lines.push(format!("element vertex {}", corners.len()));
    lines.extend(["x", "y", "z"].map(|axis| format!("property double {axis}")));
    lines.push(format!("element face {}", triangles.len()));
    lines.push("property list uchar int vertex_indices".to_owned());
    lines.push("end_header".to_owned());
    for corner in corners {
        lines.push(map.point(*corner).to_array().map(number).join(" "));
    }
    let is_mirrored = map.determinant() < 0.0;
    for &[a, b, c] in triangles {
        let [b, c] = if is_mirrored { [c, b] } else { [b, c] };
        lines.push(format!("3 {a} {b} {c}"));
    }
    (lines.join("\n") + "\n").into_bytes()
}
