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

/// Where one axis' slab is entered and left. `1/d` is infinite for a ray along a slab, and `0·∞` is
/// left to chance.
#[inline]
pub(super) fn slab(ray: &Ray, min: Point, max: Point, axis: usize) -> (f64, f64) {
    let (o, a) = (ray.origin.along(axis), 1.0 / ray.direction.along(axis));
    let (low, high) = ((min.along(axis) - o) * a, (max.along(axis) - o) * a);
    if a >= 0.0 { (low, high) } else { (high, low) }
}

/// The largest entry and the smallest exit of the three slabs.
pub(super) fn slabs(ray: &Ray, min: Point, max: Point) -> (f64, f64) {
    let (mut t0, mut t1) = (f64::NEG_INFINITY, f64::INFINITY);
    for axis in 0..3 {
        let (t_min, t_max) = slab(ray, min, max, axis);
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
