//! Axis-aligned boxes.

use super::box_ray::BoxRay;
use super::ray::Ray;
use super::vectors::{Point, Vector};

/// A box with faces along the axes; empty if `min > max`, unbounded if a coordinate is infinite.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Aabb {
    /// The corner with the smallest coordinates.
    pub min: Point,
    /// The corner with the largest coordinates.
    pub max: Point,
}

/// The padding of a box relative to its largest coordinate: far more than the rounding of its
/// corners and of a hit point.
const SLACK: f64 = 1.0 / (1 << 30) as f64;

impl Aabb {
    /// Contains nothing; the start of a union.
    pub const EMPTY: Self = Self {
        min: Point::new(f64::INFINITY, f64::INFINITY, f64::INFINITY),
        max: Point::new(f64::NEG_INFINITY, f64::NEG_INFINITY, f64::NEG_INFINITY),
    };
    /// Contains everything: the bounds of infinite shapes.
    pub const EVERYTHING: Self = Self { min: Self::EMPTY.max, max: Self::EMPTY.min };

    /// The smallest box around these points.
    pub fn around(points: impl IntoIterator<Item = Point>) -> Self {
        points.into_iter().fold(Self::EMPTY, |b, p| Self { min: b.min.min(p), max: b.max.max(p) })
    }

    /// The smallest box around both boxes.
    pub fn union(self, other: Self) -> Self {
        Self { min: self.min.min(other.min), max: self.max.max(other.max) }
    }

    /// Whether no coordinate is infinite or NaN.
    pub fn is_bounded(&self) -> bool {
        self.min.is_finite() && self.max.is_finite()
    }

    /// Whether the point is inside or on the surface.
    pub fn contains(&self, p: Point) -> bool {
        (0..3).all(|i| self.min.along(i) <= p.along(i) && p.along(i) <= self.max.along(i))
    }

    /// Whether the ray may meet the box at `t ≥ start`, which may be −∞. Conservative: also true if
    /// the ray misses by a few roundings (see [`BoxRay`]).
    pub fn may_meet(&self, ray: &Ray, start: f64) -> bool {
        let box_ray = BoxRay::new(ray, self.largest_coordinate());
        let (enter, leave) = box_ray.crossing(self, start, f64::INFINITY);
        enter <= leave && self.min.x() <= self.max.x()
    }

    /// The largest size of a coordinate.
    pub fn largest_coordinate(&self) -> f64 {
        self.min.to_vector().max_abs().max(self.max.to_vector().max_abs())
    }

    /// The diagonal `max − min`.
    pub fn extent(&self) -> Vector {
        self.max - self.min
    }

    /// The centre.
    pub fn center(&self) -> Point {
        self.min + 0.5 * self.extent()
    }

    /// Half the surface area, which is what a surface-area heuristic compares.
    pub fn half_area(&self) -> f64 {
        let [x, y, z] = self.extent().to_array();
        x * y + y * z + z * x
    }

    /// The eight corners.
    pub fn corners(&self) -> [Point; 8] {
        let ends = [self.min, self.max];
        std::array::from_fn(|i| Point::new(ends[i & 1].x(), ends[i >> 1 & 1].y(), ends[i >> 2].z()))
    }

    /// The box grown by 2⁻³⁰ of its largest coordinate: far more than rounding of its corners can
    /// move a hit.
    pub fn padded(self) -> Self {
        let largest = self.largest_coordinate();
        if !largest.is_finite() {
            return self;
        }
        let pad = SLACK * largest * Vector::new(1.0, 1.0, 1.0);
        Self { min: self.min - pad, max: self.max + pad }
    }
}
