//! The plane (Suffern, ch. 3).

use super::{Form, first_on};
use crate::math::{Point, Ray, Span, Vector};
use crate::shapes::{Candidate, Plane};

/// `t = (a − o)·n / (d·n)`, with no case for a ray in or beside the plane; `n` of any length.
pub(super) fn distance(ray: &Ray, point: Point, normal: Vector) -> f64 {
    (point - ray.origin).dot(normal) / ray.direction.dot(normal)
}

impl Form for Plane {
    fn first(&self, ray: &Ray, span: Span) -> Option<Candidate> {
        first_on([distance(ray, self.point, self.normal)], span, |_| true)
    }
}
