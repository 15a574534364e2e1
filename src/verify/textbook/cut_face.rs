//! The cut face (Suffern, ch. 19): a square with a hole.

use super::{K_EPSILON, Textbook, plane};
use crate::math::{Point, Ray, Vector};

/// The points of `y = 0` with `|x|, |z| ≤ size/2` and `x² + z² ≥ radius²`.
#[derive(Clone, Debug)]
pub struct CutFace {
    /// The length of the sides.
    pub size: f64,
    /// The radius of the hole.
    pub radius: f64,
}

impl Textbook for CutFace {
    fn hit(&self, ray: &Ray) -> Option<f64> {
        let t = plane::distance(ray, Point::ORIGIN, Vector::Y);
        if t <= K_EPSILON {
            return None;
        }
        let p = ray.at(t);
        let half = 0.5 * self.size;
        let is_on_square = p.x().abs() <= half && p.z().abs() <= half;
        let squared = p.x() * p.x() + p.z() * p.z();
        (is_on_square && squared >= self.radius * self.radius).then_some(t)
    }
}
