//! The box (Suffern, ch. 19): three slabs.

use super::{K_EPSILON, Textbook};
use crate::math::{Point, Ray};

/// The box between two corners.
#[derive(Clone, Debug)]
pub struct Cuboid {
    /// The corner of least coordinates.
    pub min: Point,
    /// The corner of greatest coordinates.
    pub max: Point,
}

/// The largest entry and the smallest exit of the three slabs. `1/d` is infinite for a ray along a
/// slab, and `0·∞` is left to chance.
pub(super) fn slabs(ray: &Ray, min: Point, max: Point) -> (f64, f64) {
    let (mut t0, mut t1) = (f64::NEG_INFINITY, f64::INFINITY);
    for i in 0..3 {
        let (o, a) = (ray.origin.along(i), 1.0 / ray.direction.along(i));
        let (low, high) = ((min.along(i) - o) * a, (max.along(i) - o) * a);
        let (t_min, t_max) = if a >= 0.0 { (low, high) } else { (high, low) };
        if t_min > t0 {
            t0 = t_min;
        }
        if t_max < t1 {
            t1 = t_max;
        }
    }
    (t0, t1)
}

impl Textbook for Cuboid {
    /// Where it is entered, or from inside where it is left.
    fn hit(&self, ray: &Ray) -> Option<f64> {
        let (t0, t1) = slabs(ray, self.min, self.max);
        if !(t0 < t1 && t1 > K_EPSILON) {
            return None;
        }
        Some(if t0 > K_EPSILON { t0 } else { t1 })
    }
}
