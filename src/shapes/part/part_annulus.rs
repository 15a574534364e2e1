//! The part annulus (Suffern, ch. 19): the points of a level [`Annulus`](super::Annulus) with
//! azimuth φ between two angles, where `x = ρ sin φ` and `z = ρ cos φ`.
//!
//! A hit of the plane is tested for its distance from the centre and for φ. [`Angles`] tests φ by
//! cross products with both ends; the book computes φ itself and cannot cross φ = 0.

use super::angles::{Angles, full_turn};
use crate::invalid::Invalid;
use crate::math::{Length, Point, Vector, Width};
use crate::shapes::plain::annulus::{Radii, radii};
use crate::shapes::plain::plane::PlaneThrough;
use crate::shapes::trimmed::Trimmed;
use crate::shapes::{Context, Made, Specification, made};

/// The part of a level annulus within a range of azimuths.
#[kind(PartialEq)]
pub struct PartAnnulus {
    /// The centre.
    pub center: Point,
    /// Upward or downward, as azimuths are about the y axis; need not be unit.
    #[default(Vector::Y)]
    pub normal: Vector,
    /// The radius of the hole; not negative.
    pub inner_radius: Width,
    /// The outer radius, above `inner_radius`.
    pub outer_radius: Length,
    /// From the first azimuth up to the second, in degrees from +z towards +x, each from −360 to
    /// 360; through 360 where the first is larger.
    #[default(full_turn())]
    pub phi: [f64; 2],
}

impl Specification for PartAnnulus {
    fn make(&self, _: &mut Context) -> Made {
        let plane = PlaneThrough::checked(self.center, self.normal)?;
        check_vertical(self.normal)?;
        let ends = radii(self.inner_radius, self.outer_radius)?;
        let (radii, phi) = (Radii::between(ends), Angles::new("phi", self.phi)?);
        let (size, bounds) = (radii.size(self.center), phi.bounds(self.center, ends, [0.0; 2]));
        made(Trimmed::new(plane, (radii, phi), size, bounds))
    }
}

/// Refuses a field `normal` that is not along the y axis.
fn check_vertical(normal: Vector) -> Result<(), Invalid> {
    if normal.across_y() == Vector::ZERO {
        return Ok(());
    }
    let found = normal.to_array();
    let problem = format!(
        "found {found:?}, but a part annulus is level: [0, 1, 0] or [0, -1, 0]; an instance tilts it"
    );
    Err(Invalid::field("normal", problem))
}
