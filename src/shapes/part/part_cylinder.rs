//! The part cylinder, convex and concave (Suffern, ch. 19): the points of an [`OpenCylinder`] with azimuth φ
//! between two angles, where `x = r sin φ` and `z = r cos φ`.
//!
//! Both roots of the cylinder are tested in turn for `y0 ≤ y ≤ y1` and for φ. [`Angles`] tests φ by cross
//! products with both ends; the book computes φ itself and cannot cross φ = 0.

use std::sync::Arc;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::angles::{Angles, full_turn};
use crate::invalid::Invalid;
use crate::math::{Aabb, Length, Point, Ray, Span, Vector, lists};
use crate::shapes::border::{Border, is_rounding, nears};
use crate::shapes::{
    Candidate, Context, OpenCylinder, Shape, Specification, Surface, all_of, first_of,
};

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
    /// From the first azimuth up to the second, in degrees from +z towards +x, each from −360 to 360;
    /// through 360 where the first is larger.
    #[serde(deserialize_with = "lists::exactly", default = "full_turn")]
    pub phi: [f64; 2],
    /// Whether the normal points inward: the book's concave part cylinder.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub inward: bool,
}

#[derive(Debug)]
struct PartCylinderShape {
    whole: OpenCylinder,
    phi: Angles,
}

impl Specification for PartCylinder {
    fn build(&self, _: &mut Context) -> Result<Arc<dyn Shape>, Invalid> {
        let Self { y0, y1, radius, phi, inward } = *self;
        let whole = OpenCylinder { y0, y1, radius, inward }.checked()?;
        Ok(Arc::new(PartCylinderShape { whole, phi: Angles::new("phi", phi)? }))
    }
}

impl PartCylinderShape {
    fn has(&self, ray: &Ray) -> impl Fn(f64) -> bool {
        |t| {
            let p = ray.at(t);
            let in_range = self.phi.has_azimuth_of(p.to_vector());
            in_range && self.whole.is_between_ends(ray, t)
                || nears(self.edge_distances(p), self.whole.size()) && is_rounding(self, ray, t)
        }
    }

    /// The distances from both ends and both straight sides.
    fn edge_distances(&self, p: Point) -> [f64; 4] {
        let [bottom, top] = self.whole.end_distances(p.y());
        let [start, end] = self.phi.meridian_distances(p.to_vector());
        [bottom, top, start, end]
    }
}

impl Shape for PartCylinderShape {
    fn hit(&self, ray: &Ray, span: Span) -> Option<Candidate> {
        first_of(self.whole.distances(ray)?, span, self.has(ray))
    }

    fn surface(&self, ray: &Ray, at: &Candidate) -> Surface {
        let surface = self.whole.surface(ray, at);
        let distances = self.edge_distances(surface.point);
        surface.within(Border::of(distances, self.whole.size(), || {
            let [start, end] = self.phi.away_from_meridians();
            [Vector::Y, -Vector::Y, start, end]
        }))
    }

    fn roots(&self, ray: &Ray, span: Span) -> Vec<Candidate> {
        all_of(self.whole.distances(ray), span, self.has(ray))
    }

    fn bounds(&self) -> Aabb {
        let OpenCylinder { y0, y1, radius, .. } = self.whole;
        let [min, max] = self.phi.bounds(radius, radius);
        Aabb { min: Point::new(min.x(), y0, min.z()), max: Point::new(max.x(), y1, max.z()) }
    }
}
