//! The sphere (Suffern, ch. 3).

use super::{Form, first_on, schoolbook_roots};
use crate::math::{Point, Ray, Span};
use crate::shapes::{Candidate, Sphere};

/// `a = d·d`, `b = 2 (o − c)·d`, `c = (o − c)·(o − c) − r²`.
pub(super) fn roots(ray: &Ray, center: Point, radius: f64) -> Option<[f64; 2]> {
    let temp = ray.origin - center;
    let a = ray.direction.dot(ray.direction);
    let b = 2.0 * temp.dot(ray.direction);
    let c = temp.dot(temp) - radius * radius;
    schoolbook_roots(a, b, c)
}

impl Form for Sphere {
    fn first(&self, ray: &Ray, span: Span) -> Option<Candidate> {
        first_on(roots(ray, self.center, self.radius)?, span, |_| true)
    }
}
