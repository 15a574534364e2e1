//! The cut face (Suffern, ch. 19), a square with a round hole: the points of the plane y = 0 with
//! `|x|, |z| ≤ size/2` and `x² + z² ≥ radius²`.
//!
//! A ray meets the plane at `t = −o_y/d_y`, and then the point is tested, as in the book.

use crate::invalid::{Invalid, shown};
use crate::math::{Aabb, Length, Normal, Point, Vector};
use crate::shapes::border::along;
use crate::shapes::plain::plane::PlaneThrough;
use crate::shapes::trimmed::{Trim, Trimmed};
use crate::shapes::{Context, Made, Specification, made};

/// The points of the plane y = 0 with `|x|, |z| ≤ size/2` and `x² + z² ≥ radius²`; the normal is
/// (0, 1, 0).
#[kind(PartialEq)]
pub struct CutFace {
    /// The side of the square; positive.
    pub size: Length,
    /// The radius of the hole: positive, and less than from the middle to a corner. Where it is
    /// more than half of `size`, four corners are left.
    pub radius: Length,
}

impl Specification for CutFace {
    fn make(&self, _: &mut Context) -> Made {
        let Self { size, radius } = *self;
        let to_corner = size * std::f64::consts::FRAC_1_SQRT_2;
        if radius >= to_corner {
            let (radius, size, most) = (shown(radius), shown(size), shown(to_corner));
            let problem = format!(
                "found {radius}, but it must be less than {most}: nothing is left of size {size}"
            );
            return Err(Invalid::field("radius", problem));
        }
        let half = 0.5 * size;
        let bounds = Aabb { min: Point::new(-half, 0.0, -half), max: Point::new(half, 0.0, half) };
        let plane = PlaneThrough::new(Point::ORIGIN, Normal::Y);
        made(Trimmed::new(plane, (Square { half }, Hole { radius }), size, bounds))
    }
}

/// The points with `|x|, |z| ≤ size/2`.
#[derive(Clone, Debug)]
struct Square {
    half: f64,
}

impl Trim for Square {
    /// From the nearer sides.
    #[inline]
    fn distances(&self, v: Vector) -> [f64; 2] {
        [self.half - v.x().abs(), self.half - v.z().abs()]
    }

    fn away(&self, v: Vector) -> [Vector; 2] {
        let to_middle = |x: f64| -1.0_f64.copysign(x);
        [to_middle(v.x()) * Vector::X, to_middle(v.z()) * Vector::Z]
    }
}

/// The points with `x² + z² ≥ radius²`.
#[derive(Clone, Debug)]
struct Hole {
    radius: f64,
}

impl Trim for Hole {
    #[inline]
    fn has(&self, v: Vector) -> bool {
        v.x() * v.x() + v.z() * v.z() >= self.radius * self.radius
    }

    #[inline]
    fn distances(&self, v: Vector) -> [f64; 2] {
        [v.length() - self.radius, f64::INFINITY]
    }

    fn away(&self, v: Vector) -> [Vector; 2] {
        [along(v), Vector::ZERO]
    }
}
