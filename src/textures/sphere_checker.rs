//! The checker of a sphere, with lines (Suffern, ch. 30).

use std::sync::Arc;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::cells::{self, Checkers};
use super::{Chooser, Color, Lines, Paint, SphereCells, Texture, TexturePoint};
use crate::invalid::Invalid;
use crate::kinds::{self, Resources, Specification};
use crate::rgb::Rgb;

/// Checkers of equal angles on a sphere of any radius about the origin of its own coordinates. The
/// first colour is where the sum of the column ⌊φ/(2π/num_horizontal)⌋ and the row
/// ⌊θ/(π/num_vertical)⌋ is even. With an odd num_horizontal, the two columns beside φ = 0 have the
/// same colour.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SphereChecker {
    /// The number of checkers around the y axis, from the +z axis towards +x; at least 1.
    #[serde(default = "cells::twenty")]
    pub num_horizontal: u32,
    /// The number of checkers from the north pole (on the +y axis) to the south pole; at least 1.
    #[serde(default = "cells::ten")]
    pub num_vertical: u32,
    /// The colour of the first checker, which touches the north pole.
    #[serde(default = "kinds::white::<Paint>")]
    pub color1: Paint,
    /// The colour of the other checkers.
    #[serde(default = "cells::half_grey")]
    pub color2: Paint,
    /// Lines along the borders; half a horizontal line at each pole. None if left out.
    #[serde(default)]
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

#[derive(Debug)]
struct SphereCheckerTexture {
    cells: SphereCells,
    checkers: Checkers,
}

impl Specification for SphereChecker {
    type Built = Arc<dyn Texture>;
    type Context = Resources;

    fn build(&self, resources: &mut Resources) -> Result<Arc<dyn Texture>, Invalid> {
        let colors = [&self.color1, &self.color2];
        Ok(Arc::new(SphereCheckerTexture {
            cells: SphereCells::new(self.num_horizontal, self.num_vertical)?,
            checkers: Checkers::build(colors, &self.lines, resources)?,
        }))
    }

    fn specimens() -> Vec<Self> {
        let lines = Lines { horizontal: 0.1, vertical: 0.05, ..Lines::default() };
        vec![Self { lines, num_vertical: 7, ..Self::default() }, Self::default()]
    }
}

impl Chooser for SphereCheckerTexture {
    fn chosen(&self, at: &TexturePoint<'_>) -> &Color {
        self.checkers.color(self.cells.cell(at.local))
    }
}
