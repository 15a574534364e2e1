//! The open cylinder (Suffern, ch. 19), a wall without ends: the points with `x² + z² = r²` and
//! `y0 ≤ y ≤ y1`.
//!
//! A ray meets it where `a t² + 2 b t + c = 0` with `a = d_x² + d_z²`, `b = o_x d_x + o_z d_z` and
//! `c = o_x² + o_z² − r²` (the book's `b` is twice as large). Both roots are tested in turn: if the near
//! one is beyond an end, the far one may not be. The discriminant `b² − a c` is taken as
//! `a r² − (o_x d_z − o_z d_x)²`, which keeps its digits for far origins and thin cylinders
//! ([`circle_roots`]).
//!
//! The book's own routine: `src/shapes/textbook/open_cylinder.rs`.

use std::sync::Arc;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::invalid::{Invalid, finite, length};
use crate::math::{Aabb, Length, Point, Ray, Span, UNIT_ROUNDOFF, Vector, circle_roots};
use crate::shapes::border::{Border, is_rounding, nears};
use crate::shapes::{
    Candidate, Context, Shape, Specification, Surface, all_of, first_of, normal_along,
};

/// The points with `x² + z² = radius²` and `y0 ≤ y ≤ y1`; the normal points outward, or to the axis.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct OpenCylinder {
    /// The lower end.
    #[schemars(with = "Length")]
    pub y0: f64,
    /// The upper end, above `y0`.
    #[schemars(with = "Length")]
    pub y1: f64,
    /// The radius; positive.
    #[schemars(with = "Length")]
    pub radius: f64,
    /// Whether the normal points to the axis: the book's concave open cylinder.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub inward: bool,
}

impl Specification for OpenCylinder {
    fn build(&self, _: &mut Context) -> Result<Arc<dyn Shape>, Invalid> {
        Ok(Arc::new(self.checked()?))
    }
}

impl OpenCylinder {
    /// A copy whose numbers are fit for use.
    pub(in crate::shapes) fn checked(&self) -> Result<Self, Invalid> {
        let (y0, y1) = (finite("y0", self.y0)?, finite("y1", self.y1)?);
        if y0 >= y1 {
            return Err(Invalid::field("y1", format!("found {y1}, but it must be above y0, {y0}")));
        }
        length("radius", self.radius)?;
        Ok(self.clone())
    }

    /// Where the line meets the endless cylinder, ascending.
    #[inline(always)] // as the roots it calls
    pub(in crate::shapes) fn distances(&self, ray: &Ray) -> Option<[f64; 2]> {
        let ([ox, _, oz], [dx, _, dz]) = (ray.origin.to_array(), ray.direction.to_array());
        circle_roots([ox, oz], [dx, dz], self.radius)
    }

    /// Whether `y0 ≤ y ≤ y1` at `t`.
    pub(in crate::shapes) fn is_between_ends(&self, ray: &Ray, t: f64) -> bool {
        let y = ray.origin.y() + t * ray.direction.y();
        self.y0 <= y && y <= self.y1
    }

    /// The distances from both ends.
    pub(in crate::shapes) fn end_distances(&self, y: f64) -> [f64; 2] {
        [y - self.y0, self.y1 - y]
    }

    /// The largest number in its tests.
    pub(in crate::shapes) fn size(&self) -> f64 {
        self.radius.max(self.y0.abs()).max(self.y1.abs())
    }

    fn has(&self, ray: &Ray) -> impl Fn(f64) -> bool {
        |t| {
            let nears_end = || nears(self.end_distances(ray.at(t).y()), self.size());
            self.is_between_ends(ray, t) || nears_end() && is_rounding(self, ray, t)
        }
    }
}

impl Shape for OpenCylinder {
    fn hit(&self, ray: &Ray, span: Span) -> Option<Candidate> {
        first_of(self.distances(ray)?, span, self.has(ray))
    }

    fn surface(&self, ray: &Ray, at: &Candidate) -> Surface {
        let raw = ray.at(at.t);
        let flat_ray = Ray::new(ray.origin, ray.direction.across_y());
        let normal = normal_along(raw.to_vector().across_y(), &flat_ray);
        let r = self.radius * normal;
        let point = Point::new(r.x(), raw.y(), r.z());
        let border =
            Border::of(self.end_distances(point.y()), self.size(), || [Vector::Y, -Vector::Y]);
        Surface::new(point, 12.0 * UNIT_ROUNDOFF * self.radius, normal)
            .turned(self.inward)
            .within(border)
    }

    fn roots(&self, ray: &Ray, span: Span) -> Vec<Candidate> {
        all_of(self.distances(ray), span, self.has(ray))
    }

    fn bounds(&self) -> Aabb {
        let r = self.radius;
        Aabb { min: Point::new(-r, self.y0, -r), max: Point::new(r, self.y1, r) }
    }
}
