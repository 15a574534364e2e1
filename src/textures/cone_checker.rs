//! The checker of a cone, with lines (Suffern, ch. 30).

use std::sync::Arc;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::cells::{self, Cell, Checkers};
use super::mapping::azimuth;
use super::{Chooser, Color, Lines, Paint, Texture, TexturePoint};
use crate::invalid::{Invalid, length};
use crate::kinds::{self, Resources, Specification};
use crate::math::Length;
use crate::rgb::Rgb;

/// Checkers on the cone about the y axis from y = 0 to its apex at y = 2: columns by the azimuth φ,
/// rows of height 2/num_vertical. Above and below the cone the rows continue. With an odd
/// num_horizontal, the two columns beside φ = 0 have the same colour.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ConeChecker {
    /// The length of one unit: half the height of the cone; positive.
    #[serde(default = "kinds::one")]
    #[schemars(with = "Length")]
    pub unit: f64,
    /// The number of checkers around the y axis, from the +z axis towards +x; at least 1.
    #[serde(default = "cells::twenty")]
    pub num_horizontal: u32,
    /// The number of checkers from y = 0 to y = 2; at least 1.
    #[serde(default = "cells::ten")]
    pub num_vertical: u32,
    /// The colour of the first checker, at the base and at φ = 0.
    #[serde(default = "kinds::white::<Paint>")]
    pub color1: Paint,
    /// The colour of the other checkers.
    #[serde(default = "cells::half_grey")]
    pub color2: Paint,
    /// Lines along the borders; half a line at each end of the cone. None if left out.
    #[serde(default)]
    pub lines: Lines,
}

/// White and grey, with the numbers of checkers of the book.
impl Default for ConeChecker {
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

#[derive(Debug)]
struct ConeCheckerTexture {
    unit: f64,
    columns: f64,
    rows: f64,
    checkers: Checkers,
}

impl Specification for ConeChecker {
    type Built = Arc<dyn Texture>;
    type Context = Resources;

    fn build(&self, resources: &mut Resources) -> Result<Arc<dyn Texture>, Invalid> {
        let colors = [&self.color1, &self.color2];
        Ok(Arc::new(ConeCheckerTexture {
            unit: length("unit", self.unit)?,
            columns: cells::count("num_horizontal", self.num_horizontal)?,
            rows: cells::count("num_vertical", self.num_vertical)?,
            checkers: Checkers::build(colors, &self.lines, resources)?,
        }))
    }

    fn specimens() -> Vec<Self> {
        let lines = Lines { horizontal: 0.1, vertical: 0.05, ..Lines::default() };
        vec![Self { lines, unit: 1.5, ..Self::default() }, Self::default()]
    }
}

impl Chooser for ConeCheckerTexture {
    fn chosen(&self, at: &TexturePoint<'_>) -> &Color {
        let [x, y, z] = at.local.to_array().map(|c| c / self.unit);
        let column = Cell::of_range(azimuth(x, z), self.columns);
        let row = Cell::at(self.rows * (0.5 * y));
        self.checkers.color([column, row])
    }
}
