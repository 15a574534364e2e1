//! The plane checker with outlines (Suffern, ch. 30).

use std::sync::Arc;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::Texture;
use crate::invalid::{Invalid, not_negative, positive};
use crate::kinds::Specification;
use crate::math::floor;
use crate::rgb::Rgb;
use crate::shapes::Surface;

/// Squares of alternating colours in the local xz plane, with lines along their borders. For level
/// surfaces: along y the colour does not change.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PlaneChecker {
    /// The side of a square, in the unit of the scene; positive.
    pub size: f64,
    /// The colour of the square in the first quadrant at the origin.
    pub color1: Rgb,
    /// The colour of its neighbours.
    pub color2: Rgb,
    /// The full width of the lines, centred on the borders, in the unit of the scene; 0 for none.
    #[serde(default)]
    pub outline_width: f64,
    /// The colour of the lines.
    #[serde(default)]
    pub outline_color: Rgb,
}

impl Specification for PlaneChecker {
    type Built = Arc<dyn Texture>;
    type Context = ();

    fn build(&self, (): &mut ()) -> Result<Arc<dyn Texture>, Invalid> {
        positive("size", self.size)?;
        not_negative("outline_width", self.outline_width)?;
        self.color1.checked("color1")?;
        self.color2.checked("color2")?;
        self.outline_color.checked("outline_color")?;
        Ok(Arc::new(self.clone()))
    }

    fn scaled(&self, factor: f64) -> Self {
        let (size, outline_width) = (factor * self.size, factor * self.outline_width);
        Self { size, outline_width, ..*self }
    }

    fn specimens() -> Vec<Self> {
        let outlined = Self {
            size: 0.5,
            color1: Rgb::WHITE,
            color2: Rgb::new(0.5, 0.75, 0.5),
            outline_width: 0.0625,
            outline_color: Rgb::BLACK,
        };
        vec![Self { outline_width: 0.0, ..outlined }, outlined]
    }
}

impl Texture for PlaneChecker {
    fn color(&self, at: &Surface) -> Rgb {
        let [x, z] = [at.local.x() / self.size, at.local.z() / self.size];
        let half_line = 0.5 * self.outline_width / self.size;
        let on_line = |x: f64| {
            let fraction = x - floor(x);
            fraction < half_line || fraction > 1.0 - half_line
        };
        if on_line(x) || on_line(z) {
            self.outline_color
        } else if (floor(x) + floor(z)).rem_euclid(2.0) == 0.0 {
            self.color1
        } else {
            self.color2
        }
    }
}
