//! The sphere (Suffern, ch. 3).

use std::sync::Arc;

use serde::{Deserialize, Serialize};

use super::{Candidate, Context, Shape, Surface, inside};
use crate::invalid::{Invalid, finite_point, positive};
use crate::kinds::Specification;
use crate::math::{Aabb, Normal, Point, Ray, Span, UNIT_ROUNDOFF, Vector, perpendicular_roots};

/// All points `p` with `|p − center| = radius`; the normal points outward.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Sphere {
    /// The centre.
    pub center: Point,
    /// Positive.
    pub radius: f64,
}

impl Specification for Sphere {
    type Built = Arc<dyn Shape>;
    type Context = Context;

    fn build(&self, _: &mut Context) -> Result<Arc<dyn Shape>, Invalid> {
        let center = finite_point("center", self.center)?;
        Ok(Arc::new(Self { center, radius: positive("radius", self.radius)? }))
    }

    fn scaled(&self, factor: f64) -> Self {
        Self { center: self.center.scaled(factor), radius: factor * self.radius }
    }

    fn specimens() -> Vec<Self> {
        vec![
            Self { center: Point::ORIGIN, radius: 1.0 },
            Self { center: Point::new(0.5, -0.75, 0.25), radius: 0.3 },
        ]
    }
}

impl Sphere {
    fn distances(&self, ray: &Ray) -> Option<[f64; 2]> {
        perpendicular_roots(ray.origin - self.center, ray.direction, self.radius)
    }
}

impl Shape for Sphere {
    fn hit(&self, ray: &Ray, span: Span) -> Option<Candidate> {
        inside(span, self.distances(ray)).next()
    }

    fn surface(&self, ray: &Ray, at: &Candidate) -> Surface {
        // from so far away that the point is rounded onto the centre: the side that faces the ray
        let facing = || Normal::new(-ray.direction).unwrap_or(Normal::Y);
        let normal = Normal::new(ray.at(at.t) - self.center).unwrap_or_else(facing);
        let point = self.center + self.radius * normal;
        // the sum above, and the next ray's difference from the centre and its |f| − r
        let magnitude = point.to_vector().abs() + self.center.to_vector().abs();
        let error = 4.0 * UNIT_ROUNDOFF * magnitude.dot(Vector::from(normal).abs())
            + 8.0 * UNIT_ROUNDOFF * self.radius;
        Surface::new(point, error, normal)
    }

    fn roots(&self, ray: &Ray, span: Span) -> Vec<Candidate> {
        inside(span, self.distances(ray)).collect()
    }

    fn bounds(&self) -> Aabb {
        let r = self.radius * Vector::new(1.0, 1.0, 1.0);
        Aabb { min: self.center - r, max: self.center + r }
    }
}
