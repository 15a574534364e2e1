//! The beveled wedge (Suffern, ch. 21).

use std::sync::Arc;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::edges::rounding;
use super::wedge_parts::{Sides, Wedge};
use crate::invalid::{Invalid, finite};
use crate::kinds::Specification;
use crate::math::lists;
use crate::shapes::composite::assembly::{Materials, smooth_solid};
use crate::shapes::{Context, Shape};

/// The part of a thick ring between two azimuths, with round edges and corners, as the parts
/// `bottom`, `top`, `inner_wall`, `outer_wall`, `start`, `end`, `edges` and `corners`; normals point
/// out of the wedge.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BeveledWedge {
    /// The height of the bottom.
    pub y0: f64,
    /// The height of the top, above `y0`.
    pub y1: f64,
    /// The radius of the inner wall; positive.
    pub inner_radius: f64,
    /// The outer radius, above `inner_radius`.
    pub outer_radius: f64,
    /// From the first azimuth up to the second, in degrees from +z towards +x, each from −360 to
    /// 360; through 360 where the first is larger. Less than a turn.
    #[serde(deserialize_with = "lists::exactly")]
    pub phi: [f64; 2],
    /// The radius of the edges: at most half of the height and of the distance between the radii,
    /// and so that both inner edges fit between the sides.
    pub bevel: f64,
    /// The names of materials of parts that have one of their own, as `{ wall = "red" }`.
    #[serde(default, skip_serializing_if = "Materials::is_empty")]
    pub materials: Materials,
}

/// The azimuths, the second one made the larger.
fn ascending(phi @ [from, to]: [f64; 2]) -> Result<[f64; 2], Invalid> {
    let fits = |degrees: f64| (-360.0..=360.0).contains(&degrees);
    let width = if to < from { (to - from).rem_euclid(360.0) } else { to - from };
    if fits(from) && fits(to) && width > 0.0 && width < 360.0 {
        return Ok([from, if to < from { from + width } else { to }]);
    }
    let problem = format!(
        "found {phi:?}, but two azimuths in degrees from -360 to 360 are needed, less than a turn \
         apart; [350, 10] passes through 360"
    );
    Err(Invalid::field("phi", problem))
}

impl Specification for BeveledWedge {
    type Built = Arc<dyn Shape>;
    type Context = Context;

    fn build(&self, context: &mut Context) -> Result<Arc<dyn Shape>, Invalid> {
        let y = heights(self.y0, self.y1)?;
        let r = [self.inner_radius, self.outer_radius];
        let wedge = Wedge { y, r, phi: ascending(self.phi)?, bevel: self.bevel };
        wedge.check()?;
        let all = Sides { inner_wall: true, outer_wall: true, ends: true };
        smooth_solid(&wedge.parts(all), &self.materials, None, rounding(wedge.largest()), context)
    }

    fn scaled(&self, factor: f64) -> Self {
        let lengths = [self.y0, self.y1, self.inner_radius, self.outer_radius, self.bevel];
        let [y0, y1, inner_radius, outer_radius, bevel] = lengths.map(|length| factor * length);
        let materials = self.materials.clone();
        Self { y0, y1, inner_radius, outer_radius, bevel, materials, ..*self }
    }

    fn specimens() -> Vec<Self> {
        let wedge = |[y0, y1]: [f64; 2], [inner_radius, outer_radius]: [f64; 2], phi, bevel| Self {
            y0,
            y1,
            inner_radius,
            outer_radius,
            phi,
            bevel,
            materials: Materials::new(),
        };
        vec![
            wedge([-0.5, 0.75], [1.0, 2.0], [0.0, 90.0], 0.125),
            wedge([0.25, 0.75], [0.75, 1.5], [140.0, 350.0], 0.25),
            wedge([-0.5, 0.5], [0.25, 1.0], [300.0, 10.0], 0.0625),
        ]
    }
}

/// The fields `y0` and `y1`, if they ascend.
pub fn heights(y0: f64, y1: f64) -> Result<[f64; 2], Invalid> {
    finite("y0", y0)?;
    finite("y1", y1)?;
    if y0 < y1 {
        return Ok([y0, y1]);
    }
    Err(Invalid::field("y1", format!("found {y1}, but it must be above y0, {y0}")))
}
