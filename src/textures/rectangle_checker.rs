//! The checker of a rectangle, with lines (Suffern, ch. 30).

use std::sync::Arc;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::cells::{self, Cell, Checkers};
use super::{Lines, Paint, Specification, Texture};
use crate::invalid::Invalid;
use crate::kinds::Resources;
use crate::math::Length;
use crate::rgb::Rgb;

/// Checkers on the rectangle −1 … 1 in x and z: columns by `x/2 + 1/2`, rows by `z/2 + 1/2`.
/// Outside the rectangle they continue; the colour does not depend on y.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct RectangleChecker {
    /// The length of one unit: half the side of the rectangle; positive.
    #[schemars(with = "Length")]
    pub unit: f64,
    /// The number of checkers from x = −1 to x = 1; at least 1.
    pub num_horizontal: u32,
    /// The number of checkers from z = −1 to z = 1; at least 1.
    pub num_vertical: u32,
    /// The colour of the first checker, in the corner x = z = −1.
    pub color1: Paint,
    /// The colour of the other checkers.
    pub color2: Paint,
    /// Lines along the borders: the horizontal ones run along x, the vertical ones along z. Half a
    /// line at each side of the rectangle. None if left out.
    pub lines: Lines,
}

/// White and grey, with the numbers of checkers of the book.
impl Default for RectangleChecker {
    fn default() -> Self {
        Self {
            unit: 1.0,
            num_horizontal: cells::twenty(),
            num_vertical: cells::ten(),
            color1: Rgb::WHITE.into(),
            color2: cells::half_grey(),
            lines: Lines::default(),
        }
    }
}

impl Specification for RectangleChecker {
    fn build(&self, resources: &mut Resources) -> Result<Arc<dyn Texture>, Invalid> {
        let counts = [("num_horizontal", self.num_horizontal), ("num_vertical", self.num_vertical)];
        let colors = [&self.color1, &self.color2];
        Checkers::build((self.unit, counts, division), colors, &self.lines, resources)
    }
}

fn division([x, _, z]: [f64; 3], [columns, rows]: [f64; 2]) -> [Cell; 2] {
    [Cell::at(columns * (0.5 * x + 0.5)), Cell::at(rows * (0.5 * z + 0.5))]
}
