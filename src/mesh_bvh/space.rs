//! The normalised space of a tree: its boxes lie in [−1, 1], so that single precision is enough for
//! them.
//!
//! The origin is the centre of all boxes, and the unit is a power of two. A ray from nearby
//! (`NEAR`) is translated and scaled like the boxes. A ray from elsewhere also starts later:
//! where its longest component is 2 before the centre. If it meets the boxes, it then starts at
//! most 4 from the centre.
//!
//! Boxes are grown by a *slack* that covers the rounding of ray and hit: a fraction of the distance
//! from which the ray comes. A ray that cannot be represented (from too far away, or with a
//! direction that is far too long or short) crosses every box.

use crate::math::{Aabb, Point, Ray, Span, Vector, power_of_two};

/// The slack, for each unit of distance: 2¹⁷ roundings.
const SLACK: f64 = 1.0 / (1_u64 << 36) as f64;
/// Origins with coordinates up to this are not moved: two scenes away.
const NEAR: f64 = 4.0;
/// A moved origin is this far before the centre.
const BEFORE: f64 = 2.0;
/// The largest slack: with a larger one a ray crosses every box.
const MAX_SLACK: f64 = 0.25;
/// Directions whose largest component is in this range are not scaled.
const ORDINARY: std::ops::Range<f64> = 1e-9..1e9;
/// Scales for which no number overflows or underflows.
const SCALES: std::ops::Range<f64> = 1e-100..1e100;
/// The least size of the space, relative to the largest coordinate.
const MIN_SIZE: f64 = 1.0 / (1 << 30) as f64;

/// The map from the world to the normalised space.
#[derive(Clone, Copy, Debug)]
pub struct Space {
    center: Point,
    /// Units of this space in one unit of the world.
    scale: f64,
    /// The coordinate extent: the largest coordinate in the world, in units of the space, but at
    /// least `NEAR`.
    extent: f64,
}

/// A ray in the space. The point at `t` is `origin + (unit·t − start) · direction`.
#[derive(Clone, Copy, Debug)]
pub struct SpaceRay {
    pub origin: Vector,
    pub direction: Vector,
    /// The amount by which boxes are grown.
    pub slack: f64,
    unit: f64,
    pub start: f64,
}

impl Space {
    /// The space of boxes inside `whole`, which is bounded.
    pub fn around(whole: &Aabb) -> Self {
        let (min, max) = (0.5 * whole.min.to_vector(), 0.5 * whole.max.to_vector()); // no overflow
        let largest = whole.largest_coordinate();
        let size = (max - min).max_abs().max(MIN_SIZE * largest);
        // the power of two above the size, unless its reciprocal would overflow
        let scale = 0.25 * power_of_two(1 - exponent(size).max(-1000));
        Self { center: Point::ORIGIN + (min + max), scale, extent: (scale * largest).max(NEAR) }
    }

    /// A box of the world in this space.
    pub fn boxed(&self, bounds: &Aabb) -> Aabb {
        let point = |p| Point::ORIGIN + self.offset_from_center(p);
        Aabb { min: point(bounds.min), max: point(bounds.max) }
    }

    #[inline]
    pub fn offset_from_center(&self, p: Point) -> Vector {
        self.scale * (p - self.center)
    }

    /// The ray in this space, or `None` if it passes beside all boxes. If the span begins before
    /// the ray's origin, the ray starts before all boxes.
    #[inline(always)] // a call would return it in memory, just before it is read
    pub fn ray(&self, ray: &Ray, span: Span) -> Option<SpaceRay> {
        let direction = ray.direction;
        let (mut origin, mut start) = (self.offset_from_center(ray.origin), 0.0);
        let slack = SLACK * self.extent.max(origin.max_abs());
        let ordinary = ORDINARY.contains(&direction.max_abs()) && SCALES.contains(&self.scale);
        if !(ordinary && slack <= MAX_SLACK) {
            return Some(SpaceRay::EVERYWHERE);
        }
        if origin.max_abs() > NEAR || span.min < 0.0 {
            let axis = direction.dominant_axis();
            let (x, d) = (origin.along(axis), direction.along(axis));
            start = -(x + BEFORE.copysign(d)) / d;
            origin += start * direction;
            // the farthest start of a ray that meets the boxes, grown by the slack
            if origin.max_abs() > 4.25 + 4.0 * slack {
                return None;
            }
        }
        Some(SpaceRay { origin, direction, slack, unit: self.scale, start })
    }
}

impl SpaceRay {
    /// A ray that crosses every box, and has every hit at 0.
    const EVERYWHERE: Self = Self {
        origin: Vector::ZERO,
        direction: Vector::new(1.0, 1.0, 1.0),
        slack: 1e30,
        unit: 0.0,
        start: 0.0,
    };

    /// Where the span begins in this space, or the ray if that is later.
    #[inline]
    pub fn first(&self, span: Span) -> f64 {
        self.at(span.min).max(0.0) // `max` turns NaN into 0
    }

    /// The end of the search in this space, for a search that ends at `t`.
    #[inline]
    pub fn last(&self, t: f64) -> f64 {
        self.at(t).min(f64::INFINITY) // `min` turns NaN into ∞
    }

    /// The distance in this space from the ray's origin to the point at `t`; monotone in `t`.
    #[inline]
    pub fn at(&self, t: f64) -> f64 {
        self.unit * t - self.start
    }
}

/// `e` with `2^e ≤ x < 2^(e + 1)`, for a positive normal number; −1023 for 0 and subnormal numbers,
/// 1024 for ∞ and NaN.
#[inline]
fn exponent(x: f64) -> i32 {
    ((x.to_bits() >> 52) & 0x7ff) as i32 - 1023
}
