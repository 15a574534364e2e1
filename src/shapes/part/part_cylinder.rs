//! The part cylinder, convex and concave (Suffern, ch. 19): the points of an [`OpenCylinder`] with
//! azimuth φ between two angles, where `x = r sin φ` and `z = r cos φ`.
//!
//! Both roots of the cylinder are tested in turn for `y0 ≤ y ≤ y1` and for φ. [`Angles`] tests φ by
//! cross products with both ends; the book computes φ itself and cannot cross φ = 0.

use std::sync::Arc;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::angles::{Angles, full_turn};
use crate::invalid::Invalid;
use crate::math::{Length, Point, lists};
use crate::shapes::plain::open_cylinder::Heights;
use crate::shapes::trimmed::Trimmed;
use crate::shapes::{Context, OpenCylinder, Shape, Specification};

/// The part of an open cylinder within a range of azimuths.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PartCylinder {
    /// The lower end.
    #[schemars(with = "Length")]
    pub y0: f64,
    /// The upper end, above `y0`.
    #[schemars(with = "Length")]
    pub y1: f64,
    /// The radius; positive.
    #[schemars(with = "Length")]
    pub radius: f64,
    /// From the first azimuth up to the second, in degrees from +z towards +x, each from −360 to
    /// 360; through 360 where the first is larger.
    #[serde(deserialize_with = "lists::exactly", default = "full_turn")]
    pub phi: [f64; 2],
    /// Whether the normal points inward: the book's concave part cylinder.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub inward: bool,
}

impl Specification for PartCylinder {
    fn build(&self, _: &mut Context) -> Result<Arc<dyn Shape>, Invalid> {
        let Self { y0, y1, radius, phi, inward } = *self;
        let whole = OpenCylinder { y0, y1, radius, inward }.checked()?;
        let phi = Angles::new("phi", phi)?;
        let bounds = phi.bounds(Point::ORIGIN, [radius; 2], [y0, y1]);
        let trims = (Heights { y0, y1 }, phi);
        Ok(Arc::new(Trimmed::new(whole.cylinder(), trims, whole.size(), bounds)))
    }
}
