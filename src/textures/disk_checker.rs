//! The checker of a disk, with lines (Suffern, ch. 30).

use std::sync::Arc;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::cells::{self, Cell, Checkers};
use super::mapping::{azimuth, distance};
use super::{Lines, Paint, Specification, Texture};
use crate::invalid::Invalid;
use crate::kinds::Resources;
use crate::math::Length;
use crate::rgb::Rgb;

/// Checkers on the disk of radius 1 about the y axis: columns by the azimuth φ, rings of width
/// 1/num_radial. Outside the rim the rings continue; the colour does not depend on y. With an odd
/// num_angular, the two columns beside φ = 0 have the same colour.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct DiskChecker {
    /// The length of one unit: the radius of the disk; positive.
    #[schemars(with = "Length")]
    pub unit: f64,
    /// The number of checkers around the y axis, from the +z axis towards +x; at least 1.
    pub num_angular: u32,
    /// The number of checkers from the centre to the rim; at least 1.
    pub num_radial: u32,
    /// The colour of the first checker, in the middle and at φ = 0.
    pub color1: Paint,
    /// The colour of the other checkers.
    pub color2: Paint,
    /// Lines along the borders: the horizontal ones are circles, the vertical ones radial. Half a
    /// line at the centre and at the rim. None if left out.
    pub lines: Lines,
}

/// White and grey, with the numbers of checkers of the book.
impl Default for DiskChecker {
    fn default() -> Self {
        Self {
            unit: 1.0,
            num_angular: cells::twenty(),
            num_radial: cells::ten(),
            color1: Rgb::WHITE.into(),
            color2: cells::half_grey(),
            lines: Lines::default(),
        }
    }
}

impl Specification for DiskChecker {
    fn build(&self, resources: &mut Resources) -> Result<Arc<dyn Texture>, Invalid> {
        let counts = [("num_angular", self.num_angular), ("num_radial", self.num_radial)];
        let colors = [&self.color1, &self.color2];
        Checkers::build((self.unit, counts, division), colors, &self.lines, resources)
    }
}

fn division([x, _, z]: [f64; 3], [columns, rows]: [f64; 2]) -> [Cell; 2] {
    [Cell::of_range(azimuth(x, z), columns), Cell::at(rows * distance(x, z))]
}
