//! The box (Suffern, ch. 19): three slabs.

use super::Form;
use crate::math::{Point, Ray, Span};
use crate::shapes::{self, Candidate};

/// Where one axis' slab is entered and left. `1/d` is infinite for a ray along a slab, and `0·∞` is
/// left to chance.
fn slab(ray: &Ray, min: Point, max: Point, axis: usize) -> (f64, f64) {
    let (o, a) = (ray.origin.along(axis), 1.0 / ray.direction.along(axis));
    let (low, high) = ((min.along(axis) - o) * a, (max.along(axis) - o) * a);
    if a >= 0.0 { (low, high) } else { (high, low) }
}

/// The largest entry and the smallest exit of the three slabs, and the axes these are of.
fn crossed(ray: &Ray, min: Point, max: Point) -> [(f64, usize); 2] {
    let (mut enter, mut leave) = ((f64::NEG_INFINITY, 0), (f64::INFINITY, 0));
    for axis in 0..3 {
        let (t_min, t_max) = slab(ray, min, max, axis);
        if t_min > enter.0 {
            enter = (t_min, axis);
        }
        if t_max < leave.0 {
            leave = (t_max, axis);
        }
    }
    [enter, leave]
}

/// The largest entry and the smallest exit of the three slabs.
pub(super) fn slabs(ray: &Ray, min: Point, max: Point) -> (f64, f64) {
    let [(t0, _), (t1, _)] = crossed(ray, min, max);
    (t0, t1)
}

impl Form for shapes::Cuboid {
    /// Where it is entered, or from inside where it is left.
    fn first(&self, ray: &Ray, span: Span) -> Option<Candidate> {
        let [enter, leave] = crossed(ray, self.min, self.max);
        if enter.0 >= leave.0 {
            return None;
        }
        let (is_exit, (t, axis)) = match span.contains(enter.0) {
            true => (false, enter),
            false => (true, leave),
        };
        let is_max = is_exit == (ray.direction.along(axis) > 0.0);
        let part = 2 * axis as u32 + u32::from(is_max);
        span.contains(t).then(|| Candidate { part, ..Candidate::at(t) })
    }
}
