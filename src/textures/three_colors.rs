//! Wrapped noise of three colours (Suffern, ch. 31): the book's `WrappedThreeColors`.

use super::noise_field::{Expanded, Range, Wrapped};
use super::{Made, Paint, Specification, made};
use crate::invalid::{Invalid, finite};
use crate::kinds::Resources;
use crate::math::{Length, Positive, Strength};
use crate::noise::Noise;

/// As `wrapped_fbm`, with three colours separated by two thresholds of `expansion · fBm`.
#[kind]
pub struct ThreeColors {
    /// The noise.
    #[default]
    pub noise: Noise,
    /// The edge of a cell of the noise lattice, in the unit of the scene; positive.
    #[default(1.0)]
    pub size: Length,
    /// The book's expansion number: the noise has values from 0 to this number; positive.
    #[default(3.0)]
    pub expansion: Positive,
    /// The noise at which the second and the third colour begin; ascending.
    #[default(thresholds())]
    pub thresholds: [f64; 2],
    /// The brightness where the fractional part is 0; not negative.
    #[default]
    pub min: Strength,
    /// The brightness where the fractional part approaches 1; not negative.
    #[default(1.0)]
    pub max: Strength,
    /// The colour where the noise is below both thresholds.
    pub color1: Paint,
    /// The colour where the noise is between the thresholds.
    pub color2: Paint,
    /// The colour where the noise is above both thresholds.
    pub color3: Paint,
}

fn thresholds() -> [f64; 2] {
    [1.35, 2.0]
}

impl ThreeColors {
    /// Three colours, each mixed with black, in cells of this size.
    pub fn new(noise: Noise, size: f64, expansion: f64, colors: [Paint; 3]) -> Self {
        let [color1, color2, color3] = colors;
        let thresholds = thresholds();
        Self { noise, size, expansion, thresholds, min: 0.0, max: 1.0, color1, color2, color3 }
    }
}

impl Specification for ThreeColors {
    fn make(&self, resources: &mut Resources) -> Made {
        let [first, second] = self.thresholds;
        finite("thresholds", first).and(finite("thresholds", second))?;
        if second < first {
            let found = self.thresholds;
            let problem = format!("found {found:?}, but the second has to be at least the first");
            return Err(Invalid::field("thresholds", problem));
        }
        made(Wrapped {
            noise: Expanded::build(&self.noise, self.size, self.expansion)?,
            range: Range { min: self.min, max: self.max },
            thresholds: self.thresholds.into(),
            colors: vec![
                self.color1.build("color1", resources)?,
                self.color2.build("color2", resources)?,
                self.color3.build("color3", resources)?,
            ],
        })
    }
}
