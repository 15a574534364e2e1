//! The solid cylinder (Suffern, ch. 19): the points with `x² + z² ≤ r²` and `y0 ≤ y ≤ y1`.
//!
//! Its surface is a compound of two disks, at y0 and y1, and an open cylinder, as in the book.

use std::sync::Arc;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::invalid::Invalid;
use crate::math::{Length, Point, Vector};
use crate::shapes::composite::assembly::{Materials, solid};
use crate::shapes::{Context, Disk, Kind, OpenCylinder, Shape, Specification};

/// The points with `x² + z² ≤ radius²` and `y0 ≤ y ≤ y1`, as the parts `bottom`, `top` and `wall`;
/// normals point outward.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SolidCylinder {
    /// The height of the bottom.
    #[schemars(with = "Length")]
    pub y0: f64,
    /// The height of the top, above `y0`.
    #[schemars(with = "Length")]
    pub y1: f64,
    /// The radius; positive.
    #[schemars(with = "Length")]
    pub radius: f64,
    /// The names of materials of parts that have one of their own, as `{ wall = "red" }`.
    #[serde(default, skip_serializing_if = "Materials::is_empty")]
    pub materials: Materials,
}

impl Specification for SolidCylinder {
    fn build(&self, context: &mut Context) -> Result<Arc<dyn Shape>, Invalid> {
        let Self { y0, y1, radius, .. } = *self;
        let wall = OpenCylinder { y0, y1, radius, inward: false };
        wall.build(context)?; // names the field that does not fit
        let cap = |y, normal| Disk { center: Point::new(0.0, y, 0.0), normal, radius };
        let parts = [
            ("bottom", Kind::from(cap(y0, -Vector::Y))),
            ("top", Kind::from(cap(y1, Vector::Y))),
            ("wall", Kind::from(wall)),
        ];
        solid(&parts, &self.materials, None, context)
    }
}
