//! The plane (Suffern, ch. 3).

use super::{K_EPSILON, Textbook};
use crate::math::{Point, Ray, Vector};

/// `(p − point)·normal = 0`.
#[derive(Clone, Debug)]
pub struct Plane {
    /// A point of it.
    pub point: Point,
    /// Of any length.
    pub normal: Vector,
}

/// `t = (a − o)·n / (d·n)`, with no case for a ray in or beside the plane.
pub(super) fn distance(ray: &Ray, point: Point, normal: Vector) -> f64 {
    (point - ray.origin).dot(normal) / ray.direction.dot(normal)
}

impl Textbook for Plane {
    fn hit(&self, ray: &Ray) -> Option<f64> {
        let t = distance(ray, self.point, self.normal);
        (t > K_EPSILON).then_some(t)
    }
}
