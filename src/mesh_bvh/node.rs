//! A node: the boxes of sixteen children, tested at once.
//!
//! The boxes are in single precision and larger by `PAD` on all sides than those of `space.rs`,
//! so that no rounding here loses a box that the ray crosses. The list gives the distance by which
//! each rounding can move a plane, for an origin within 4.25 of the centre and planes within 1 (u =
//! 2⁻²⁴):
//! - of the origin: 4 u;
//! - of the direction and of its inverse, relatively 1 u each, on a distance of at most 5.25: 11 u;
//! - of the product of inverse and origin, and of its sum with the slack: 4.25 u each;
//! - of the product of inverse and plane, if it is not fused with the sum: 1 u;
//! - of the sum: 5.25 u.
//!
//! Together 30 u, less than `PAD`. The slack adds less than 2⁻²⁰ of itself. Clamping 1/d to 10¹⁸
//! is harmless: the largest component of d is at least 10⁻⁹, so a plane that is not within 2⁻²⁴ of
//! the origin is still met beyond the space.

use super::kernel::{Instructions, Kernel};
use super::lanes32::Lanes;
use super::space::SpaceRay;
use crate::math::{Aabb, Singles, Span};

/// The most children of a node.
pub const WIDTH: usize = 16;
/// The bit that marks a child as a leaf; the other bits are its index.
pub const LEAF: u32 = 1 << 31;
/// The padding of the boxes: 40 u.
const PAD: f64 = 2.5 / (1 << 20) as f64;

/// The boxes and indices of the children: seven cache lines.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(64))]
pub struct Node {
    /// The lower and the upper bounds along x, then along y, then along z.
    bounds: [f32; 6 * WIDTH],
    /// The index of each child: of a node, or of a leaf if the bit [`LEAF`] is set.
    pub children: [u32; WIDTH],
}

/// A ray in single precision. It enters a slab at `inverse · near plane + enters` and leaves it at
/// `inverse · far plane + leaves`.
#[derive(Clone, Copy, Debug)]
pub struct Ray32 {
    inverse: [f32; 3],
    /// Where it meets the plane through the centre, minus and plus the slack.
    enters: [f32; 3],
    leaves: [f32; 3],
    /// Where the near and the far planes begin in a node's bounds.
    rows: &'static Rows,
    /// The start of the search, at least +0.
    pub first: f32,
}

/// See [`Ray32`].
#[derive(Debug)]
struct Rows {
    near: [usize; 3],
    far: [usize; 3],
}

/// Indexed by the signs of a direction's components, as bits.
static ROWS: [Rows; 8] = [
    Rows::of(0b000),
    Rows::of(0b001),
    Rows::of(0b010),
    Rows::of(0b011),
    Rows::of(0b100),
    Rows::of(0b101),
    Rows::of(0b110),
    Rows::of(0b111),
];

impl Rows {
    /// Upper bounds are the near ones where a component is negative.
    const fn of(signs: usize) -> Self {
        let [x, y, z] = [signs & 1, signs >> 1 & 1, signs >> 2];
        Self {
            near: [WIDTH * x, WIDTH * (2 + y), WIDTH * (4 + z)],
            far: [WIDTH * (1 - x), WIDTH * (3 - y), WIDTH * (5 - z)],
        }
    }
}

/// Which boxes the ray crosses, as a mask, and where it enters each.
pub type Crossed = (u32, [f32; WIDTH]);

/// A single-precision number not above `x ≥ 0`: the factor subtracts at least one unit in the last
/// place, and rounding to single precision adds at most half of one. (Below 10⁻³⁸ the result may
/// exceed `x` by 10⁻⁴⁵, which is negligible beside `PAD`.)
#[inline(always)]
pub fn rounded_down(x: f64) -> f32 {
    (1.0 - f32::EPSILON) * x as f32
}

/// A single-precision number not below `x ≥ 0`.
#[inline(always)]
pub fn rounded_up(x: f64) -> f32 {
    (1.0 + f32::EPSILON) * x as f32
}

impl Ray32 {
    #[inline(always)]
    pub fn new(ray: &SpaceRay, span: Span) -> Self {
        let inverse = (Singles::all(1.0) / ray.direction.to_singles()).within(1e18);
        let meets = -inverse * ray.origin.to_singles();
        let slack = inverse.abs() * Singles::all(ray.slack as f32);
        Self {
            inverse: inverse.to_array(),
            enters: (meets - slack).to_array(),
            leaves: (meets + slack).to_array(),
            rows: &ROWS[inverse.signs() % ROWS.len()],
            first: rounded_down(ray.first(span)) + 0.0, // not −0
        }
    }
}

impl Node {
    /// Boxes that no ray crosses: their bounds are at infinity.
    pub const EMPTY: Self = Self {
        bounds: {
            let mut bounds = [f32::INFINITY; 6 * WIDTH];
            let mut i = 0;
            while i < 6 * WIDTH {
                if i / WIDTH % 2 == 1 {
                    bounds[i] = f32::NEG_INFINITY;
                }
                i += 1;
            }
            bounds
        },
        children: [LEAF; WIDTH],
    };

    /// Puts a child with this box of the space into a slot: padded, and rounded outward.
    pub fn set(&mut self, slot: usize, bounds: &Aabb, child: u32) {
        for axis in 0..3 {
            let [min, max] = [bounds.min.along(axis) - PAD, bounds.max.along(axis) + PAD];
            self.bounds[2 * axis * WIDTH + slot] = (min as f32).next_down();
            self.bounds[(2 * axis + 1) * WIDTH + slot] = (max as f32).next_up();
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
            Instructions::Avx2 => unsafe { self.crossed_by::<super::lanes32::Avx2>(ray, last) },
            #[cfg(target_arch = "x86_64")]
            Instructions::Avx512 => unsafe { self.crossed_by::<super::lanes32::Avx512>(ray, last) },
        }
    }

    fn crossed_plain(&self, ray: &Ray32, last: f32) -> Crossed {
        let (mut near, mut far) = ([ray.first; WIDTH], [last; WIDTH]);
        for axis in 0..3 {
            let (inverse, enters, leaves) = (ray.inverse[axis], ray.enters[axis], ray.leaves[axis]);
            let near_planes = &self.bounds[ray.rows.near[axis]..][..WIDTH];
            let far_planes = &self.bounds[ray.rows.far[axis]..][..WIDTH];
            for i in 0..WIDTH {
                let enter = near_planes[i] * inverse + enters;
                let leave = far_planes[i] * inverse + leaves;
                near[i] = if enter > near[i] { enter } else { near[i] };
                far[i] = if leave < far[i] { leave } else { far[i] };
            }
        }
        let mask = (0..WIDTH).fold(0, |mask, i| mask | u32::from(near[i] <= far[i]) << i);
        (mask, near)
    }

    /// The same with fused multiply-add.
    ///
    /// # Safety
    /// The processor has the instructions of `L`. (A `target_feature` attribute here could prevent
    /// inlining; so could a closure.)
    #[inline(always)]
    #[allow(unsafe_code, reason = "instructions that not every processor has")]
    unsafe fn crossed_by<L: Lanes>(&self, ray: &Ray32, last: f32) -> Crossed {
        let (mut mask, mut entries) = (0, [0.0; WIDTH]);
        // SAFETY: the caller guarantees the instructions; every row of bounds and the entries have WIDTH
        // numbers, a multiple of `L::COUNT`
        unsafe {
            macro_rules! meets {
                ($axis:literal, $rows:expr, $terms:expr, $some:expr) => {
                    L::load(self.bounds.as_ptr().add($rows[$axis] + $some))
                        .times_plus(L::all(ray.inverse[$axis]), L::all($terms[$axis]))
                };
            }
            let mut some = 0;
            while some < WIDTH {
                let [x, y, z] = [
                    meets!(0, ray.rows.near, ray.enters, some),
                    meets!(1, ray.rows.near, ray.enters, some),
                    meets!(2, ray.rows.near, ray.enters, some),
                ];
                // of equal numbers `max` returns the second: the start, +0 rather than −0
                let near = x.max(y).max(z.max(L::all(ray.first)));
                let [x, y, z] = [
                    meets!(0, ray.rows.far, ray.leaves, some),
                    meets!(1, ray.rows.far, ray.leaves, some),
                    meets!(2, ray.rows.far, ray.leaves, some),
                ];
                let far = x.min(y).min(z.min(L::all(last)));
                near.store(entries.as_mut_ptr().add(some));
                mask |= near.at_most(far) << some;
                some += L::COUNT;
            }
        }
        (mask, entries)
    }
}
