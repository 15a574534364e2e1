//! The frame in which boxes and rays are compared, by every method alike; and the counting rule.
//!
//! The frame's origin is the middle of all (bounded) boxes, and its unit a power of two such that
//! their coordinates lie in [−1, 1]. A ray from nearby ([`NEAR`]) with a direction of ordinary length
//! is only moved and scaled. Any other enters where its line meets the frame's own box, with a
//! direction whose largest component lies in [1, 2). So no number is large, wherever the ray comes
//! from.
//!
//! **The counting rule**: a hit of a bounded primitive counts only if it lies where the ray crosses
//! the primitive's box, grown on all sides by a *slack*: 2⁻²³ of the box's longest side, for what
//! rounding does to the box and to the shape in it, and 2⁻³⁶ of the distance that the ray comes from
//! and of the coordinates, for what it does to the ray and to `t`. Both are many thousand roundings,
//! so no true hit is lost. The slack never decides by itself: it only settles, for all methods at
//! once, the hits that rounding has put beside the surface's own box (a ray within rounding of a
//! triangle's plane may meet it anywhere).
//!
//! **Why no method can skip a hit that another counts.** All ask this rule, in the same `f64`
//! operations, before a hit counts, or know that it would say yes (`shapes/triangle_block.rs`). A
//! method may skip a primitive only because
//! - the ray has no part in the frame ([`Frame::ray`] is `None`): the same for all methods;
//! - the ray does not cross a box that contains the primitive's, or crosses it beyond the best hit
//!   or before the span. In `f64`, by [`FrameRay::crossing`], every operation is monotone, so the
//!   interval of a box contains that of each box in it, to the last bit. In `f32`, and in a frame
//!   of a part of the boxes ([`Frame::of_part`]), the boxes are larger by more than all roundings:
//!   see `accel/bvh/node.rs`.
//!
//! Intervals are closed and compared by `<=`, so of equal hits all are seen, and the first counts.

use crate::math::{Aabb, Point, Ray, Span, Vector, power_of_two};

/// Grows a box by so much of its longest side: 2²⁹ roundings of a coordinate in it.
const SIDE_SLACK: f64 = 1.0 / (1 << 23) as f64;
/// Grows it further by so much of what the ray and the coordinates reach: 2¹⁷ roundings.
const FAR_SLACK: f64 = 1.0 / (1_u64 << 36) as f64;
/// Origins with coordinates so small stay where they are: two scenes away.
pub const NEAR: f64 = 4.0;
/// From where the slack would be larger than any frame, a ray is taken to cross all boxes.
const MOST_SLACK: f64 = 1024.0;
/// Lengths of directions, in the frame's units, for which no number overflows or underflows here.
const NUMBERS: std::ops::Range<f64> = 1e-100..1e100;
/// Directions whose largest component is of such a power of two are used as they are.
const ORDINARY: std::ops::RangeInclusive<i32> = -30..=30;
/// A frame is not smaller than this part of the coordinates in it: what is has few digits of its own.
const LEAST_SIZE: f64 = 1.0 / (1 << 30) as f64;

/// Where a set of boxes lies, and how large it is.
#[derive(Clone, Copy, Debug)]
pub struct Frame {
    middle: Point,
    /// Units of the frame in one unit of the world.
    scale: f64,
    /// The size of the frame of all boxes, or the largest coordinate in the world if that is more,
    /// in units of this frame: at least [`NEAR`].
    reach: f64,
    /// Origins with coordinates up to this stay where they are: [`NEAR`], or none at all where
    /// numbers are extreme.
    near: f64,
}

/// A ray in a frame. What it meets at `t` is at `origin + (unit·t − start) · direction`.
#[derive(Clone, Copy, Debug)]
pub struct FrameRay {
    pub(super) origin: [f64; 3],
    /// One over the direction; a zero component gives an infinity of its sign.
    pub(super) inverse: [f64; 3],
    unit: f64,
    start: f64,
    /// The slack of a box that has no sides.
    far_slack: f64,
}

impl Frame {
    /// The frame of these boxes; the unbounded ones do not count.
    pub fn around(bounds: &[Aabb]) -> Self {
        let bounded = bounds.iter().filter(|b| b.is_bounded());
        let whole = bounded.fold(Aabb::EMPTY, |all, &b| all.union(b));
        if !whole.is_bounded() {
            return Self::new(Point::ORIGIN, 1.0, NEAR);
        }
        let (min, max) = (0.5 * whole.min.to_vector(), 0.5 * whole.max.to_vector()); // no overflow
        let largest = 2.0 * min.max_abs().max(max.max_abs());
        let size = (max - min).max_abs().max(LEAST_SIZE * largest);
        // the power of two above the size, but for sizes that have no such reciprocal
        let scale = 0.25 * power_of_two(1 - exponent(size).max(-1000));
        Self::new(Point::ORIGIN + (min + max), scale, (scale * largest).max(NEAR))
    }

    /// The frame of some of the boxes, which are much smaller than the frame of all, this one.
    pub fn of_part(&self, bounds: &[Aabb]) -> Self {
        let part = Self::around(bounds);
        Self::new(part.middle, part.scale, self.reach * (part.scale / self.scale))
    }

    fn new(middle: Point, scale: f64, reach: f64) -> Self {
        let is_extreme = !NUMBERS.contains(&(scale)) || FAR_SLACK * reach > MOST_SLACK;
        Self { middle, scale, reach, near: if is_extreme { -1.0 } else { NEAR } }
    }

    /// A box of the world in the coordinates of the frame.
    pub fn boxed(&self, bounds: &Aabb) -> Aabb {
        let point = |p| Point::ORIGIN + self.off_middle(p);
        Aabb { min: point(bounds.min), max: point(bounds.max) }
    }

    #[inline]
    fn off_middle(&self, p: Point) -> Vector {
        self.scale * (p - self.middle)
    }

    /// The ray as the frame sees it, or `None` if it passes beside all boxes.
    pub fn ray(&self, ray: &Ray) -> Option<FrameRay> {
        self.ray_from_near(ray).or_else(|| self.ray_from_afar(ray))
    }

    /// The same for an ordinary ray: one from nearby, which need not be moved; `None` for others.
    #[inline(always)] // a call would hand it over in memory, which stalls
    pub fn ray_from_near(&self, ray: &Ray) -> Option<FrameRay> {
        let origin = self.off_middle(ray.origin);
        let is_ordinary = ORDINARY.contains(&exponent(ray.direction.max_abs()));
        (origin.max_abs() <= self.near && is_ordinary).then(|| FrameRay {
            origin: origin.to_array(),
            inverse: ray.direction.to_array().map(|d| 1.0 / d),
            unit: self.scale,
            start: 0.0,
            far_slack: FAR_SLACK * self.reach,
        })
    }

    /// The same for any ray, with its origin where it enters the frame, so that no box is behind it.
    pub fn ray_from_afar(&self, ray: &Ray) -> Option<FrameRay> {
        let origin = self.off_middle(ray.origin).to_array();
        let longest = exponent(ray.direction.max_abs());
        let direction = (power_of_two(-longest.clamp(-1022, 1022)) * ray.direction).to_array();
        let unit = self.scale * power_of_two(longest.clamp(-1022, 1022));
        let farther = |d: f64, x: f64| if x.abs() > d { x.abs() } else { d };
        let far_slack = FAR_SLACK * origin.into_iter().fold(self.reach, farther);
        if !(far_slack <= MOST_SLACK && NUMBERS.contains(&unit) && longest.abs() < 1022) {
            return Some(FrameRay::EVERYWHERE);
        }
        let inverse = direction.map(|d| 1.0 / d);
        // far more than any slack, so the line enters here before it enters any grown box
        let half = 1.0 + 2048.0 * (2.0 * SIDE_SLACK + far_slack);
        let (mut enter, mut leave) = (f64::NEG_INFINITY, f64::INFINITY);
        for i in 0..3 {
            let (near, far) = (half.copysign(-inverse[i]), half.copysign(inverse[i]));
            (enter, leave) = narrowed((enter, leave), near, far, origin[i], inverse[i]);
        }
        if enter > leave {
            return None;
        }
        let origin: [f64; 3] = std::array::from_fn(|i| origin[i] + enter * direction[i]);
        Some(FrameRay { origin, inverse, unit, start: enter, far_slack })
    }
}

/// The interval of a ray between two planes across an axis, as far as it lies in another one.
///
/// A zero direction component gives NaN where the origin lies on a plane (0·∞): the comparisons
/// drop it, so such a ray is inside.
#[inline]
fn narrowed(
    (enter, leave): (f64, f64),
    near: f64,
    far: f64,
    origin: f64,
    inverse: f64,
) -> (f64, f64) {
    let (near, far) = ((near - origin) * inverse, (far - origin) * inverse);
    (if near > enter { near } else { enter }, if far < leave { far } else { leave })
}

impl FrameRay {
    /// For rays from too far away, or too long or short to have numbers in the frame: crosses every box, and every hit of it is at 0.
    const EVERYWHERE: Self =
        Self { origin: [0.0; 3], inverse: [0.0; 3], unit: 0.0, start: 0.0, far_slack: 0.0 };

    /// The distance from where the ray enters the frame, of what is at `t`; monotone in `t`.
    #[inline]
    pub fn moved(&self, t: f64) -> f64 {
        self.unit * t - self.start
    }

    /// How much a box (of the frame) is grown; monotone in the box.
    #[inline]
    pub fn slack(&self, bounds: &Aabb) -> f64 {
        let side = |i: usize| bounds.max.along(i) - bounds.min.along(i);
        SIDE_SLACK * side(0).max(side(1)).max(side(2)) + self.far_slack
    }

    /// Origin, one over the direction, and the slack as nodes in single precision take them: only
    /// the far part of the slack, four times (`accel/bvh/node.rs`).
    #[inline]
    pub fn single(&self) -> ([f64; 3], [f64; 3], f64) {
        if self.unit == 0.0 {
            return ([0.0; 3], [1.0; 3], 1e30); // everywhere
        }
        (self.origin, self.inverse, 4.0 * self.far_slack)
    }

    /// Where the span begins, or the frame: no box lies before that (of a ray from nearby, only if the
    /// span begins at no negative `t`).
    #[inline]
    pub fn first(&self, span: Span) -> f64 {
        self.moved(span.min).max(0.0) // also where it is not a number
    }

    /// Where what is at `t` lies, the end of what is wanted.
    #[inline]
    pub fn last(&self, t: f64) -> f64 {
        self.moved(t).min(f64::INFINITY) // also where it is not a number
    }

    /// Whether a hit of the primitive in this box (of the frame) counts: the rule.
    #[inline]
    pub fn counts(&self, bounds: &Aabb, t: f64) -> bool {
        let (near, far) = self.crossing(bounds);
        let t = self.moved(t);
        near <= t && t <= far
    }

    /// The distances at which the ray enters and leaves a box (of the frame) grown by the slack;
    /// the entry is beyond the exit if it misses. Every operation is monotone, so the interval of a
    /// box contains that of every box inside it, to the last bit.
    #[inline]
    pub fn crossing(&self, bounds: &Aabb) -> (f64, f64) {
        let slack = self.slack(bounds);
        let mut interval = (f64::NEG_INFINITY, f64::INFINITY);
        for i in 0..3 {
            let planes = [bounds.min.along(i) - slack, bounds.max.along(i) + slack];
            let backward = usize::from(self.inverse[i].is_sign_negative());
            let (near, far) = (planes[backward], planes[1 - backward]);
            interval = narrowed(interval, near, far, self.origin[i], self.inverse[i]);
        }
        interval
    }
}

/// `e` with `2^e ≤ x < 2^(e + 1)`, for a positive normal number; −1023 for 0 and what is too small,
/// 1024 for what is no number.
#[inline]
fn exponent(x: f64) -> i32 {
    ((x.to_bits() >> 52) & 0x7ff) as i32 - 1023
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Law: a ray in the plane of a box's grown face is inside that slab, whatever the sign of the
    /// zero in its direction. Oracle: worked by hand, in numbers that are exact.
    #[test]
    fn a_ray_in_a_grown_face_is_inside() {
        let corner = Point::new(1.0, 1.0, 1.0);
        let frame = Frame::around(&[Aabb { min: Point::ORIGIN - corner.to_vector(), max: corner }]);
        for zero in [0.0, -0.0] {
            let ray =
                Ray::new(Point::new(-4.0, 0.25, 0.25), Point::new(1.0, zero, zero).to_vector());
            let ray = frame.ray(&ray).expect("it meets the frame");
            let whole = Aabb { min: Point::new(-0.5, -0.5, -0.5), max: Point::new(0.5, 0.5, 0.5) };
            for axis in [1, 2] {
                let beside = |slacks: f64| ray.origin[axis] + slacks * ray.slack(&whole);
                for (slacks, inside) in [(1.0, true), (2.0, false)] {
                    let above = Aabb { min: whole.min.with(axis, beside(slacks)), ..whole };
                    let below = Aabb { max: whole.max.with(axis, beside(-slacks)), ..whole };
                    for bounds in [above, below] {
                        let (near, far) = ray.crossing(&bounds);
                        assert_eq!(near <= far, inside, "{near} {far} {bounds:?}");
                    }
                }
            }
        }
    }
}
