//! The infinite plane (Suffern, ch. 3): the points `p` with `(p − a)·n = 0`.
//!
//! A ray meets it at `t = (a − o)·n / d·n`, as in the book. For a ray parallel to the plane that is
//! infinite or NaN, and no span contains it.
//!
//! The book's own routine: `src/shapes/textbook/plane.rs`.

use std::sync::Arc;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::invalid::{Invalid, direction, finite_point};
use crate::math::{Aabb, Normal, Point, Ray, Span, Vector};
use crate::shapes::{Candidate, Context, Shape, Specification, Surface, plane_distance};

/// All points `p` with `(p − point)·normal = 0`; the normal need not be unit.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Plane {
    /// A point of the plane.
    pub point: Point,
    /// Perpendicular to the plane; not zero, need not be unit.
    pub normal: Vector,
}

#[derive(Debug)]
struct PlaneShape {
    point: Point,
    normal: Normal,
}

impl Specification for Plane {
    fn build(&self, _: &mut Context) -> Result<Arc<dyn Shape>, Invalid> {
        let point = finite_point("point", self.point)?;
        Ok(Arc::new(PlaneShape { point, normal: direction("normal", self.normal)? }))
    }
}

impl Shape for PlaneShape {
    fn hit(&self, ray: &Ray, span: Span) -> Option<Candidate> {
        let t = plane_distance(ray, self.point, self.normal);
        span.contains(t).then(|| Candidate::at(t))
    }

    fn surface(&self, ray: &Ray, at: &Candidate) -> Surface {
        Surface::flat(ray.at(at.t), self.point, self.normal)
    }

    fn bounds(&self) -> Aabb {
        Aabb::EVERYTHING
    }
}
