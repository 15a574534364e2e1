//! The rectangle (Suffern, ch. 19): the points `p` of the plane through `p0` with the normal
//! `n ∝ a × b` for which `0 ≤ (p − p0)·a ≤ a·a` and `0 ≤ (p − p0)·b ≤ b·b`.
//!
//! A ray meets the plane at `t = (p0 − o)·n / d·n`, and then the point is tested, as in the book.

use super::spherical_rectangle::SphericalRectangle;
use crate::invalid::Invalid;
use crate::math::{Aabb, Displacement, Normal, Point, Ray, Vector, exact_cross};
use crate::shapes::border::nears;
use crate::shapes::plain::plane::PlaneThrough;
use crate::shapes::sampled::{ByArea, EvenSurface};
use crate::shapes::trimmed::{Trim, Trimmed};
use crate::shapes::{Context, Made, SampledSurface, Sampling, Specification, Surface, made};

/// The rectangle from `corner` along `a` and `b`; its normal is `a × b` normalised.
#[kind(PartialEq)]
pub struct Rectangle {
    /// A corner, `p0` in the book.
    pub corner: Point,
    /// One side, as a vector from `corner`; not zero.
    pub a: Displacement,
    /// The other side, as a vector from `corner`; perpendicular to `a`, not zero.
    pub b: Displacement,
}

type RectangleShape = Trimmed<PlaneThrough, SideTrim, SideTrim>;

/// The points with `0 ≤ (p − p0)·a ≤ a·a` for one side a.
#[derive(Clone, Debug)]
struct SideTrim {
    a: Vector,
    /// `|a|²`.
    square: f64,
    /// `|a|`.
    length: f64,
}

/// How far from perpendicular the sides may be, as the cosine between them: more than the rounding
/// of typed numbers, less than anyone could see.
const SKEW: f64 = 1e-9;

impl Specification for Rectangle {
    fn make(&self, _: &mut Context) -> Made {
        let Self { corner, a, b } = *self;
        let zero = Point::ORIGIN;
        let normal = Normal::new(exact_cross(zero, zero + a, zero + b)).ok_or_else(|| {
            Invalid::field(
                "b",
                format!("found {:?}, but the sides must span an area", b.to_array()),
            )
        })?;
        let cosine = a.dot(b) / (a.length() * b.length());
        if cosine.abs() > SKEW {
            let (a, b) = (a.to_array(), b.to_array());
            return Err(Invalid::field(
                "b",
                format!("found {b:?}, but it must be perpendicular to a, {a:?}"),
            ));
        }
        let size = [corner.to_vector(), a, b].iter().map(|v| v.max_abs()).sum();
        let given_normal = a.cross(b).unit().unwrap_or(Vector::ZERO);
        let plane = PlaneThrough { anchor: corner, normal, given_normal };
        let [p, q] = [corner, corner + a];
        let bounds = Aabb::around([p, q, p + b, p + (a + b)]);
        let sampler = |it: &RectangleShape, sampling| -> Option<Box<dyn SampledSurface>> {
            Some(match sampling {
                Sampling::Area => Box::new(ByArea(it.clone())),
                Sampling::SolidAngle => Box::new(BySolidAngle(it.clone())),
            })
        };
        let rectangle = Trimmed::new(plane, (SideTrim::along(a), SideTrim::along(b)), size, bounds);
        made(Trimmed { sampler, ..rectangle })
    }
}

impl SideTrim {
    fn along(a: Vector) -> Self {
        let square = a.length_squared();
        Self { a, square, length: square.sqrt() }
    }
}

impl Trim for SideTrim {
    #[inline]
    fn has(&self, v: Vector) -> bool {
        let along = v.dot(self.a);
        0.0 <= along && along <= self.square
    }

    #[inline]
    fn distances(&self, v: Vector) -> [f64; 2] {
        let along = v.dot(self.a) / self.length;
        [along, self.length - along]
    }

    fn away(&self, _: Vector) -> [Vector; 2] {
        let unit = self.a / self.length;
        [unit, -unit]
    }

    /// Without a division.
    #[inline]
    fn nears(&self, v: Vector, _size: f64, _: &Ray, _t: f64) -> bool {
        let along = v.dot(self.a);
        nears([along, self.square - along], self.square)
    }
}

impl EvenSurface for RectangleShape {
    fn area(&self) -> f64 {
        let (a, b) = &self.trims;
        a.length * b.length
    }

    fn point(&self, [u, v]: [f64; 2]) -> Surface {
        let (PlaneThrough { anchor, normal, .. }, (a, b)) = (&self.carrier, &self.trims);
        Surface::flat(*anchor + (u * a.a + v * b.a), *anchor, *normal)
    }
}

/// A rectangle that is sampled evenly by solid angle; by area where it looks small.
#[derive(Debug)]
struct BySolidAngle(RectangleShape);

impl BySolidAngle {
    #[inline]
    fn seen_from(&self, from: Point) -> Option<SphericalRectangle> {
        let (a, b) = &self.0.trims;
        SphericalRectangle::seen_from(from, self.0.carrier.anchor, [a.a, b.a])
    }
}

impl SampledSurface for BySolidAngle {
    fn sample(&self, from: Point, u: [f64; 2]) -> Option<(Surface, f64)> {
        let Some(seen) = self.seen_from(from) else {
            return self.0.sample_by_area(from, u);
        };
        let PlaneThrough { anchor, normal, .. } = self.0.carrier;
        let at = Surface::flat(seen.point(u), anchor, normal);
        Some((at, 1.0 / seen.solid_angle))
    }

    fn pdf(&self, from: Point, at: &Surface) -> f64 {
        match self.seen_from(from) {
            Some(seen) => 1.0 / seen.solid_angle,
            None => self.0.pdf_by_area(from, at),
        }
    }
}
