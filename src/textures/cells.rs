//! Cells of alternating colours with lines along their borders, shared by the checkers (Suffern,
//! ch. 30).

use std::sync::Arc;

use super::{Chooser, Color, Paint, Texture, TexturePoint};
use crate::invalid::{Invalid, Ranges};
use crate::kinds::Resources;
use crate::math::{Share, floor};
use crate::rgb::Rgb;

/// The book's offset, added before rounding down, so that a face that lies exactly on a border of
/// cells has one colour. Here it is relative to the size, so that it scales with the scene; in the
/// book it is absolute.
pub const OFFSET: f64 = -0.000_187_453_738;

/// The position of a point in a row of cells.
#[derive(Clone, Copy, Debug)]
pub struct Cell {
    /// The index of the cell: an integer, negative before the first cell.
    pub index: f64,
    /// The position inside the cell, from 0 to 1.
    pub fraction: f64,
}

impl Cell {
    /// The cell of `x` in an infinite row of cells of length 1.
    pub fn at(x: f64) -> Self {
        let index = floor(x);
        Self { index, fraction: x - index }
    }

    /// The cell of `x` among `count` cells that divide 0 … 1; the last cell contains 1.
    pub fn of_range(x: f64, count: f64) -> Self {
        let index = floor(count * x).min(count - 1.0);
        Self { index, fraction: count * x - index }
    }

    /// Whether the point is nearer to a border of its cell than `distance`.
    fn is_near_border(self, distance: f64) -> bool {
        self.fraction < distance || self.fraction > 1.0 - distance
    }
}

/// Whether an integer is even. The Euclidean remainder is not negative for negative numbers.
pub fn is_even(number: f64) -> bool {
    number.rem_euclid(2.0) == 0.0
}

/// Lines centred on the borders of checkers.
#[kind(Default)]
pub struct Lines {
    /// The full width of the lines between rows of checkers, as a fraction of a checker, from 0 (no
    /// lines) to 1 (lines only).
    #[default]
    pub horizontal: Share,
    /// The full width of the lines between columns of checkers, as a fraction of a checker, from 0
    /// to 1.
    #[default]
    pub vertical: Share,
    /// The colour of the lines.
    #[default(Rgb::BLACK.into())]
    pub color: Paint,
}

impl Lines {
    pub(super) fn build(&self, resources: &mut Resources) -> Result<BuiltLines, Invalid> {
        self.check(resources).map_err(|e| e.inside("lines"))
    }

    fn check(&self, resources: &mut Resources) -> Result<BuiltLines, Invalid> {
        self.check_ranges()?;
        let half_widths = [0.5 * self.vertical, 0.5 * self.horizontal];
        Ok(BuiltLines { half_widths, color: self.color.build("color", resources)? })
    }
}

/// Built lines.
#[derive(Debug)]
pub struct BuiltLines {
    /// Half the widths of the lines between columns and between rows, as fractions of a cell.
    pub half_widths: [f64; 2],
    /// Their colour.
    pub color: Color,
}

impl BuiltLines {
    /// The colour of the line at a point in these cells; `None` if no line is there.
    pub fn on(&self, [column, row]: [Cell; 2]) -> Option<&Color> {
        let [beside_columns, beside_rows] = self.half_widths;
        let on_line = column.is_near_border(beside_columns) || row.is_near_border(beside_rows);
        on_line.then_some(&self.color)
    }
}

/// The column and the row of a local point, in units of the checker, among these numbers of columns
/// and rows.
pub type Division = fn([f64; 3], [f64; 2]) -> [Cell; 2];

/// The built texture of all checkers with lines.
#[derive(Debug)]
pub struct Checkers {
    /// The length of one unit.
    pub unit: f64,
    /// The numbers of columns and of rows.
    pub counts: [f64; 2],
    /// The shape of the cells.
    pub division: Division,
    /// The colours where column + row is even, and where it is odd.
    pub colors: [Color; 2],
    /// The lines along the borders.
    pub lines: BuiltLines,
}

impl Checkers {
    /// Checks the fields that the checkers share: the two counts by their names, `color1`, `color2`
    /// and `lines`.
    pub(super) fn build(
        (unit, counts, division): (f64, [(&str, u32); 2], Division),
        [color1, color2]: [&Paint; 2],
        lines: &Lines,
        resources: &mut Resources,
    ) -> Result<Arc<dyn Texture>, Invalid> {
        let counts = self::counts(counts)?;
        let colors = [color1.build("color1", resources)?, color2.build("color2", resources)?];
        let lines = lines.build(resources)?;
        Ok(Arc::new(Self { unit, counts, division, colors, lines }))
    }
}

impl Chooser for Checkers {
    fn chosen(&self, at: &TexturePoint<'_>) -> &Color {
        let point = at.local.to_array().map(|c| c / self.unit);
        let cells @ [column, row] = (self.division)(point, self.counts);
        let [even, odd] = &self.colors;
        let in_cell = || if is_even(column.index + row.index) { even } else { odd };
        self.lines.on(cells).unwrap_or_else(in_cell)
    }
}

/// Checks the numbers of columns and of rows, by their names: at least 1.
pub(super) fn counts(fields: [(&str, u32); 2]) -> Result<[f64; 2], Invalid> {
    match fields.into_iter().find(|(_, count)| *count == 0) {
        Some((field, _)) => Err(Invalid::field(field, "found 0, but at least 1 is needed")),
        None => Ok(fields.map(|(_, count)| count.into())),
    }
}

/// The default of the second colour in scene files.
pub(super) fn half_grey() -> Paint {
    Rgb::grey(0.5).into()
}
