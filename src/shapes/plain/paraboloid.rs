//! The paraboloid of revolution, open above: a bowl, or a burning mirror (a quadric as in Suffern,
//! ch. 19).

use std::sync::Arc;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::invalid::{Invalid, length};
use crate::kinds::Specification;
use crate::math::{Aabb, Point, Ray, Span, UNIT_ROUNDOFF, Vector, quadratic};
use crate::shapes::{Candidate, Context, Shape, Surface, all_of, first_of, normal_along};

/// The points with `y/h = (x² + z²)/r²` and `y ≤ h`: from the origin up to the circle of radius `r`
/// at height `h`. The focus is at `y = r²/4h`. The normal points outward (down), or to the axis.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Paraboloid {
    /// The height; positive.
    pub height: f64,
    /// The radius of the rim; positive.
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
        let Self { height: h, radius: r, .. } = *self;
        Ok(Arc::new(Built { data: self.clone(), width: r * r / h }))
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

#[derive(Debug)]
struct Built {
    data: Paraboloid,
    /// Four times the distance from the lowest point to the focus, `r²/h`: the paraboloid is
    /// `x² + z² = width · y`.
    width: f64,
}

impl Built {
    /// With `v` and `e` across the axis and `k = width/2` it is `e² t² + 2 (v·e − k d_y) t + v² −
    /// 2 k o_y = 0`.
    #[inline(always)] // as the roots it calls
    fn distances(&self, ray: &Ray) -> Option<[f64; 2]> {
        let ([ox, oy, oz], [dx, dy, dz]) = (ray.origin.to_array(), ray.direction.to_array());
        let k = 0.5 * self.width;
        let a = dx * dx + dz * dz;
        let along = ox * dx + oz * dz;
        let c = (ox * ox + oz * oz) - self.width * oy;
        // b² − a c without the parts of (v·e)² − v² e² that cancel
        let across = oz * dx - ox * dz;
        let rise = dy * (k * dy - 2.0 * along) + 2.0 * (a * oy);
        quadratic(a, along - k * dy, c, k * rise - across * across)
    }

    /// By the height, which says little of a flat one, or by the radius, which says little of a
    /// steep one.
    fn is_below_rim(&self, ray: &Ray, t: f64) -> bool {
        let (o, d) = (ray.origin, ray.direction);
        if self.data.height >= self.data.radius {
            return o.y() + t * d.y() <= self.data.height;
        }
        let (x, z) = (o.x() + t * d.x(), o.z() + t * d.z());
        x * x + z * z <= self.data.radius * self.data.radius
    }
}

impl Shape for Built {
    fn hit(&self, ray: &Ray, span: Span) -> Option<Candidate> {
        first_of(self.distances(ray)?, span, |t| self.is_below_rim(ray, t))
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
        all_of(self.distances(ray), span, |t| self.is_below_rim(ray, t))
    }

    fn bounds(&self) -> Aabb {
        let Paraboloid { height, radius: r, .. } = self.data;
        Aabb { min: Point::new(-r, 0.0, -r), max: Point::new(r, height, r) }
    }
}
