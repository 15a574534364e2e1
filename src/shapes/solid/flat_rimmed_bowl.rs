//! The flat-rimmed bowl (Suffern, ch. 19): the points with `r_in² ≤ |p|² ≤ r_out²` and
//! `y ≤ r_in cos θ`, where θ is half the opening angle.
//!
//! Its surface is a compound of two part spheres and an annulus. The book's bowl is the hemisphere,
//! θ = 90°; for others the annulus goes from `r_in sin θ` to `√(r_out² − r_in² cos² θ)`.

use crate::invalid::{Invalid, shown};
use crate::math::{Length, Point, Vector, atan2, cos_degrees, sin_degrees, to_degrees};
use crate::shapes::composite::assembly::{Materials, solid};
use crate::shapes::part::angles::full_turn;
use crate::shapes::plain::annulus::radii;
use crate::shapes::{Annulus, Context, Kind, Made, PartSphere, Specification};

/// The points between two spheres about the origin, up to a level cut, as the parts `outside`,
/// `inside` and `rim`; normals point out of the bowl, those of its inside to the origin.
#[kind(PartialEq)]
pub struct FlatRimmedBowl {
    /// The radius of the inside; positive.
    pub inner_radius: Length,
    /// The radius of the outside, above `inner_radius`.
    pub outer_radius: Length,
    /// The angle at which the rim of the inside is seen across from the origin, in degrees above 0
    /// and below 360: 180 for the book's hemispherical bowl, less for one that narrows towards its
    /// rim.
    #[default(180.0)]
    pub opening: f64,
    /// The names of materials of parts that have one of their own, as `{ wall = "red" }`.
    #[optional]
    pub materials: Materials,
}

/// The polar angle of a bowl's rim.
pub fn polar_angle(opening: f64) -> Result<f64, Invalid> {
    if opening > 0.0 && opening < 360.0 {
        return Ok(0.5 * opening);
    }
    let found = shown(opening);
    let problem = format!("found {found}, but degrees above 0 and below 360 are needed");
    Err(Invalid::field("opening", problem))
}

/// The spheres of a bowl, from these polar angles down.
pub fn shells(
    [inner, outer]: [f64; 2],
    [inner_rim, outer_rim]: [f64; 2],
) -> [(&'static str, Kind); 2] {
    let below = |radius, theta, inward| {
        let (center, phi) = (Point::ORIGIN, full_turn());
        Kind::from(PartSphere { center, radius, phi, theta: [theta, 180.0], inward })
    };
    [("outside", below(outer, outer_rim, false)), ("inside", below(inner, inner_rim, true))]
}

impl Specification for FlatRimmedBowl {
    fn make(&self, context: &mut Context) -> Made {
        let [inner, outer] = radii(self.inner_radius, self.outer_radius)?;
        let theta = polar_angle(self.opening)?;
        // the cut: at this height, from the inner sphere to the outer one
        let height = inner * cos_degrees(theta);
        let rim = [inner * sin_degrees(theta), ((outer - height) * (outer + height)).sqrt()];
        let outer_theta = to_degrees(atan2(rim[1], height));
        let [outside, inside] = shells([inner, outer], [theta, outer_theta]);
        let rim = Annulus {
            center: Point::new(0.0, height, 0.0),
            normal: Vector::Y,
            inner_radius: rim[0],
            outer_radius: rim[1],
        };
        solid(&[outside, inside, ("rim", rim.into())], &self.materials, None, context)
    }
}
