//! The checkers, on flat surfaces.

use groundtruth::math::floor;
use groundtruth::rgb::Rgb;
use groundtruth::textures::{Kind, Paint};

use super::Writer;
use super::shapes::Flat;
use super::text::{matrix_of_uv, plugin, rgb};
use crate::export::How;
use crate::export::checkers::Cells;

/// A coordinate that changes by less than this part of a cell over a face is one number on it.
const FLAT: f64 = 1e-9;

/// How a texture of a colour is exported.
pub(super) fn how(kind: &Kind) -> How {
    match kind {
        Kind::Checker3d(_) => How::Exact("on flat surfaces along an axis; plain colours"),
        Kind::PlaneChecker(_) => How::Exact("on flat surfaces; plain colours, no lines"),
        _ => How::None(""),
    }
}

impl Writer<'_> {
    /// A checker on a face in the coordinates of the texture, as a `reflectance` with the factor of its colours; `None` if it cannot be said.
    ///
    /// Our cell on an axis is floor(q) with q = x / size + offset, and the first colour is where the sum of all is even.
    ///
    /// `checkerboard` has its first colour where the fractions of both texture coordinates are above 1/2, or neither is. With
    /// the coordinates q / 2 of two axes that is where the sum of these two is even. So on the third axis, q must be the same
    /// everywhere; where its cell is odd, the colours are exchanged.
    pub(super) fn texture(
        &mut self,
        path: &str,
        kind: &Kind,
        factor: f64,
        face: &Flat,
    ) -> Option<String> {
        let Cells { axes, size, offset, colors, lines } = Cells::of(kind)?;
        if lines.is_some() {
            self.refuse(format!("{path}.outline_width"), "no lines can be said");
        }
        let along = |axis: usize| {
            let [a, b] = [face.a, face.b].map(|side| side.along(axis) / size);
            [a, b, face.corner.along(axis) / size + offset]
        };
        let mut odd = false;
        let mut rows: Vec<[f64; 3]> = Vec::new();
        let is_flat = |[a, b, _]: [f64; 3]| a.abs().max(b.abs()) < FLAT;
        for &axis in axes {
            let row = along(axis);
            match axes.len() == 3 && is_flat(row) {
                true => odd ^= floor(row[2] + 0.5 * (row[0] + row[1])).rem_euclid(2.0) == 1.0,
                false => rows.push(row.map(|part| 0.5 * part)),
            }
        }
        // a stripe on one axis, or one cell: below 1/2 everywhere
        rows.resize(rows.len().max(2), [0.0, 0.0, 0.25]);
        let [first, second] = rows[..] else {
            self.refuse(path, "a surface that no axis of the checker is perpendicular to");
            return None;
        };
        let mut colors = [self.cell(path, factor, colors[0])?, self.cell(path, factor, colors[1])?];
        if odd {
            colors.reverse();
        }
        let inner = [
            rgb("color0", colors[0]),
            rgb("color1", colors[1]),
            matrix_of_uv("to_uv", [first, second]),
        ];
        Some(plugin("texture", "checkerboard", &inner).replacen(
            "<texture ",
            "<texture name=\"reflectance\" ",
            1,
        ))
    }
    fn cell(&mut self, path: &str, factor: f64, paint: &Paint) -> Option<Rgb> {
        let color = self.color(path, paint)?;
        self.reflectance(path, factor * color)
    }
}
