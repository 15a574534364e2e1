//! The checkers, on flat surfaces.

use groundtruth::math::{Point, Vector, floor};
use groundtruth::textures::{Checker3d, Kind, Paint, PlaneChecker};

use super::Writer;
use super::text::{matrix_of_uv, plugin, rgb};
use crate::export::How;

/// What our solid checker adds to `x / size`, so that no face lies on a border.
const OFFSET: f64 = -0.000_187_453_738;

/// A coordinate that changes by less than this part of a cell over a face is one number on it.
const FLAT: f64 = 1e-9;

/// A flat face in the coordinates of a texture: its points are `corner + u a + v b` for u and v from 0 to 1.
#[derive(Clone, Copy, Debug)]
pub struct Face {
    pub corner: Point,
    pub a: Vector,
    pub b: Vector,
}

/// Checker cells of two colours along some axes.
pub(super) struct Cells<'a> {
    axes: &'a [usize],
    size: f64,
    offset: f64,
    colors: [&'a Paint; 2],
    has_lines: bool,
}

impl<'a> Cells<'a> {
    /// How a texture of a colour is exported, and its cells; `None` if it is no checker.
    pub fn of(kind: &'a Kind) -> (How, Option<Self>) {
        match kind {
            Kind::Checker3d(Checker3d { size, color1, color2 }) => {
                let (axes, colors) = (&[0, 1, 2], [color1, color2]);
                let cells = Self { axes, size: *size, offset: OFFSET, colors, has_lines: false };
                (How::Exact("on flat surfaces along an axis; plain colours"), Some(cells))
            }
            Kind::PlaneChecker(PlaneChecker { size, color1, color2, outline_width, .. }) => {
                let (axes, colors) = (&[0, 2], [color1, color2]);
                let has_lines = *outline_width > 0.0;
                let cells = Self { axes, size: *size, offset: 0.0, colors, has_lines };
                (How::Exact("on flat surfaces; plain colours, no lines"), Some(cells))
            }
            _ => (How::None(""), None),
        }
    }
}

impl Writer<'_> {
    /// A checker on a face, as a `reflectance` with the factor of its colours; `None` if it cannot be said.
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
        face: &Face,
    ) -> Option<String> {
        let Cells { axes, size, offset, colors, has_lines } = Cells::of(kind).1?;
        if has_lines {
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
        let mut colors = [
            self.reflectance(path, factor, colors[0])?,
            self.reflectance(path, factor, colors[1])?,
        ];
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
}
