//! The plane checker with outlines (Suffern, ch. 30).

use super::cells::{BuiltLines, Cell, Checkers, Division};
use super::{Made, Paint, Specification, made};
use crate::kinds::Resources;
use crate::math::{Distance, Width};
use crate::rgb::Rgb;

/// Squares of alternating colours in the local xz plane, with lines along their borders. For
/// horizontal surfaces: the colour does not depend on y.
#[kind]
pub struct PlaneChecker {
    /// The side of a square, in the unit of the scene; positive.
    pub size: Distance,
    /// The colour of the square at the origin in the first quadrant.
    pub color1: Paint,
    /// The colour of the squares beside it.
    pub color2: Paint,
    /// The full width of the lines, centred on the borders, in the unit of the scene; 0 for none.
    #[default]
    pub outline_width: Width,
    /// The colour of the lines.
    #[default(Rgb::BLACK.into())]
    pub outline_color: Paint,
}

impl Specification for PlaneChecker {
    fn make(&self, resources: &mut Resources) -> Made {
        let colors =
            [self.color1.build("color1", resources)?, self.color2.build("color2", resources)?];
        let half_line = 0.5 * self.outline_width / self.size;
        let color = self.outline_color.build("outline_color", resources)?;
        let lines = BuiltLines { half_widths: [half_line; 2], color };
        // squares without end: their numbers do not matter
        let division: Division = |[x, _, z], _| [Cell::at(x), Cell::at(z)];
        made(Checkers { unit: self.size, counts: [1.0; 2], division, colors, lines })
    }
}
