//! The sphere (Suffern, ch. 3).

use super::{K_EPSILON, Textbook, schoolbook_roots};
use crate::math::{Point, Ray};

/// `|p − center|² = radius²`.
#[derive(Clone, Debug)]
pub struct Sphere {
    /// The centre.
    pub center: Point,
    /// The radius.
    pub radius: f64,
}

/// `a = d·d`, `b = 2 (o − c)·d`, `c = (o − c)·(o − c) − r²`.
pub(super) fn roots(ray: &Ray, center: Point, radius: f64) -> Option<[f64; 2]> {
    let temp = ray.origin - center;
    let a = ray.direction.dot(ray.direction);
    let b = 2.0 * temp.dot(ray.direction);
    let c = temp.dot(temp) - radius * radius;
    schoolbook_roots(a, b, c)
}

impl Textbook for Sphere {
    fn hit(&self, ray: &Ray) -> Option<f64> {
        roots(ray, self.center, self.radius)?.into_iter().find(|&t| t > K_EPSILON)
    }
}
