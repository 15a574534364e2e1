//! The disk (Suffern, ch. 19).

use super::{K_EPSILON, Textbook, plane};
use crate::math::{Point, Ray, Vector};

/// The part of a plane with `|p − center|² < radius²`.
#[derive(Clone, Debug)]
pub struct Disk {
    /// The centre.
    pub center: Point,
    /// Of any length.
    pub normal: Vector,
    /// The radius.
    pub radius: f64,
}

impl Textbook for Disk {
    fn hit(&self, ray: &Ray) -> Option<f64> {
        let t = plane::distance(ray, self.center, self.normal);
        if t <= K_EPSILON {
            return None;
        }
        let r_squared = self.radius * self.radius;
        (self.center.distance_squared(ray.at(t)) < r_squared).then_some(t)
    }
}
