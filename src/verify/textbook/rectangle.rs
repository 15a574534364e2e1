//! The rectangle (Suffern, ch. 19).

use super::{K_EPSILON, Textbook, plane};
use crate::math::{Normal, Point, Ray, Vector};

/// `corner + x` with `0 ≤ x·a ≤ |a|²` and `0 ≤ x·b ≤ |b|²`.
#[derive(Clone, Debug)]
pub struct Rectangle {
    corner: Point,
    a: Vector,
    b: Vector,
    normal: Vector,
    a_len_squared: f64,
    b_len_squared: f64,
}

impl Rectangle {
    /// The rectangle with these sides.
    pub fn new(corner: Point, a: Vector, b: Vector) -> Self {
        let normal = Normal::new(a.cross(b)).map_or(Vector::ZERO, Vector::from);
        let (a_len_squared, b_len_squared) = (a.length_squared(), b.length_squared());
        Self { corner, a, b, normal, a_len_squared, b_len_squared }
    }
}

impl Textbook for Rectangle {
    fn hit(&self, ray: &Ray) -> Option<f64> {
        let t = plane::distance(ray, self.corner, self.normal);
        if t <= K_EPSILON {
            return None;
        }
        let d = ray.at(t) - self.corner;
        let (along_a, along_b) = (d.dot(self.a), d.dot(self.b));
        if along_a < 0.0
            || along_a > self.a_len_squared
            || along_b < 0.0
            || along_b > self.b_len_squared
        {
            return None;
        }
        Some(t)
    }
}
