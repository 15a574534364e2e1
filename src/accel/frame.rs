//! The frame in which boxes and rays are compared, by every method alike; and the counting rule.
//!
//! The frame's origin is the middle of all (bounded) boxes, and its unit a power of two such that
//! their coordinates lie in [−1, 1]. A ray from nearby ([`NEAR`]) is only moved and scaled with them.
//! The origin of any other moves along it, to where its longest component is 2 before the middle: of
//! those that meet the frame's own box none starts farther than 4 from the middle then (the others end
//! here). A direction that is very long or short is multiplied by a power of two. So no number is
//! large, wherever the ray comes from.
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
//! operations, before a hit counts, or know that it would say yes (`shapes/meshes/triangle_block.rs`). A
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
/// What moves starts so far before the middle.
const BEFORE: f64 = 2.0;
/// From where the slack would be larger than any frame, a ray is taken to cross all boxes.
const MOST_SLACK: f64 = 1024.0;
/// Frames with units in this range can do with the numbers of `f64`.
const UNITS: std::ops::Range<f64> = 1e-100..1e100;
/// Directions whose largest component is of such a size are used as they are.
const ORDINARY: std::ops::Range<f64> = 1e-9..1e9;
/// A frame is not smaller than this part of the coordinates in it: what is has few digits of its own.
const LEAST_SIZE: f64 = 1.0 / (1 << 30) as f64;

/// Where a set of boxes lies, and how large it is.
#[derive(Clone, Copy, Debug)]
pub struct Frame {
    middle: Point,
    /// Units of the frame in one unit of the world.
    scale: f64,
    /// The size of the frame of all boxes, or the largest coordinate in the world if that is more,
    /// in units of this frame: at least [`NEAR`], and infinite where numbers are extreme.
    reach: f64,
    /// Origins with coordinates up to this stay where they are: [`NEAR`], or none at all where numbers
    /// are extreme.
    near: f64,
}

/// A ray in a frame. What it meets at `t` is at `origin + (unit·t − start) · direction`.
#[derive(Clone, Copy, Debug)]
pub struct FrameRay {
    pub(super) origin: Vector,
    pub(super) direction: Vector,
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
        let has_numbers = UNITS.contains(&scale) && FAR_SLACK * reach <= MOST_SLACK;
        let (reach, near) = if has_numbers { (reach, NEAR) } else { (f64::INFINITY, -1.0) };
        Self { middle, scale, reach, near }
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
        self.any(ray, self.near)
    }

    /// The same with an origin that has no box behind it.
    pub fn line(&self, ray: &Ray) -> Option<FrameRay> {
        self.any(ray, -1.0)
    }

    /// What [`Frame::ray`] is for nearly all rays; `None` for those with unusual numbers too.
    #[inline(always)] // a call would hand it over in memory, which stalls
    pub fn ordinary_ray(&self, ray: &Ray) -> Option<FrameRay> {
        if !ORDINARY.contains(&ray.direction.max_abs()) {
            return None;
        }
        self.entered(self.off_middle(ray.origin), ray.direction, self.scale, self.near)
    }

    fn any(&self, ray: &Ray, near: f64) -> Option<FrameRay> {
        let longest = ray.direction.max_abs();
        let power = match ORDINARY.contains(&longest) {
            true => 0,
            false => exponent(longest).clamp(-1022, 1022),
        };
        let (unit, origin) = (self.scale * power_of_two(power), self.off_middle(ray.origin));
        let has_numbers = UNITS.contains(&unit) && power.abs() < 1022;
        if !(has_numbers && self.far_slack(origin) <= MOST_SLACK) {
            return Some(FrameRay::EVERYWHERE);
        }
        self.entered(origin, power_of_two(-power) * ray.direction, unit, near)
    }

    /// From an origin and a direction in the frame, the first moved unless it is as near as this.
    #[inline(always)]
    fn entered(
        &self,
        mut origin: Vector,
        direction: Vector,
        unit: f64,
        near: f64,
    ) -> Option<FrameRay> {
        let (mut start, mut far_slack) = (0.0, FAR_SLACK * self.reach);
        if origin.max_abs() > near {
            far_slack = self.far_slack(origin);
            let axis = direction.dominant_axis();
            let (x, d) = (origin.along(axis), direction.along(axis));
            start = -(x + BEFORE.copysign(d)) / d;
            origin += start * direction;
            // as far as it comes if it meets the frame's box, grown by all slack
            let farthest = 4.25 + 4.0 * far_slack;
            if !(far_slack <= MOST_SLACK && origin.max_abs() <= farthest) {
                return None;
            }
        }
        Some(FrameRay { origin, direction, unit, start, far_slack })
    }

    /// How much a box that has no sides is grown for rays from there.
    fn far_slack(&self, origin: Vector) -> f64 {
        FAR_SLACK * self.reach.max(origin.max_abs())
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
    /// For rays from too far away, or too long or short to have numbers in the frame: crosses every
    /// box, and every hit of it is at 0.
    const EVERYWHERE: Self = Self {
        origin: Vector::ZERO,
        direction: Vector::new(1.0, 1.0, 1.0),
        unit: 0.0,
        start: 0.0,
        far_slack: 1e30,
    };

    /// The distance from the ray's origin in the frame, of what is at `t`; monotone in `t`.
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

    /// One over the direction; a zero component gives an infinity of its sign.
    #[inline]
    pub fn inverse(&self) -> [f64; 3] {
        self.direction.to_array().map(|d| 1.0 / d)
    }

    /// The slack as nodes in single precision take it: only the far part, four times
    /// (`accel/bvh/node.rs`).
    #[inline(always)]
    pub fn slack_of_nodes(&self) -> f64 {
        4.0 * self.far_slack
    }

    /// Where the span begins, or the ray.
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
        let (slack, inverse) = (self.slack(bounds), self.inverse());
        let mut interval = (f64::NEG_INFINITY, f64::INFINITY);
        for (i, inverse) in inverse.into_iter().enumerate() {
            let planes = [bounds.min.along(i) - slack, bounds.max.along(i) + slack];
            let backward = usize::from(inverse.is_sign_negative());
            let (near, far) = (planes[backward], planes[1 - backward]);
            interval = narrowed(interval, near, far, self.origin.along(i), inverse);
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
    use crate::math::{Pcg32, power};

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
                let beside = |slacks: f64| ray.origin.along(axis) + slacks * ray.slack(&whole);
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

    /// A box of some size, somewhere.
    fn somewhere(random: &mut Pcg32) -> Aabb {
        let mut x = || 2.0 * random.uniform() - 1.0;
        let size = power(10.0, 30.0 * x());
        let middle = size * (3.0 * Vector::new(x(), x(), x()));
        let half = size * Vector::new(0.1 + x().abs(), 0.1 + x().abs(), 0.1 + x().abs());
        Aabb { min: Point::ORIGIN + (middle - half), max: Point::ORIGIN + (middle + half) }
    }

    /// Law: a ray to a point of the box, from near or far, starts near the frame's middle and keeps the
    /// point where it is, at its `t`; nothing of the box is behind its line's start; one that passes
    /// the box by a distance from afar is none, or crosses nothing. Oracle: the point itself.
    #[test]
    fn a_ray_enters_with_all_that_it_meets() {
        let mut random = Pcg32::new(2210, 0);
        let [mut stayed, mut moved] = [0; 2];
        for case in 0..30_000 {
            let bounds = somewhere(&mut random);
            let frame = Frame::around(&[bounds]);
            let extent = bounds.max - bounds.min;
            let mut x = || 2.0 * random.uniform() - 1.0;
            let place = Vector::new(x() * extent.x(), x() * extent.y(), x() * extent.z());
            let target = bounds.min + 0.5 * (extent + place);
            let away = power(10.0, 6.0 * x()) * extent.max_abs();
            let thin = [1.0, 1e-3, 1e-12, 0.0][case % 4];
            let way =
                Vector::from([[x(), thin, x()], [x(), x(), thin], [thin, x(), x()]][case % 3]);
            let t = power(10.0, 20.0 * x());
            let ray = Ray::new(target - away * way, (away / t) * way);
            let at = frame.boxed(&Aabb { min: target, max: target }).min.to_vector();
            let framed = frame.ray(&ray).expect("it meets the box");
            let line = frame.line(&ray).expect("it meets the box");
            *[&mut stayed, &mut moved][usize::from(framed.start != 0.0)] += 1;
            for seen in [framed, line] {
                assert!(seen.origin.max_abs() <= 4.0 + 1e-6, "{seen:?}");
                let there = seen.origin + seen.moved(t) * seen.direction;
                let distance = frame.off_middle(ray.origin).max_abs().max(4.0);
                let off = (there - at).max_abs();
                assert!(off <= 64.0 * f64::EPSILON * distance, "{off:e}: {ray:?} {seen:?}");
                assert!(seen.counts(&frame.boxed(&bounds), t), "{seen:?}");
            }
            assert!(line.crossing(&frame.boxed(&bounds)).0 >= 0.0, "{line:?}");
            let side = (8.0 * extent.max_abs()) * Vector::new(x().signum(), x().signum(), 0.0);
            let beside = Ray::new(ray.origin + side, ray.direction);
            let across = (side - (side.dot(way) / way.dot(way)) * way).max_abs();
            if across > 4.0 * extent.max_abs() {
                let seen = [frame.ray(&beside), frame.line(&beside)];
                let crosses = |seen: FrameRay| {
                    let (near, far) = seen.crossing(&frame.boxed(&bounds));
                    near <= far
                };
                assert_eq!(seen.map(|seen| seen.is_some_and(crosses)), [false; 2], "{beside:?}");
            }
        }
        assert!(stayed > 5_000 && moved > 5_000, "{stayed} {moved}");
    }

    /// Law: the quick way is the usual one, bit for bit; unusual rays have no quick way, and one
    /// without numbers in the frame crosses every box. Oracle: the two ways, and the law's own words.
    #[test]
    fn the_quick_way_is_the_usual_one() {
        let mut random = Pcg32::new(2211, 0);
        let mut quick = 0;
        for _ in 0..10_000 {
            let frame = Frame::around(&[somewhere(&mut random)]);
            let mut x = || 2.0 * random.uniform() - 1.0;
            let origin = power(10.0, 40.0 * x()) * Vector::new(x(), x(), x());
            let long = power(10.0, [12.0, 300.0][usize::from(x() > 0.5)] * x());
            let ray = Ray::new(Point::ORIGIN + origin, long * Vector::new(x(), x(), x()));
            let usual = frame.ray(&ray);
            if let Some(ordinary) = frame.ordinary_ray(&ray) {
                quick += 1;
                assert_eq!(format!("{:?}", Some(ordinary)), format!("{usual:?}"));
            } else if let Some(unusual) = usual {
                let is_ordinary = ORDINARY.contains(&ray.direction.max_abs());
                assert!(!is_ordinary || unusual.far_slack > MOST_SLACK, "{unusual:?}");
            }
        }
        assert!(quick > 1_000, "{quick}");
        let frame = Frame::around(&[Aabb::around([Point::ORIGIN, Point::new(1.0, 1.0, 1.0)])]);
        let tiny = Aabb::around([Point::new(0.25, 0.25, 0.25)]);
        for (origin, direction) in [(1e30, 1.0), (0.5, 1e200), (0.5, 1e-310), (1e300, 1e300)] {
            let ray = Ray::new(Point::new(origin, 0.0, 0.0), Vector::new(0.0, direction, 0.0));
            let seen = frame.ray(&ray).expect("it crosses all");
            assert!(seen.counts(&frame.boxed(&tiny), 17.0), "{seen:?}");
        }
    }
}
