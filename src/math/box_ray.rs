//! The slab test: where a ray enters and leaves boxes (Suffern, ch. 19).

use super::UNIT_ROUNDOFF;
use super::bounds::Aabb;
use super::ray::Ray;

/// Boxes are grown by this part of the largest coordinate of the ray's origin and of the boxes: more than
/// the error of any shape's hit in its box, and than the roundings below.
const SLACK: f64 = 128.0 * UNIT_ROUNDOFF;

/// A ray prepared for tests against many boxes, which are grown by a slack on all sides.
///
/// A ray enters the slab between two planes across an axis where it meets the first and leaves it where
/// it meets the second: `(plane − o) / d`. It is in the box between its last entry and its first exit.
#[derive(Clone, Copy, Debug)]
pub struct BoxRay {
    /// `o + slack` and `o − slack`: lower planes are moved down by the slack, upper planes up.
    lower: [f64; 3],
    upper: [f64; 3],
    /// `1/d`; infinite for a ray along the planes.
    inverse: [f64; 3],
    slack: f64,
}

impl BoxRay {
    /// The ray prepared for boxes whose coordinates are at most `largest` in size.
    #[inline]
    pub fn new(ray: &Ray, largest: f64) -> Self {
        let slack = SLACK * (ray.origin.to_vector().max_abs() + largest);
        let [x, y, z] = ray.origin.to_array();
        let [dx, dy, dz] = ray.direction.to_array();
        Self {
            lower: [x + slack, y + slack, z + slack],
            upper: [x - slack, y - slack, z - slack],
            inverse: [1.0 / dx, 1.0 / dy, 1.0 / dz],
            slack,
        }
    }

    /// The amount by which boxes are grown.
    pub fn slack(&self) -> f64 {
        self.slack
    }

    /// One over the direction.
    pub fn inverse(&self) -> [f64; 3] {
        self.inverse
    }

    /// Where the ray enters and leaves the grown box, between `start` and `end`; if it misses, the entry is
    /// beyond the exit. (A ray exactly in a plane of the grown box, where `0·∞` is NaN, counts as a hit or
    /// as a miss.)
    #[inline]
    pub fn crossing(&self, bounds: &Aabb, start: f64, end: f64) -> (f64, f64) {
        let low = |axis: usize| (bounds.min.along(axis) - self.lower[axis]) * self.inverse[axis];
        let high = |axis: usize| (bounds.max.along(axis) - self.upper[axis]) * self.inverse[axis];
        let [x, y, z] = [(low(0), high(0)), (low(1), high(1)), (low(2), high(2))];
        let enter = max(max(min(x.0, x.1), min(y.0, y.1)), max(min(z.0, z.1), start));
        let leave = min(min(max(x.0, x.1), max(y.0, y.1)), min(max(z.0, z.1), end));
        (enter, leave)
    }
}

/// `f64::min` handles NaN differently, which costs three more instructions.
#[inline(always)]
fn min(a: f64, b: f64) -> f64 {
    if a < b { a } else { b }
}

#[inline(always)]
fn max(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}
