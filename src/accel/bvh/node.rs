//! A node: the boxes of eight children, tested at once.
//!
//! The boxes are in single precision, larger on all sides by [`PAD`] than the boxes of the frame.
//! With that, and with the far part of the slack taken four times, an interval computed here
//! contains the one that [`FrameRay::crossing`] computes in `f64`, and no more has to be shown (see
//! `accel/frame.rs`). The roundings, as the distance in space by which each can move a plane, for
//! an origin within [`NEAR`](crate::accel::frame::NEAR) = 4 and planes within 1 of the middle
//! (u = 2⁻²⁴):
//! - of the origin: 4 u;
//! - of 1/d, relatively 1 u, on a distance of at most 5: 5 u;
//! - of the difference to the plane: 5 u; or of the product with the origin, if that is taken off
//!   by a fused operation: 4 u;
//! - of the result: 5 u.
//!
//! Together 19 u, less than the 28 u of [`PAD`] that the 2⁻²³ of a side of at most 2 leave. An origin
//! is farther out than 4 only if the ray comes from beyond 2²⁴ sizes, and then the second half of
//! its far slack is larger than what its roundings add: 2⁻²⁴ of 2⁻²⁵ of the distance. 1/d is at most
//! 10¹⁸, and the largest component of d at least 2⁻³⁰: that leaves any plane that is not within 2⁻²⁴
//! of the origin beyond the frame.
//!
//! In the frame of a part of the boxes ([`Frame::of_part`](crate::accel::frame::Frame::of_part))
//! all numbers are those of another `f64` computation. The distance that the ray comes from is
//! measured to another middle, which changes the far slack by less than half; and the planes are
//! moved by some roundings of that distance, of which the far slack has 2¹⁷. Therefore it is taken
//! four times rather than twice.

use super::build::Box32;
use crate::accel::frame::FrameRay;
use crate::accel::kernel::{Instructions, Kernel};
use crate::math::{Aabb, Span};

/// Children of a node, and primitives of a leaf at most.
pub const WIDTH: usize = 8;
/// The bit that tells a leaf among children; the others are its number.
pub const LEAF: u32 = 1 << 31;
/// The bits that tell a part with a frame of its own; the others are its number.
pub const PART: u32 = LEAF | 1 << 30;
/// How much the boxes are larger.
const PAD: f64 = 1.0 / (1 << 19) as f64;

/// Four cache lines.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(64))]
pub struct Node {
    /// The lower and the upper bounds along x, then along y, then along z.
    bounds: [[f32; WIDTH]; 6],
    /// Where each child is: a node, or with the bit [`LEAF`] a leaf, or with [`PART`] a part.
    pub children: [u32; WIDTH],
}

/// A ray as single precision sees it.
#[derive(Clone, Copy, Debug)]
pub struct Ray32 {
    inverse: [f32; 3],
    /// The origin, moved by the slack, for the planes where the ray enters and those where it leaves.
    enters: [f32; 3],
    leaves: [f32; 3],
    /// Which of a node's bounds are those where the ray enters.
    sides: [usize; 3],
    /// Hits before it do not count; never below +0.
    first: f32,
}

/// Which boxes the ray crosses, as a mask, and where it enters each.
pub type Crossed = (u32, [f32; WIDTH]);

impl Box32 {
    /// A box of the frame, padded and rounded outward.
    pub fn padded(bounds: &Aabb) -> Self {
        let low = bounds.min.to_array().map(|x| ((x - PAD) as f32).next_down());
        let high = bounds.max.to_array().map(|x| ((x + PAD) as f32).next_up());
        Self { min: low, max: high }
    }
}

/// Of a number that is not negative, one that is not above it: the factor takes off a unit in the last
/// place at least, and rounding to single precision has added half of one at most. (Less than
/// 10⁻³⁸ it may be above by 10⁻⁴⁵, which is nothing beside [`PAD`].)
#[inline(always)]
fn rounded_down(x: f64) -> f32 {
    (1.0 - f32::EPSILON) * x as f32
}

/// The same, and not below it.
#[inline(always)]
pub fn rounded_up(x: f64) -> f32 {
    (1.0 + f32::EPSILON) * x as f32
}

impl Ray32 {
    #[inline]
    pub fn new(ray: &FrameRay, span: Span) -> Self {
        let (origin, inverse, slack) = ray.single();
        let ahead = inverse.map(|i| slack.copysign(i));
        Self {
            inverse: inverse.map(|i| i.clamp(-1e18, 1e18) as f32),
            enters: [0, 1, 2].map(|i| (origin[i] + ahead[i]) as f32),
            leaves: [0, 1, 2].map(|i| (origin[i] - ahead[i]) as f32),
            sides: inverse.map(|i| usize::from(i.is_sign_negative())),
            first: rounded_down(ray.first(span)) + 0.0, // not −0
        }
    }
}

impl Node {
    /// Boxes that no ray crosses: their bounds are at infinity.
    pub const EMPTY: Self = Self {
        bounds: {
            let (low, high) = ([f32::INFINITY; WIDTH], [f32::NEG_INFINITY; WIDTH]);
            [low, high, low, high, low, high]
        },
        children: [LEAF; WIDTH],
    };

    pub fn set(&mut self, slot: usize, bounds: &Box32, child: u32) {
        for axis in 0..3 {
            self.bounds[2 * axis][slot] = bounds.min[axis];
            self.bounds[2 * axis + 1][slot] = bounds.max[axis];
        }
        self.children[slot] = child;
    }

    /// The children that the ray crosses between its start and `last`.
    #[inline(always)]
    #[allow(unsafe_code, reason = "calls what not every processor can run")]
    pub fn crossed(&self, kernel: Kernel, ray: &Ray32, last: f32) -> Crossed {
        match kernel.instructions() {
            Instructions::Plain => self.crossed_plain(ray, last),
            // SAFETY: a kernel is made only where the processor has its instructions
            #[cfg(target_arch = "x86_64")]
            Instructions::Avx2 | Instructions::Avx512 => unsafe { self.crossed_avx2(ray, last) },
        }
    }

    fn crossed_plain(&self, ray: &Ray32, last: f32) -> Crossed {
        let (mut near, mut far) = ([ray.first; WIDTH], [last; WIDTH]);
        for axis in 0..3 {
            let side = ray.sides[axis];
            let (enter, leave) = (&self.bounds[2 * axis + side], &self.bounds[2 * axis + 1 - side]);
            for i in 0..WIDTH {
                let enter = (enter[i] - ray.enters[axis]) * ray.inverse[axis];
                let leave = (leave[i] - ray.leaves[axis]) * ray.inverse[axis];
                near[i] = if enter > near[i] { enter } else { near[i] };
                far[i] = if leave < far[i] { leave } else { far[i] };
            }
        }
        let mask = (0..WIDTH).fold(0, |mask, i| mask | u32::from(near[i] <= far[i]) << i);
        (mask, near)
    }
    /// The same, but that the difference to a plane is fused with its multiplication.
    ///
    /// # Safety
    /// The processor has AVX2 and FMA. (They are no attribute of this function, because it could
    /// not always be inlined then; closures would have the same fault.)
    #[cfg(target_arch = "x86_64")]
    #[inline(always)]
    #[allow(unsafe_code, reason = "instructions that not every processor has")]
    unsafe fn crossed_avx2(&self, ray: &Ray32, last: f32) -> Crossed {
        use std::arch::x86_64::*;
        let first = ray.first;
        // SAFETY: the caller's; and loads and stores are of eight numbers
        unsafe {
            macro_rules! distance {
                ($axis:literal, $side:expr, $origins:expr) => {{
                    let plane = _mm256_loadu_ps(self.bounds[2 * $axis + ($side & 1)].as_ptr());
                    let origin = _mm256_set1_ps(ray.inverse[$axis] * $origins[$axis]);
                    _mm256_fmsub_ps(plane, _mm256_set1_ps(ray.inverse[$axis]), origin)
                }};
            }
            macro_rules! enter {
                ($axis:literal) => {
                    distance!($axis, ray.sides[$axis], ray.enters)
                };
            }
            macro_rules! leave {
                ($axis:literal) => {
                    distance!($axis, 1 - (ray.sides[$axis] & 1), ray.leaves)
                };
            }
            // of two zeros the second is taken: the start, which is +0 and not −0
            let near = _mm256_max_ps(enter!(2), _mm256_set1_ps(first));
            let near = _mm256_max_ps(_mm256_max_ps(enter!(0), enter!(1)), near);
            let far = _mm256_min_ps(leave!(2), _mm256_set1_ps(last));
            let far = _mm256_min_ps(_mm256_min_ps(leave!(0), leave!(1)), far);
            let mask = _mm256_movemask_ps(_mm256_cmp_ps::<_CMP_LE_OQ>(near, far)) as u32;
            let mut entries = [0.0; WIDTH];
            _mm256_storeu_ps(entries.as_mut_ptr(), near);
            (mask, entries)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::accel::frame::Frame;
    use crate::math::{Pcg32, Point, Ray, Vector, power};

    /// Rays at the corners, edges and faces of boxes, from near and far, some with components that
    /// are zero or almost.
    fn ray(random: &mut Pcg32, within: &Aabb) -> Ray {
        let mut x = || 2.0 * random.uniform() - 1.0;
        let mut place = |low: f64, high: f64| match (4.0 * x()) as i32 {
            -3..=-2 => low,
            2..=3 => high,
            _ => low + (0.5 + 0.5 * x()) * (high - low),
        };
        let (min, max) = (within.min.to_array(), within.max.to_array());
        let target = Point::from([0, 1, 2].map(|i| place(min[i], max[i])));
        let mut direction = [0, 1, 2].map(|_| x());
        let small = [0.0, -0.0, 1e-6, -1e-12, 1e-20, 1e-300];
        for d in &mut direction {
            if random.below(4) == 0 {
                *d = small[random.below(6) as usize];
            }
        }
        if direction.iter().all(|d| d.abs() < 1e-3) {
            direction[random.below(3) as usize] = 1.0;
        }
        let direction = Vector::from(direction);
        Ray::new(target - power(10.0, 14.0 * random.uniform() - 1.0) * direction, direction)
    }

    /// Law: rounded down and up, numbers enclose what they were, within three parts in 10⁷. Oracle: the
    /// comparison in double precision, in which single precision is exact.
    #[test]
    fn rounding_encloses() {
        let mut random = Pcg32::new(2281, 0);
        let some = (0..100_000).map(|_| power(10.0, 60.0 * random.uniform() - 30.0));
        let halfway = (0..1000).map(|i| 1.0 + (f64::from(i) + 0.5) / f64::from(1 << 23));
        for x in some.chain(halfway).chain([1.0, 2.0, 1.0_f64.next_down(), 1.0_f64.next_up()]) {
            let (low, high) = (f64::from(rounded_down(x)), f64::from(rounded_up(x)));
            assert!(low <= x && x <= high, "{x:e} in {low:e} to {high:e}");
            assert!(low >= x * (1.0 - 2.5e-7) && high <= x * (1.0 + 2.5e-7), "{x:e}");
        }
        assert_eq!([rounded_down(0.0), rounded_up(f64::INFINITY)], [0.0, f32::INFINITY]);
    }

    /// Law: wherever a ray crosses a box in the frame, each kernel has it cross the node's box, at
    /// an interval that contains the other. Oracle: the same in `f64`.
    #[test]
    fn a_node_contains_what_the_frame_has_inside_it() {
        let mut random = Pcg32::new(2280, 0);
        let mut crossed = [0; 4];
        for case in 0..40_000 {
            let mut x = || 2.0 * random.uniform() - 1.0;
            let corner = |x: &mut dyn FnMut() -> f64| Point::new(x(), x(), x());
            let whole = Aabb::around([Point::new(-1.0, -1.0, -1.0), Point::new(1.0, 1.0, 1.0)]);
            let p = corner(&mut x);
            let size = [0.0, 1e-9, 1e-3, 0.3][case % 4];
            let bounds = Aabb::around([p, p + size * corner(&mut x).to_vector()]);
            let frame = Frame::around(&[whole, bounds]);
            let target = if case % 3 == 0 { whole } else { bounds };
            let ray = ray(&mut random, &target);
            let (framed, span) = match case % 2 {
                0 => (frame.ray_from_afar(&ray), Span::LINE),
                _ => (frame.ray_from_near(&ray), Span::AHEAD),
            };
            let Some(ray) = framed else { continue };
            let boxed = frame.boxed(&bounds);
            let mut node = Node::EMPTY;
            node.set(3, &Box32::padded(&boxed), 7);
            let (near, far) = ray.crossing(&boxed);
            let near = near.max(0.0); // where what is wanted begins
            crossed[2 * (case % 2) + usize::from(near <= far)] += 1;
            let ray32 = Ray32::new(&ray, span);
            for kernel in Kernel::available() {
                let (mask, entries) = node.crossed(kernel, &ray32, f32::INFINITY);
                assert_eq!(mask & !(1 << 3), 0, "an empty place is crossed by {ray:?}");
                if near <= far {
                    assert_eq!(mask, 1 << 3, "{kernel:?}: {ray:?} misses {boxed:?}");
                    assert!(f64::from(entries[3]) <= near, "{kernel:?}: {ray:?}, {boxed:?}");
                    // seen to the end, and not beyond by much
                    let seen = |last: f64| node.crossed(kernel, &ray32, last as f32).0 != 0;
                    assert!(seen(near.next_up() * (1.0 + 1e-6)), "{kernel:?}: {ray:?}, {boxed:?}");
                    let late = Ray32 { first: (far as f32).next_down().max(0.0), ..ray32 };
                    let (mask, _) = node.crossed(kernel, &late, f32::INFINITY);
                    assert_eq!(mask, 1 << 3, "{kernel:?}: left too early by {ray:?}, {boxed:?}");
                }
            }
        }
        assert!(crossed.iter().all(|&n| n > 1_000), "{crossed:?}");
    }
}
