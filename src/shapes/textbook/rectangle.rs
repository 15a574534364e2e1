//! The rectangle (Suffern, ch. 19).

use super::{first_on, plane};
use crate::math::{Point, Ray, Span, Vector};
use crate::shapes::{Candidate, Rectangle};

/// `corner + x` with `0 ≤ x·a ≤ |a|²` and `0 ≤ x·b ≤ |b|²`.
#[derive(Debug)]
pub(super) struct RectangleForm {
    corner: Point,
    a: Vector,
    b: Vector,
    normal: Vector,
    a_len_squared: f64,
    b_len_squared: f64,
}

impl RectangleForm {
    pub(super) fn new(&Rectangle { corner, a, b }: &Rectangle) -> Self {
        let normal = a.cross(b).unit().unwrap_or(Vector::ZERO);
        let (a_len_squared, b_len_squared) = (a.length_squared(), b.length_squared());
        Self { corner, a, b, normal, a_len_squared, b_len_squared }
    }
}

impl super::Form for RectangleForm {
    fn first(&self, ray: &Ray, span: Span) -> Option<Candidate> {
        let t = plane::distance(ray, self.corner, self.normal);
        first_on([t], span, |t| {
            let d = ray.at(t) - self.corner;
            (0.0..=self.a_len_squared).contains(&d.dot(self.a))
                && (0.0..=self.b_len_squared).contains(&d.dot(self.b))
        })
    }
}
