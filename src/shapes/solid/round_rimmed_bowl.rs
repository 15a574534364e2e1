//! The round-rimmed bowl (Suffern, ch. 19 and 21): two part spheres of polar angles from θ, half
//! the opening angle, to 180°, and a rim.
//!
//! The rim is half a torus with `a = (r_in + r_out)/2 · sin θ` and `b = (r_out − r_in)/2` at the
//! height `(r_in + r_out)/2 · cos θ`. The book takes the whole torus, half of which is hidden; here
//! it goes from `90° − θ` to `270° − θ` around the tube, from sphere to sphere.

use super::flat_rimmed_bowl::{polar_angle, shells};
use crate::invalid::{Invalid, shown};
use crate::math::{Length, Vector, cos_degrees, sin_degrees};
use crate::shapes::composite::assembly::{Materials, solid};
use crate::shapes::part::angles::full_turn;
use crate::shapes::plain::annulus::radii;
use crate::shapes::solid::edges::{moved, tube};
use crate::shapes::{Context, Made, Specification};

/// The points between two spheres about the origin, ended by half a torus that touches both, as the
/// parts `outside`, `inside` and `rim`; normals point out of the bowl, those of its inside to the
/// origin.
#[kind(PartialEq)]
pub struct RoundRimmedBowl {
    /// The radius of the inside; positive.
    pub inner_radius: Length,
    /// The radius of the outside, above `inner_radius`.
    pub outer_radius: Length,
    /// The angle at which the middle of the rim is seen across from the origin, in degrees above 0
    /// and below 360: 180 for a hemispherical bowl, 120 for figure 21.16, which narrows towards its
    /// rim.
    #[default(180.0)]
    pub opening: f64,
    /// The names of materials of parts that have one of their own, as `{ wall = "red" }`.
    #[optional]
    pub materials: Materials,
}

impl Specification for RoundRimmedBowl {
    fn make(&self, context: &mut Context) -> Made {
        let [inner, outer] = radii(self.inner_radius, self.outer_radius)?;
        let theta = polar_angle(self.opening)?;
        let (middle, thin) = (0.5 * (inner + outer), 0.5 * (outer - inner));
        let swept = middle * sin_degrees(theta);
        if swept <= thin {
            let found = shown(self.opening);
            let problem = format!("found {found}, but so thick a rim would close the bowl");
            return Err(Invalid::field("opening", problem));
        }
        let from = if theta <= 90.0 { 90.0 - theta } else { 450.0 - theta };
        let half = tube(swept, thin, full_turn(), [from, 270.0 - theta]);
        let rim = moved(half, middle * cos_degrees(theta) * Vector::Y);
        let [outside, inside] = shells([inner, outer], [theta, theta]);
        solid(&[outside, inside, ("rim", rim)], &self.materials, None, context)
    }
}
