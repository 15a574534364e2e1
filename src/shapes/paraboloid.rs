//! The paraboloid of revolution, open above: a bowl, or a burning mirror (a quadric as in Suffern,
//! ch. 19).

use std::sync::Arc;

use serde::{Deserialize, Serialize};

use super::{Candidate, Context, Shape, Surface, inside, normal_along};
use crate::invalid::{Invalid, positive};
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
        positive("height", self.height)?;
        positive("radius", self.radius)?;
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

/// Beyond this square of its distance from the origin, in radii and heights, a ray's origin is
/// moved nearer. The whole paraboloid is within 2.
const FAR: f64 = 4.0;

impl Paraboloid {
    /// In radii across and heights along the axis it is `Y = X² + Z²`. For a far origin the
    /// quadratic is formed at the point of the ray nearest to the vertex, so that nothing cancels.
    fn distances(&self, ray: &Ray) -> (f64, Option<[f64; 2]>) {
        let Self { height: h, radius: r, .. } = *self;
        let stretched = |v: Vector| Vector::new(v.x() / r, v.y() / h, v.z() / r);
        let (w, d) = (stretched(ray.origin.to_vector()), stretched(ray.direction));
        let far = w.length_squared() > FAR;
        let shift = if far { -w.dot(d) / d.length_squared() } else { 0.0 };
        let l = if far { w + shift * d } else { w };

        let (v, e) = (l.across_y(), d.across_y());
        let a = e.length_squared();
        let b = v.dot(e) - 0.5 * d.y();
        let c = v.length_squared() - l.y();
        // b² − a c without the parts of (v·e)² − v² e² that cancel
        let across = v.z() * e.x() - v.x() * e.z();
        let rise = d.y() * (0.25 * d.y() - v.dot(e));
        (shift, quadratic(a, b, c, (rise + a * l.y()) - across * across))
    }

    /// Every root is tried: when the near one lies above the rim, the far one may not.
    fn hits(&self, ray: &Ray, span: Span) -> impl Iterator<Item = Candidate> {
        let (shift, roots) = self.distances(ray);
        let roots = roots.map(|roots| roots.map(|t| shift + t));
        inside(span, roots).filter(|at| self.is_below_rim(ray.at(at.t)))
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
        self.hits(ray, span).next()
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
        self.hits(ray, span).collect()
    }

    fn bounds(&self) -> Aabb {
        let r = self.radius;
        Aabb { min: Point::new(-r, 0.0, -r), max: Point::new(r, self.height, r) }
    }
}
