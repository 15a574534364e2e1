//! The plane checker with outlines (Suffern, ch. 30).

use std::sync::Arc;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::cells::{BuiltLines, Cell, Checkers, Division};
use super::{Paint, Specification, Texture};
use crate::invalid::{Invalid, not_negative, positive};
use crate::kinds::Resources;
use crate::math::Length;
use crate::rgb::Rgb;

/// Squares of alternating colours in the local xz plane, with lines along their borders. For
/// horizontal surfaces: the colour does not depend on y.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PlaneChecker {
    /// The side of a square, in the unit of the scene; positive.
    #[schemars(with = "Length")]
    pub size: f64,
    /// The colour of the square at the origin in the first quadrant.
    pub color1: Paint,
    /// The colour of the squares beside it.
    pub color2: Paint,
    /// The full width of the lines, centred on the borders, in the unit of the scene; 0 for none.
    #[serde(default)]
    #[schemars(with = "Length")]
    pub outline_width: f64,
    /// The colour of the lines.
    #[serde(default = "black")]
    pub outline_color: Paint,
}

fn black() -> Paint {
    Rgb::BLACK.into()
}

impl Specification for PlaneChecker {
    fn build(&self, resources: &mut Resources) -> Result<Arc<dyn Texture>, Invalid> {
        let size = positive("size", self.size)?;
        let colors =
            [self.color1.build("color1", resources)?, self.color2.build("color2", resources)?];
        let half_line = 0.5 * not_negative("outline_width", self.outline_width)? / size;
        let color = self.outline_color.build("outline_color", resources)?;
        let lines = BuiltLines { half_widths: [half_line; 2], color };
        // squares without end: their numbers do not matter
        let division: Division = |[x, _, z], _| [Cell::at(x), Cell::at(z)];
        Ok(Arc::new(Checkers { unit: size, counts: [1.0; 2], division, colors, lines }))
    }
}
