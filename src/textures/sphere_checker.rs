//! The checker of a sphere, with lines (Suffern, ch. 30).

use super::cells::{self, Checkers};
use super::{Lines, Made, Paint, Specification, SphereCells};
use crate::kinds::Resources;
use crate::rgb::Rgb;

/// Checkers of equal angles on a sphere of any radius about the origin of its own coordinates. The
/// first colour is where the sum of the column ⌊φ/(2π/num_horizontal)⌋ and the row
/// ⌊θ/(π/num_vertical)⌋ is even. With an odd num_horizontal, the two columns beside φ = 0 have the
/// same colour.
// white and grey, with the numbers of checkers of the book
#[kind(Default)]
pub struct SphereChecker {
    /// The number of checkers around the y axis, from the +z axis towards +x; at least 1.
    #[default(20)]
    pub num_horizontal: u32,
    /// The number of checkers from the north pole (on the +y axis) to the south pole; at least 1.
    #[default(10)]
    pub num_vertical: u32,
    /// The colour of the first checker, which touches the north pole.
    #[default(Rgb::WHITE.into())]
    pub color1: Paint,
    /// The colour of the other checkers.
    #[default(cells::half_grey())]
    pub color2: Paint,
    /// Lines along the borders; half a horizontal line at each pole. None if left out.
    #[default]
    pub lines: Lines,
}

impl Specification for SphereChecker {
    fn make(&self, resources: &mut Resources) -> Made {
        let counts = [("num_horizontal", self.num_horizontal), ("num_vertical", self.num_vertical)];
        let colors = [&self.color1, &self.color2];
        Checkers::build((1.0, counts, SphereCells::division), colors, &self.lines, resources)
    }
}
