//! Rays, and intervals of their parameter.

use serde::Serialize;

use super::vectors::{Point, Vector};

/// All points `origin + t·direction`. The direction need not be unit; `t` is in units of its
/// length.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Ray {
    /// Where it starts.
    pub origin: Point,
    /// Where it goes; not zero.
    pub direction: Vector,
}

impl Ray {
    /// The ray from a point in a direction.
    pub fn new(origin: Point, direction: Vector) -> Self {
        Self { origin, direction }
    }

    /// The point at `t`.
    pub fn at(&self, t: f64) -> Point {
        self.origin + t * self.direction
    }
}

/// An open interval of `t`: a hit counts if `min < t < max`. Finite `t` only, so a ray in a plane
/// (infinite or NaN `t`) is a miss in every span.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Span {
    /// Hits at or before it do not count.
    pub min: f64,
    /// Hits at or beyond it do not count.
    pub max: f64,
}

impl Span {
    /// Everything in front of the origin.
    pub const AHEAD: Self = Self { min: 0.0, max: f64::INFINITY };
    /// The whole line.
    pub const LINE: Self = Self { min: f64::NEG_INFINITY, max: f64::INFINITY };
    /// The segment from `ray.at(0)` to `ray.at(1)`, without its ends.
    pub const SEGMENT: Self = Self { min: 0.0, max: 1.0 };

    /// Whether `t` lies inside; NaN and infinities never do.
    pub fn contains(self, t: f64) -> bool {
        self.min < t && t < self.max
    }

    /// The same span ending with `t`, `t` itself included.
    pub fn through(self, t: f64) -> Self {
        // faster for the usual case: the bits of the next positive number are the next integer
        let next = if t > 0.0 { f64::from_bits(t.to_bits() + 1) } else { t.next_up() };
        Self { min: self.min, max: self.max.min(next) }
    }
}
