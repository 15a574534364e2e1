//! The paraboloid of revolution, open above (a quadric as in Suffern, ch. 19): the points with
//! `x² + z² = w y` and `y ≤ h`, where `w = r²/h`.
//!
//! With `k = w/2` a ray meets it where `a t² + 2 b t + c = 0` with `a = d_x² + d_z²`, `b = e − k d_y`,
//! `e = o_x d_x + o_z d_z` and `c = o_x² + o_z² − w o_y`. The discriminant `b² − a c` is taken as
//! `k (d_y (k d_y − 2 e) + 2 a o_y) − (o_z d_x − o_x d_z)²`: the parts of `e²` and `a (o_x² + o_z²)` that
//! cancel are left out.
//!
//! The textbook's routine, as the book solves its cone: `src/shapes/textbook/paraboloid.rs`.

use std::sync::Arc;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::invalid::{Invalid, length};
use crate::math::{Aabb, Length, Point, Ray, Span, UNIT_ROUNDOFF, Vector, quadratic};
use crate::shapes::border::{Border, along, is_rounding, nears_level};
use crate::shapes::{
    Candidate, Context, Shape, Specification, Surface, all_of, first_of, normal_along,
};

/// The points with `y/h = (x² + z²)/r²` and `y ≤ h`: from the origin up to the circle of radius `r`
/// at height `h`. The focus is at `y = r²/4h`. The normal points outward (down), or to the axis.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Paraboloid {
    /// The height; positive.
    #[schemars(with = "Length")]
    pub height: f64,
    /// The radius of the rim; positive.
    #[schemars(with = "Length")]
    pub radius: f64,
    /// Whether the normal points to the axis.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub inward: bool,
}

impl Specification for Paraboloid {
    fn build(&self, _: &mut Context) -> Result<Arc<dyn Shape>, Invalid> {
        length("height", self.height)?;
        length("radius", self.radius)?;
        let Self { height: h, radius: r, .. } = *self;
        Ok(Arc::new(ParaboloidShape { data: self.clone(), w: r * r / h }))
    }
}

#[derive(Debug)]
struct ParaboloidShape {
    data: Paraboloid,
    /// `w = r²/h`.
    w: f64,
}

impl ParaboloidShape {
    /// Where the line meets the endless paraboloid, ascending.
    #[inline(always)] // as the roots it calls
    fn distances(&self, ray: &Ray) -> Option<[f64; 2]> {
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

    /// `y ≤ h`, or, for a flat paraboloid, where y is rounded more than ρ, the same as `ρ ≤ r`.
    fn is_below_rim(&self, ray: &Ray, t: f64) -> bool {
        let (o, d) = (ray.origin, ray.direction);
        if self.data.height >= self.data.radius {
            return o.y() + t * d.y() <= self.data.height;
        }
        let (x, z) = (o.x() + t * d.x(), o.z() + t * d.z());
        x * x + z * z <= self.data.radius * self.data.radius
    }
}

impl ParaboloidShape {
    fn has(&self, ray: &Ray) -> impl Fn(f64) -> bool {
        |t| {
            self.is_below_rim(ray, t)
                || nears_level(ray, t, self.data.height) && is_rounding(self, ray, t)
        }
    }

    /// The rim, by the distance from it along the wall, which slopes by `2 h ρ/r²`.
    fn border(&self, p: Point) -> Option<Box<Border>> {
        let Paraboloid { height: h, radius: r, .. } = self.data;
        let (rho, radial) = (p.to_vector().across_y().length(), along(p.to_vector().across_y()));
        let up = along(radial + (2.0 * h / r) * (rho / r) * Vector::Y);
        let below_rim = if h >= r { (h - p.y()) / up.y() } else { (r - rho) / up.dot(radial) };
        let border = Border::of([below_rim], h.max(r), || [-up]);
        border.map(|border| Box::new(border.cut_across(Vector::Y)))
    }
}

impl Shape for ParaboloidShape {
    fn hit(&self, ray: &Ray, span: Span) -> Option<Candidate> {
        first_of(self.distances(ray)?, span, self.has(ray))
    }

    fn surface(&self, ray: &Ray, at: &Candidate) -> Surface {
        let Paraboloid { height: h, radius: r, inward } = self.data;
        // F = (x² + z²)/r² − y/h and its gradient
        let f = |p: Point| {
            let across = p.to_vector().across_y() / r;
            (across.length_squared() - p.y() / h, (2.0 / r) * across - (1.0 / h) * Vector::Y)
        };
        let mut point = ray.at(at.t);
        for _ in 0..2 {
            let (value, gradient) = f(point); // Newton's method; two steps, as the origin may be far away
            point = point - (value / gradient.length_squared()) * gradient;
        }
        let (_, gradient) = f(point);
        let normal = normal_along(gradient, ray);
        // rounding of the terms of F, each of the size of y/h, and of the ray's next origin
        let error = 32.0 * UNIT_ROUNDOFF * (point.y().abs() / h) / gradient.length()
            + 4.0 * UNIT_ROUNDOFF * point.to_vector().abs().dot(Vector::from(normal).abs());
        Surface::new(point, error, normal).turned(inward).within(self.border(point))
    }

    fn roots(&self, ray: &Ray, span: Span) -> Vec<Candidate> {
        all_of(self.distances(ray), span, self.has(ray))
    }

    fn bounds(&self) -> Aabb {
        let Paraboloid { height, radius: r, .. } = self.data;
        Aabb { min: Point::new(-r, 0.0, -r), max: Point::new(r, height, r) }
    }
}
