//! The checker of a sphere, with lines (Suffern, ch. 30).

use std::sync::Arc;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::cells::{self, Checkers};
use super::{Chooser, Color, Lines, Paint, SphereCells, Texture, TexturePoint};
use crate::invalid::Invalid;
use crate::kinds::{self, Specification};
use crate::resources::Resources;
use crate::rgb::Rgb;

/// Checkers of equal angles on a sphere about the origin of its own coordinates, of any radius: even
/// numbers of the column φ/(2π/num_horizontal) and the row θ/(π/num_vertical) together have the first
/// colour. With an odd num_horizontal, two neighbours at φ = 0 are alike.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SphereChecker {
    /// How many checkers there are around the y axis, from the +z axis towards +x; at least 1.
    #[serde(default = "cells::twenty")]
    pub num_horizontal: u32,
    /// How many there are from the north pole, on the y axis, to the south pole; at least 1.
    #[serde(default = "cells::ten")]
    pub num_vertical: u32,
    /// The colour of the first checker, which touches the north pole.
    #[serde(default = "kinds::white::<Paint>")]
    pub color1: Paint,
    /// The colour of its neighbours.
    #[serde(default = "cells::half_grey")]
    pub color2: Paint,
    /// Lines along the borders; a horizontal line covers the poles, too. None if left out.
    #[serde(default)]
    pub lines: Lines,
}

/// The book's numbers of checkers, white and grey.
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

    fn scaled(&self, factor: f64) -> Self {
        Self {
            color1: self.color1.scaled(factor),
            color2: self.color2.scaled(factor),
            lines: self.lines.scaled(factor),
            ..*self
        }
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
