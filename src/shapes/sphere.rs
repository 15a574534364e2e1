//! The sphere (Suffern, ch. 3).

use std::sync::Arc;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{Candidate, Context, Shape, Surface, all_of, first_of, normal_along};
use crate::invalid::{Invalid, finite_point, length};
use crate::kinds::Specification;
use crate::math::{Aabb, Point, Ray, Span, UNIT_ROUNDOFF, Vector, perpendicular_roots};

/// All points `p` with `|p − center| = radius`; the normal points outward, or to the centre.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Sphere {
    /// The centre.
    pub center: Point,
    /// The radius; positive.
    pub radius: f64,
    /// Whether the normal points to the centre: the book's concave sphere.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub inward: bool,
}

impl Specification for Sphere {
    type Built = Arc<dyn Shape>;
    type Context = Context;

    fn build(&self, _: &mut Context) -> Result<Arc<dyn Shape>, Invalid> {
        Ok(Arc::new(self.checked()?))
    }

    fn scaled(&self, factor: f64) -> Self {
        Self { center: self.center.scaled(factor), radius: factor * self.radius, ..*self }
    }

    fn specimens() -> Vec<Self> {
        vec![
            Self { center: Point::ORIGIN, radius: 1.0, inward: false },
            Self { center: Point::new(0.5, -0.75, 0.25), radius: 0.3, inward: false },
        ]
    }
}

impl Sphere {
    /// A copy whose numbers are fit for use.
    pub(super) fn checked(&self) -> Result<Self, Invalid> {
        finite_point("center", self.center)?;
        length("radius", self.radius)?;
        Ok(self.clone())
    }

    /// Where the line meets it, ascending.
    #[inline(always)] // as the roots it calls
    pub(super) fn distances(&self, ray: &Ray) -> Option<[f64; 2]> {
        perpendicular_roots(ray.origin - self.center, ray.direction, self.radius)
    }
}

impl Shape for Sphere {
    fn hit(&self, ray: &Ray, span: Span) -> Option<Candidate> {
        first_of(self.distances(ray)?, span, |_| true)
    }

    fn surface(&self, ray: &Ray, at: &Candidate) -> Surface {
        let from_center = ray.at(at.t) - self.center;
        let normal = normal_along(from_center, ray);
        let point = self.center + self.radius * normal;
        // the sum above, and the next ray's difference from the centre and its |f| − r
        let magnitude = point.to_vector().abs() + self.center.to_vector().abs();
        let error = 4.0 * UNIT_ROUNDOFF * magnitude.dot(Vector::from(normal).abs())
            + 8.0 * UNIT_ROUNDOFF * self.radius;
        Surface::new(point, error, normal).turned(self.inward)
    }

    fn roots(&self, ray: &Ray, span: Span) -> Vec<Candidate> {
        all_of(self.distances(ray), span, |_| true)
    }

    fn bounds(&self) -> Aabb {
        let r = self.radius * Vector::new(1.0, 1.0, 1.0);
        Aabb { min: self.center - r, max: self.center + r }
    }
}
