//! The checker of a sphere, with lines (Suffern, ch. 30).

use std::sync::Arc;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::cells::{self, Checkers};
use super::{Lines, Paint, Specification, SphereCells, Texture};
use crate::invalid::Invalid;
use crate::kinds::Resources;
use crate::rgb::Rgb;

/// Checkers of equal angles on a sphere of any radius about the origin of its own coordinates. The
/// first colour is where the sum of the column ⌊φ/(2π/num_horizontal)⌋ and the row
/// ⌊θ/(π/num_vertical)⌋ is even. With an odd num_horizontal, the two columns beside φ = 0 have the
/// same colour.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct SphereChecker {
    /// The number of checkers around the y axis, from the +z axis towards +x; at least 1.
    pub num_horizontal: u32,
    /// The number of checkers from the north pole (on the +y axis) to the south pole; at least 1.
    pub num_vertical: u32,
    /// The colour of the first checker, which touches the north pole.
    pub color1: Paint,
    /// The colour of the other checkers.
    pub color2: Paint,
    /// Lines along the borders; half a horizontal line at each pole. None if left out.
    pub lines: Lines,
}

/// White and grey, with the numbers of checkers of the book.
impl Default for SphereChecker {
    fn default() -> Self {
        Self {
            num_horizontal: cells::twenty(),
            num_vertical: cells::ten(),
            color1: Rgb::WHITE.into(),
            color2: cells::half_grey(),
            lines: Lines::default(),
        }
    }
}

impl Specification for SphereChecker {
    fn build(&self, resources: &mut Resources) -> Result<Arc<dyn Texture>, Invalid> {
        let counts = [("num_horizontal", self.num_horizontal), ("num_vertical", self.num_vertical)];
        let colors = [&self.color1, &self.color2];
        Checkers::build((1.0, counts, SphereCells::division), colors, &self.lines, resources)
    }
}
