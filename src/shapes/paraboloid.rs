//! The paraboloid of revolution, open above: a bowl, or a burning mirror (a quadric as in Suffern,
//! ch. 19).

use std::sync::Arc;

use serde::{Deserialize, Serialize};

use super::{Candidate, Context, Shape, Surface, all_of, first_of, normal_along};
use crate::invalid::{Invalid, length};
use crate::kinds::Specification;
use crate::math::{Aabb, Point, Ray, Span, UNIT_ROUNDOFF, Vector, quadratic};

/// The points with `y/h = (x² + z²)/r²` and `y ≤ h`: from the origin up to the circle of radius `r`
/// at height `h`. The focus is at `y = r²/4h`. The normal points outward (down), or to the axis.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Paraboloid {
    /// Positive.
    pub height: f64,
    /// Of the rim; positive.
    pub radius: f64,
    /// Whether the normal points to the axis.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub inward: bool,
}

impl Specification for Paraboloid {
    type Built = Arc<dyn Shape>;
    type Context = Context;

    fn build(&self, _: &mut Context) -> Result<Arc<dyn Shape>, Invalid> {
        length("height", self.height)?;
        length("radius", self.radius)?;
        Ok(Arc::new(self.clone()))
    }

    fn scaled(&self, factor: f64) -> Self {
        Self { height: factor * self.height, radius: factor * self.radius, ..*self }
    }

    fn specimens() -> Vec<Self> {
        vec![
            Self { height: 1.0, radius: 1.0, inward: false },
            Self { height: 0.3, radius: 0.7, inward: true },
        ]
    }
}

impl Paraboloid {
    /// In radii across and heights along the axis it is `Y = X² + Z²`: with `v` and `e` across the
    /// axis, `e² t² + 2 (v·e − d_y/2) t + v² − w_y = 0`.
    fn distances(&self, ray: &Ray) -> Option<[f64; 2]> {
        let Self { height: h, radius: r, .. } = *self;
        let stretched = |v: Vector| Vector::new(v.x() / r, v.y() / h, v.z() / r);
        let (w, d) = (stretched(ray.origin.to_vector()), stretched(ray.direction));
        let (v, e) = (w.across_y(), d.across_y());
        let a = e.length_squared();
        let b = v.dot(e) - 0.5 * d.y();
        let c = v.length_squared() - w.y();
        // b² − a c without the parts of (v·e)² − v² e² that cancel
        let across = v.z() * e.x() - v.x() * e.z();
        let rise = d.y() * (0.25 * d.y() - v.dot(e));
        quadratic(a, b, c, (rise + a * w.y()) - across * across)
    }

    /// Down the wall from the rim, measured along the wall there: its height alone says little of a
    /// flat one, its radius little of a steep one.
    fn is_below_rim(&self, p: Point) -> bool {
        let rho = p.to_vector().across_y().length();
        (self.radius - rho) * self.radius + 2.0 * (self.height - p.y()) * self.height >= 0.0
    }
}

impl Shape for Paraboloid {
    fn hit(&self, ray: &Ray, span: Span) -> Option<Candidate> {
        first_of(self.distances(ray)?, span, |t| self.is_below_rim(ray.at(t)))
    }

    fn surface(&self, ray: &Ray, at: &Candidate) -> Surface {
        let Self { height: h, radius: r, inward } = *self;
        // F = (x² + z²)/r² − y/h and its gradient
        let f = |p: Point| {
            let across = p.to_vector().across_y() / r;
            (across.length_squared() - p.y() / h, (2.0 / r) * across - (1.0 / h) * Vector::Y)
        };
        let mut point = ray.at(at.t);
        for _ in 0..2 {
            let (value, gradient) = f(point); // two of Newton's steps: the origin may be far away
            point = point - (value / gradient.length_squared()) * gradient;
        }
        let (_, gradient) = f(point);
        let normal = normal_along(gradient, ray);
        // rounding of the terms of F, each of the size of y/h, and of the ray's next origin
        let error = 32.0 * UNIT_ROUNDOFF * (point.y().abs() / h) / gradient.length()
            + 4.0 * UNIT_ROUNDOFF * point.to_vector().abs().dot(Vector::from(normal).abs());
        Surface::new(point, error, normal).turned(inward)
    }

    fn roots(&self, ray: &Ray, span: Span) -> Vec<Candidate> {
        all_of(self.distances(ray), span, |t| self.is_below_rim(ray.at(t)))
    }

    fn bounds(&self) -> Aabb {
        let r = self.radius;
        Aabb { min: Point::new(-r, 0.0, -r), max: Point::new(r, self.height, r) }
    }
}
