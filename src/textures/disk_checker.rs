//! The checker of a disk, with lines (Suffern, ch. 30).

use std::sync::Arc;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::cells::{self, Cell, Checkers};
use super::mapping::{azimuth, distance};
use super::{Chooser, Color, Lines, Paint, Texture, TexturePoint};
use crate::invalid::{Invalid, length};
use crate::kinds::{self, Resources, Specification};
use crate::math::Length;
use crate::rgb::Rgb;

/// Checkers on the disk of radius 1 about the y axis: columns by the azimuth φ, rings of width
/// 1/num_radial. Outside the rim the rings continue; the colour does not depend on y. With an odd
/// num_angular, the two columns beside φ = 0 have the same colour.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DiskChecker {
    /// The length of one unit: the radius of the disk; positive.
    #[serde(default = "kinds::one")]
    #[schemars(with = "Length")]
    pub unit: f64,
    /// The number of checkers around the y axis, from the +z axis towards +x; at least 1.
    #[serde(default = "cells::twenty")]
    pub num_angular: u32,
    /// The number of checkers from the centre to the rim; at least 1.
    #[serde(default = "cells::ten")]
    pub num_radial: u32,
    /// The colour of the first checker, in the middle and at φ = 0.
    #[serde(default = "kinds::white::<Paint>")]
    pub color1: Paint,
    /// The colour of the other checkers.
    #[serde(default = "cells::half_grey")]
    pub color2: Paint,
    /// Lines along the borders: the horizontal ones are circles, the vertical ones radial. Half a
    /// line at the centre and at the rim. None if left out.
    #[serde(default)]
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

#[derive(Debug)]
struct DiskCheckerTexture {
    unit: f64,
    columns: f64,
    rows: f64,
    checkers: Checkers,
}

impl Specification for DiskChecker {
    type Built = Arc<dyn Texture>;
    type Context = Resources;

    fn build(&self, resources: &mut Resources) -> Result<Arc<dyn Texture>, Invalid> {
        let colors = [&self.color1, &self.color2];
        Ok(Arc::new(DiskCheckerTexture {
            unit: length("unit", self.unit)?,
            columns: cells::count("num_angular", self.num_angular)?,
            rows: cells::count("num_radial", self.num_radial)?,
            checkers: Checkers::build(colors, &self.lines, resources)?,
        }))
    }

    fn specimens() -> Vec<Self> {
        let lines = Lines { horizontal: 0.1, vertical: 0.05, ..Lines::default() };
        vec![Self { lines, unit: 1.5, ..Self::default() }, Self::default()]
    }
}

impl Chooser for DiskCheckerTexture {
    fn chosen(&self, at: &TexturePoint<'_>) -> &Color {
        let [x, _, z] = at.local.to_array().map(|c| c / self.unit);
        let column = Cell::of_range(azimuth(x, z), self.columns);
        let row = Cell::at(self.rows * distance(x, z));
        self.checkers.color([column, row])
    }
}
