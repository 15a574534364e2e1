//! The beveled wedge (Suffern, ch. 21): a sector of a thick ring with round edges. Its equations
//! stand in [`wedge_parts`](super::wedge_parts).

use super::edges::check_bevel;
use super::wedge_parts::Wedge;
use crate::invalid::{Invalid, Ranges, shown};
use crate::math::{Coordinate, Length, sin_degrees};
use crate::shapes::composite::assembly::{Materials, solid};
use crate::shapes::part::angles::Angles;
use crate::shapes::plain::annulus::radii;
use crate::shapes::{Context, Made, Specification};

/// The part of a thick ring between two azimuths, with round edges and corners, as the parts
/// `bottom`, `top`, `inner_wall`, `outer_wall`, `start`, `end`, `edges` and `corners`; normals
/// point out of the wedge.
#[kind(PartialEq)]
pub struct BeveledWedge {
    /// The height of the bottom.
    pub y0: Coordinate,
    /// The height of the top, above `y0`.
    pub y1: Coordinate,
    /// The radius of the inner wall; positive.
    pub inner_radius: Length,
    /// The outer radius, above `inner_radius`.
    pub outer_radius: Length,
    /// From the first azimuth up to the second, in degrees from +z towards +x, each from −360 to
    /// 360; through 360 where the first is larger. Less than a turn.
    pub phi: [f64; 2],
    /// The radius of the edges: at most half of the height and of the distance between the radii,
    /// and so that both inner edges fit between the sides.
    pub bevel: Length,
    /// The names of materials of parts that have one of their own, as `{ wall = "red" }`.
    #[optional]
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

impl BeveledWedge {
    /// The wedge, if its bevel fits.
    pub(super) fn checked(&self) -> Result<Wedge, Invalid> {
        let Self { y0, y1, inner_radius, outer_radius, bevel, .. } = *self;
        self.check_ranges()?;
        if y0 >= y1 {
            return Err(Invalid::field("y1", format!("found {y1}, but it must be above y0, {y0}")));
        }
        let r = radii(inner_radius, outer_radius)?;
        let extents = [("height", [y0, y1]), ("distance between the radii", r)];
        check_bevel(bevel, y0.abs().max(y1.abs()).max(outer_radius), &extents)?;
        let phi = ascending(self.phi)?;
        let range = Angles::new("phi", self.phi)?;
        let wedge = Wedge { y: [y0, y1], r, phi, range, bevel };
        /// In degrees; more than the rounding of azimuths.
        const SLACK: f64 = 1e-10;
        let (width, [alpha, _]) = (phi[1] - phi[0], wedge.alpha_beta());
        if 2.0 * alpha > width + SLACK {
            // the largest b has α = width/2: sin(width/2) = b/(r0 + b)
            let sine = sin_degrees(0.5 * width);
            let [found, most] = [bevel, inner_radius * sine / (1.0 - sine)].map(shown);
            let problem =
                format!("found {found}, but at most {most} fits: the inner wall is too narrow");
            return Err(Invalid::field("bevel", problem));
        }
        Ok(wedge)
    }
}

impl Specification for BeveledWedge {
    fn make(&self, context: &mut Context) -> Made {
        solid(&self.checked()?.parts(), &self.materials, None, context)
    }
}
