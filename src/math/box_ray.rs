//! The slab test: where a ray enters and leaves boxes (Suffern, ch. 19).

use super::UNIT_ROUNDOFF;
use super::bounds::Aabb;
use super::ray::Ray;

/// Boxes are grown by this part of the largest coordinate of the ray's origin and of the boxes:
/// more than the error of any shape's hit in its box, and than the roundings below.
const SLACK: f64 = 128.0 * UNIT_ROUNDOFF;

/// A ray prepared for tests against many boxes, which are grown by a slack on all sides.
///
/// A ray enters the slab between two planes across an axis where it meets the first and leaves it
/// where it meets the second: `(plane − o) / d`. It is in the box between its last entry and its
/// first exit.
#[derive(Clone, Copy, Debug)]
pub struct BoxRay {
    /// `o + slack` for lower planes and `o − slack` for upper ones: those are moved down by the
    /// slack, these up.
    origins: [[f64; 3]; 2],
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
            origins: [slack, -slack].map(|slack| [x + slack, y + slack, z + slack]),
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

    /// Where the ray enters and leaves the grown box, between `start` and `end`; if it misses, the
    /// entry is beyond the exit. (A ray exactly in a plane of the grown box, where `0·∞` is NaN,
    /// counts as a hit or as a miss.)
    #[inline]
    pub fn crossing(&self, bounds: &Aabb, start: f64, end: f64) -> (f64, f64) {
        let [lower, upper] = &self.origins;
        let low = |axis: usize| (bounds.min.along(axis) - lower[axis]) * self.inverse[axis];
        let high = |axis: usize| (bounds.max.along(axis) - upper[axis]) * self.inverse[axis];
        let [x, y, z] = [(low(0), high(0)), (low(1), high(1)), (low(2), high(2))];
        let enter = max(max(min(x.0, x.1), min(y.0, y.1)), max(min(z.0, z.1), start));
        let leave = min(min(max(x.0, x.1), max(y.0, y.1)), min(max(z.0, z.1), end));
        (enter, leave)
    }

    /// The same for two boxes.
    #[inline(always)]
    pub fn crossings(&self, boxes: &TwoBoxes, start: f64, end: f64) -> [(f64, f64); 2] {
        let mut crossings = [(start, end); 2];
        for axis in 0..3 {
            // the planes that the ray meets first are the upper ones if it goes down
            let first = usize::from(self.inverse[axis] < 0.0);
            for (k, (enter, leave)) in crossings.iter_mut().enumerate() {
                let meets = |side: usize| {
                    (boxes.planes[side][axis][k] - self.origins[side][axis]) * self.inverse[axis]
                };
                *enter = max(meets(first), *enter);
                *leave = min(meets(1 - first), *leave);
            }
        }
        crossings
    }
}

/// Two boxes with their planes side by side: lower and upper ones, for each axis those of both
/// boxes.
#[derive(Clone, Copy, Debug)]
pub struct TwoBoxes {
    planes: [[[f64; 2]; 3]; 2],
}

impl TwoBoxes {
    /// The first and the second box.
    pub fn new(first: &Aabb, second: &Aabb) -> Self {
        let planes = [[first.min, second.min], [first.max, second.max]];
        Self { planes: planes.map(|[a, b]| [0, 1, 2].map(|axis| [a.along(axis), b.along(axis)])) }
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
