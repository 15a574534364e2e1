//! Cells of two colours in turn, with lines along their borders: what the checkers share (Suffern, ch. 30).

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{Color, Paint};
use crate::invalid::{Invalid, within};
use crate::math::floor;
use crate::resources::Resources;
use crate::rgb::Rgb;

/// The book's odd offset, added before rounding down, so that a face that lies on a border of cells has
/// one colour. Here it is a fraction of the size: the book's absolute one would not scale with the
/// scene.
pub const OFFSET: f64 = -0.000_187_453_738;

/// Where a point is in a row of cells.
#[derive(Clone, Copy, Debug)]
pub struct Cell {
    /// The number of the cell: a whole number, negative before the first.
    pub index: f64,
    /// How much of the cell is before the point, from 0 to 1.
    pub fraction: f64,
}

impl Cell {
    /// Of cells of length 1 without end.
    pub fn at(x: f64) -> Self {
        let index = floor(x);
        Self { index, fraction: x - index }
    }

    /// Of `count` cells that divide 0 … 1; the end of the last is in it, also if rounding leads there.
    pub fn of_range(x: f64, count: f64) -> Self {
        let index = floor(count * x).min(count - 1.0);
        Self { index, fraction: count * x - index }
    }

    /// Whether it is closer to the border, before or behind, than this.
    fn is_near_border(self, distance: f64) -> bool {
        self.fraction < distance || self.fraction > 1.0 - distance
    }
}

/// Whether a whole number is even. The remainder is Euclidean: that of a negative number is not
/// negative.
pub fn is_even(number: f64) -> bool {
    number.rem_euclid(2.0) == 0.0
}

/// Lines along the borders of checkers, one half of each on either side.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Lines {
    /// The full width of the lines between rows of checkers, as a fraction of a checker, from 0 (none)
    /// to 1 (nothing else).
    pub horizontal: f64,
    /// The full width of the lines between columns of checkers, likewise.
    pub vertical: f64,
    /// The colour of the lines.
    pub color: Paint,
}

/// No lines.
impl Default for Lines {
    fn default() -> Self {
        Self { horizontal: 0.0, vertical: 0.0, color: Rgb::BLACK.into() }
    }
}

impl Lines {
    pub(super) fn build(&self, resources: &mut Resources) -> Result<BuiltLines, Invalid> {
        self.check(resources).map_err(|e| e.inside("lines"))
    }

    fn check(&self, resources: &mut Resources) -> Result<BuiltLines, Invalid> {
        let half = |field, width| within(field, width, 0.0..=1.0).map(|width| 0.5 * width);
        let half_widths = [half("vertical", self.vertical)?, half("horizontal", self.horizontal)?];
        Ok(BuiltLines { half_widths, color: self.color.build("color", resources)? })
    }

    pub(super) fn scaled(&self, factor: f64) -> Self {
        let Self { horizontal, vertical, .. } = *self;
        Self { horizontal, vertical, color: self.color.scaled(factor) }
    }
}

/// Lines ready to be asked.
#[derive(Debug)]
pub struct BuiltLines {
    /// Half the width of the lines that border columns, and of those that border rows, as fractions of a
    /// cell.
    pub half_widths: [f64; 2],
    /// Their colour.
    pub color: Color,
}

impl BuiltLines {
    /// The colour of the line that a point of this column and row is on, if it is on one.
    pub fn on(&self, [column, row]: [Cell; 2]) -> Option<&Color> {
        let [beside_columns, beside_rows] = self.half_widths;
        let on_line = column.is_near_border(beside_columns) || row.is_near_border(beside_rows);
        on_line.then_some(&self.color)
    }
}

/// A checker ready to be asked: the colours of even and of odd cells, and lines.
#[derive(Debug)]
pub struct Checkers {
    /// Where column and row together are even, and where they are odd.
    pub colors: [Color; 2],
    /// Along the borders.
    pub lines: BuiltLines,
}

impl Checkers {
    /// Checks the fields that the checkers share.
    pub(super) fn build(
        [color1, color2]: [&Paint; 2],
        lines: &Lines,
        resources: &mut Resources,
    ) -> Result<Self, Invalid> {
        let colors = [color1.build("color1", resources)?, color2.build("color2", resources)?];
        Ok(Self { colors, lines: lines.build(resources)? })
    }

    /// The colour at a point of this column and row.
    pub fn color(&self, cells @ [column, row]: [Cell; 2]) -> &Color {
        let [even, odd] = &self.colors;
        let in_cell = || if is_even(column.index + row.index) { even } else { odd };
        self.lines.on(cells).unwrap_or_else(in_cell)
    }
}

/// How many columns or rows of checkers there are; at least 1.
pub(super) fn count(field: &str, count: u32) -> Result<f64, Invalid> {
    if count == 0 {
        return Err(Invalid::field(field, "found 0, but at least 1 is needed"));
    }
    Ok(count.into())
}

/// The default of the second colour in scene files.
pub(super) fn half_grey() -> Paint {
    Rgb::grey(0.5).into()
}

/// The book's numbers of checkers, the defaults of scene files.
pub(crate) fn twenty() -> u32 {
    20
}

/// See [`twenty`].
pub(crate) fn ten() -> u32 {
    10
}
