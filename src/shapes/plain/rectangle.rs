//! The rectangle (Suffern, ch. 19): the points `p` of the plane through `p0` with the normal `n ∝ a × b` for
//! which `0 ≤ (p − p0)·a ≤ a·a` and `0 ≤ (p − p0)·b ≤ b·b`.
//!
//! A ray meets the plane at `t = (p0 − o)·n / d·n`, and then the point is tested, as in the book.
//!
//! The book's own routine: `src/shapes/textbook/rectangle.rs`.

use std::sync::Arc;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::spherical_rectangle::SphericalRectangle;
use crate::invalid::{Invalid, finite_point, finite_vector};
use crate::math::{Aabb, Length, Normal, Point, Ray, Span, Vector, exact_cross};
use crate::shapes::border::{Border, is_rounding, nears};
use crate::shapes::sampled::{ByArea, EvenSurface};
use crate::shapes::{
    Candidate, Context, SampledSurface, Sampling, Shape, Specification, Surface, plane_distance,
};

/// The rectangle from `corner` along `a` and `b`; its normal is `a × b` normalised.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Rectangle {
    /// A corner, `p0` in the book.
    pub corner: Point,
    /// One side, as a vector from `corner`; not zero.
    #[schemars(with = "Length<Vector>")]
    pub a: Vector,
    /// The other side, as a vector from `corner`; perpendicular to `a`, not zero.
    #[schemars(with = "Length<Vector>")]
    pub b: Vector,
}

#[derive(Clone, Debug)]
struct RectangleShape {
    data: Rectangle,
    normal: Normal,
    /// `|a|²` and `|b|²`.
    squared: [f64; 2],
    /// `|a|` and `|b|`.
    lengths: [f64; 2],
    /// The largest number in the test.
    size: f64,
}

/// How far from perpendicular the sides may be, as the cosine between them: more than the rounding
/// of typed numbers, less than anyone could see.
const SKEW: f64 = 1e-9;

impl Specification for Rectangle {
    fn build(&self, _: &mut Context) -> Result<Arc<dyn Shape>, Invalid> {
        finite_point("corner", self.corner)?;
        let (a, b) = (finite_vector("a", self.a)?, finite_vector("b", self.b)?);
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
        let squared = [a.length_squared(), b.length_squared()];
        let lengths = squared.map(f64::sqrt);
        let size = [self.corner.to_vector(), a, b].iter().map(|v| v.max_abs()).sum();
        Ok(Arc::new(RectangleShape { data: self.clone(), normal, squared, lengths, size }))
    }
}

impl Shape for RectangleShape {
    fn hit(&self, ray: &Ray, span: Span) -> Option<Candidate> {
        let Rectangle { corner, a, b } = self.data;
        let t = plane_distance(ray, corner, self.normal);
        if !span.contains(t) {
            return None;
        }
        let d = ray.at(t) - corner;
        let [a_squared, b_squared] = self.squared;
        let (along_a, along_b) = (d.dot(a), d.dot(b));
        let inside_a = 0.0 <= along_a && along_a <= a_squared;
        let inside_b = 0.0 <= along_b && along_b <= b_squared;
        if inside_a && inside_b {
            return Some(Candidate::at(t));
        }
        let nears = |along: f64, squared: f64| nears([along, squared - along], squared);
        let is_nearly = nears(along_a, a_squared) && nears(along_b, b_squared);
        (is_nearly && is_rounding(self, ray, t)).then(|| Candidate::at(t))
    }

    fn surface(&self, ray: &Ray, at: &Candidate) -> Surface {
        let Rectangle { corner, a, b } = self.data;
        let surface = Surface::flat(ray.at(at.t), corner, self.normal);
        let d = surface.point - corner;
        let [a_length, b_length] = self.lengths;
        let (from_b, from_a) = (d.dot(a) / a_length, d.dot(b) / b_length);
        let distances = [from_b, a_length - from_b, from_a, b_length - from_a];
        surface.within(Border::of(distances, self.size, || {
            let (a, b) = (a / a_length, b / b_length);
            [a, -a, b, -b]
        }))
    }

    fn sampled(&self, sampling: Sampling) -> Option<Box<dyn SampledSurface>> {
        Some(match sampling {
            Sampling::Area => Box::new(ByArea(self.clone())),
            Sampling::SolidAngle => Box::new(BySolidAngle(self.clone())),
        })
    }

    fn bounds(&self) -> Aabb {
        let Rectangle { corner, a, b } = self.data;
        Aabb::around([corner, corner + a, corner + b, corner + (a + b)])
    }
}

impl EvenSurface for RectangleShape {
    fn area(&self) -> f64 {
        let [a_length, b_length] = self.lengths;
        a_length * b_length
    }

    fn point(&self, [u, v]: [f64; 2]) -> Surface {
        let Rectangle { corner, a, b } = self.data;
        Surface::flat(corner + (u * a + v * b), corner, self.normal)
    }
}

/// A rectangle that is sampled evenly by solid angle; by area where it looks small.
#[derive(Debug)]
struct BySolidAngle(RectangleShape);

impl SampledSurface for BySolidAngle {
    fn sample(&self, from: Point, u: [f64; 2]) -> Option<(Surface, f64)> {
        let Some(seen) = SphericalRectangle::seen_from(from, &self.0.data) else {
            return self.0.sample_by_area(from, u);
        };
        let at = Surface::flat(seen.point(u), self.0.data.corner, self.0.normal);
        Some((at, 1.0 / seen.solid_angle))
    }

    fn pdf(&self, from: Point, at: &Surface) -> f64 {
        match SphericalRectangle::seen_from(from, &self.0.data) {
            Some(seen) => 1.0 / seen.solid_angle,
            None => self.0.pdf_by_area(from, at),
        }
    }
}
