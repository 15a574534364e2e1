//! The infinite plane (Suffern, ch. 3): the points `p` with `(p − a)·n = 0`.
//!
//! A ray meets it at `t = (a − o)·n / d·n`, as in the book. For a ray parallel to the plane that is
//! infinite or NaN, and no span contains it. The book's own routine takes `n` as the scene gives
//! it.

use crate::invalid::{Invalid, direction};
use crate::math::{Aabb, Normal, Point, Ray, Span, Vector};
use crate::shapes::trimmed::{Carrier, Roots, Trimmed};
use crate::shapes::{Context, Made, Specification, Surface, made};

/// All points `p` with `(p − point)·normal = 0`; the normal need not be unit.
#[kind(PartialEq)]
pub struct Plane {
    /// A point of the plane.
    pub point: Point,
    /// Perpendicular to the plane; not zero, need not be unit.
    pub normal: Vector,
}

/// The plane through a point.
#[derive(Clone, Debug)]
pub struct PlaneThrough {
    pub anchor: Point,
    pub normal: Normal,
    /// As the scene gives it, of any length.
    pub given_normal: Vector,
}

impl Specification for Plane {
    fn make(&self, _: &mut Context) -> Made {
        made(Trimmed::whole(PlaneThrough::checked(self.point, self.normal)?))
    }
}

impl PlaneThrough {
    /// The plane of the fields `anchor` and `normal`.
    pub fn checked(anchor: Point, normal: Vector) -> Result<Self, Invalid> {
        Ok(Self { anchor, normal: direction("normal", normal)?, given_normal: normal })
    }

    pub fn new(anchor: Point, normal: Normal) -> Self {
        Self { anchor, normal, given_normal: normal.into() }
    }

    /// `(a − o)·n / d·n`.
    #[inline]
    fn distance(&self, ray: &Ray, n: Vector) -> f64 {
        (self.anchor - ray.origin).dot(n) / ray.direction.dot(n)
    }

    /// The box around the disk of this radius about the anchor. It extends `r sin θ` along an axis
    /// at the angle θ to the normal.
    pub fn bounds_within(&self, radius: f64) -> Aabb {
        let [x, y, z] = self.normal.to_array();
        let sine = |a: f64, b: f64| (a * a + b * b).sqrt();
        let half = radius * Vector::new(sine(y, z), sine(z, x), sine(x, y));
        Aabb { min: self.anchor - half, max: self.anchor + half }
    }
}

impl Carrier for PlaneThrough {
    const WHOLE: &'static str = "plane";

    #[inline]
    fn center(&self) -> Point {
        self.anchor
    }

    #[inline]
    fn roots(&self, ray: &Ray, _: Span, _: &Aabb) -> impl Roots {
        self.distance(ray, self.normal.into())
    }

    fn book_roots(&self, ray: &Ray, _: Span) -> impl IntoIterator<Item = f64> {
        [self.distance(ray, self.given_normal)]
    }

    #[inline]
    fn surface(&self, ray: &Ray, t: f64) -> Surface {
        Surface::flat(ray.at(t), self.anchor, self.normal)
    }
}
