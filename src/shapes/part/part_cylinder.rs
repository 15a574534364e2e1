//! The part cylinder, convex and concave (Suffern, ch. 19): the points of an [`OpenCylinder`] with
//! azimuth φ between two angles, where `x = r sin φ` and `z = r cos φ`.
//!
//! Both roots of the cylinder are tested in turn for `y0 ≤ y ≤ y1` and for φ. [`Angles`] tests φ by
//! cross products with both ends; the book computes φ itself and cannot cross φ = 0.

use super::angles::{Angles, full_turn};
use crate::math::{Coordinate, Length, Point};
use crate::shapes::plain::open_cylinder::Heights;
use crate::shapes::trimmed::Trimmed;
use crate::shapes::{Context, Made, OpenCylinder, Specification, made};

/// The part of an open cylinder within a range of azimuths.
#[kind(PartialEq)]
pub struct PartCylinder {
    /// The lower end.
    pub y0: Coordinate,
    /// The upper end, above `y0`.
    pub y1: Coordinate,
    /// The radius; positive.
    pub radius: Length,
    /// From the first azimuth up to the second, in degrees from +z towards +x, each from −360 to
    /// 360; through 360 where the first is larger.
    #[default(full_turn())]
    pub phi: [f64; 2],
    /// Whether the normal points inward: the book's concave part cylinder.
    #[optional]
    pub inward: bool,
}

impl Specification for PartCylinder {
    fn make(&self, _: &mut Context) -> Made {
        let Self { y0, y1, radius, phi, inward } = *self;
        let whole = OpenCylinder { y0, y1, radius, inward }.checked()?;
        let phi = Angles::new("phi", phi)?;
        let bounds = phi.bounds(Point::ORIGIN, [radius; 2], [y0, y1]);
        let trims = (Heights { y0, y1 }, phi);
        made(Trimmed::new(whole.cylinder(), trims, whole.size(), bounds))
    }
}
