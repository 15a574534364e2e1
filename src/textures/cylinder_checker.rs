//! The checker of a cylinder, with lines (Suffern, ch. 30).

use std::sync::Arc;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::cells::{self, Cell, Checkers};
use super::mapping::azimuth;
use super::{Lines, Paint, Specification, Texture};
use crate::invalid::Invalid;
use crate::kinds::Resources;
use crate::math::Length;
use crate::rgb::Rgb;

/// Checkers on the open cylinder about the y axis with y from −1 to 1 and any radius: columns by
/// the azimuth φ, rows by the height `y/2 + 1/2`. Above and below the cylinder the rows continue.
/// With an odd num_horizontal, the two columns beside φ = 0 have the same colour.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct CylinderChecker {
    /// The length of one unit: half the height of the cylinder; positive.
    #[schemars(with = "Length")]
    pub unit: f64,
    /// The number of checkers around the y axis, from the +z axis towards +x; at least 1.
    pub num_horizontal: u32,
    /// The number of checkers from y = −1 to y = 1; at least 1.
    pub num_vertical: u32,
    /// The colour of the first checker, at the lower end and at φ = 0.
    pub color1: Paint,
    /// The colour of the other checkers.
    pub color2: Paint,
    /// Lines along the borders; half a line at each end of the cylinder. None if left out.
    pub lines: Lines,
}

/// White and grey, with the numbers of checkers of the book.
impl Default for CylinderChecker {
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

impl Specification for CylinderChecker {
    fn build(&self, resources: &mut Resources) -> Result<Arc<dyn Texture>, Invalid> {
        let counts = [("num_horizontal", self.num_horizontal), ("num_vertical", self.num_vertical)];
        let colors = [&self.color1, &self.color2];
        Checkers::build((self.unit, counts, division), colors, &self.lines, resources)
    }
}

fn division([x, y, z]: [f64; 3], [columns, rows]: [f64; 2]) -> [Cell; 2] {
    [Cell::of_range(azimuth(x, z), columns), Cell::at(rows * (0.5 * y + 0.5))]
}
