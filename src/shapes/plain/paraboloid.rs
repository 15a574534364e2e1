//! The paraboloid of revolution, open above (a quadric as in Suffern, ch. 19): the points with
//! `x² + z² = w y` and `y ≤ h`, where `w = r²/h`.
//!
//! With `k = w/2` a ray meets it where `a t² + 2 b t + c = 0` with `a = d_x² + d_z²`,
//! `b = e − k d_y`, `e = o_x d_x + o_z d_z` and `c = o_x² + o_z² − w o_y`. The discriminant
//! `b² − a c` is taken as `k (d_y (k d_y − 2 e) + 2 a o_y) − (o_z d_x − o_x d_z)²`: the parts of
//! `e²` and `a (o_x² + o_z²)` that cancel are left out.

use crate::math::{Aabb, Length, Point, Ray, Span, UNIT_ROUNDOFF, Vector, quadratic};
use crate::shapes::plain::rim::Rim;
use crate::shapes::textbook::schoolbook_roots;
use crate::shapes::trimmed::{All, Carrier, Roots, Trimmed};
use crate::shapes::{Context, Made, Specification, Surface, made, normal_along};

/// The points with `y/h = (x² + z²)/r²` and `y ≤ h`: from the origin up to the circle of radius `r`
/// at height `h`. The focus is at `y = r²/4h`. The normal points outward (down), or to the axis.
#[kind(PartialEq)]
pub struct Paraboloid {
    /// The height; positive.
    pub height: Length,
    /// The radius of the rim; positive.
    pub radius: Length,
    /// Whether the normal points to the axis.
    #[optional]
    pub inward: bool,
}

impl Specification for Paraboloid {
    fn make(&self, _: &mut Context) -> Made {
        let Self { height: h, radius: r, .. } = *self;
        let endless = Endless { data: self.clone(), w: r * r / h };
        let bounds = Aabb { min: Point::new(-r, 0.0, -r), max: Point::new(r, h, r) };
        let rim = Rim {
            y: h,
            radius: r,
            is_flat: h < r,
            slopes: [0.0, 2.0 * h / r],
            book_heights: [f64::NEG_INFINITY, h],
        };
        made(Trimmed::new(endless, (rim, All), h.max(r), bounds))
    }
}

/// The paraboloid without an end.
#[derive(Clone, Debug)]
struct Endless {
    data: Paraboloid,
    /// `w = r²/h`.
    w: f64,
}

impl Carrier for Endless {
    const WHOLE: &'static str = "paraboloid without end";

    #[inline(always)] // as the roots it calls
    fn roots(&self, ray: &Ray, _: Span, _: &Aabb) -> impl Roots {
        let ([ox, oy, oz], [dx, dy, dz]) = (ray.origin.to_array(), ray.direction.to_array());
        let k = 0.5 * self.w;
        let a = dx * dx + dz * dz;
        let e = ox * dx + oz * dz;
        let b = e - k * dy;
        let c = (ox * ox + oz * oz) - self.w * oy;
        let across = oz * dx - ox * dz;
        let discriminant = k * (dy * (k * dy - 2.0 * e) + 2.0 * (a * oy)) - across * across;
        quadratic(a, b, c, discriminant)
    }

    /// `(h/r²) (x² + z²) = y`, solved as the book solves its cone.
    fn book_roots(&self, ray: &Ray, _: Span) -> impl IntoIterator<Item = f64> {
        let ([ox, oy, oz], [dx, dy, dz]) = (ray.origin.to_array(), ray.direction.to_array());
        let k = self.data.height / (self.data.radius * self.data.radius);
        let a = k * (dx * dx + dz * dz);
        let b = 2.0 * k * (ox * dx + oz * dz) - dy;
        let c = k * (ox * ox + oz * oz) - oy;
        schoolbook_roots(a, b, c).into_iter().flatten()
    }

    fn surface(&self, ray: &Ray, t: f64) -> Surface {
        let Paraboloid { height: h, radius: r, inward } = self.data;
        // F = (x² + z²)/r² − y/h and its gradient
        let f = |p: Point| {
            let across = p.to_vector().across_y() / r;
            (across.length_squared() - p.y() / h, (2.0 / r) * across - (1.0 / h) * Vector::Y)
        };
        let mut point = ray.at(t);
        for _ in 0..2 {
            let (value, gradient) = f(point); // Newton's method; two steps, as the origin may be far away
            point = point - (value / gradient.length_squared()) * gradient;
        }
        let (_, gradient) = f(point);
        let normal = normal_along(gradient, ray);
        // rounding of the terms of F, each of the size of y/h, and of the ray's next origin
        let error = 32.0 * UNIT_ROUNDOFF * (point.y().abs() / h) / gradient.length()
            + 4.0 * UNIT_ROUNDOFF * point.to_vector().abs().dot(Vector::from(normal).abs());
        Surface::new(point, error, normal).turned(inward)
    }
}
