//! The triangle (Suffern, ch. 19).

use std::sync::Arc;

use serde::{Deserialize, Serialize};

use super::{Candidate, Context, Shape, Surface, watertight};
use crate::invalid::{Invalid, finite_point};
use crate::kinds::Specification;
use crate::math::{Aabb, Normal, Point, Ray, Span};

/// A triangle; its normal is `(v1 − v0) × (v2 − v0)` normalised.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Triangle {
    /// The corners, not on one line.
    pub vertices: [Point; 3],
}

#[derive(Debug)]
struct Built {
    vertices: [Point; 3],
    normal: Normal,
}

impl Specification for Triangle {
    type Built = Arc<dyn Shape>;
    type Context = Context;

    fn build(&self, _: &mut Context) -> Result<Arc<dyn Shape>, Invalid> {
        for (i, &vertex) in self.vertices.iter().enumerate() {
            finite_point("", vertex)
                .map_err(|e| Invalid::new(e.problem).inside(i).inside("vertices"))?;
        }
        let normal = watertight::normal(self.vertices).ok_or_else(|| {
            let found = self.vertices.map(Point::to_array);
            Invalid::field(
                "vertices",
                format!("found {found:?}, a triangle of area zero, but its corners must not be on one line"),
            )
        })?;
        Ok(Arc::new(Built { vertices: self.vertices, normal }))
    }

    fn scaled(&self, factor: f64) -> Self {
        Self { vertices: self.vertices.map(|v| v.scaled(factor)) }
    }

    fn specimens() -> Vec<Self> {
        let triangle =
            |a: [f64; 3], b: [f64; 3], c: [f64; 3]| Self { vertices: [a, b, c].map(Point::from) };
        vec![
            triangle([-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [0.0, 1.0, 0.0]),
            triangle([-1.1, -0.85, 0.8], [1.2, 0.1, 0.2], [-0.4, 0.5, -0.3]),
        ]
    }
}

impl Shape for Built {
    fn hit(&self, ray: &Ray, span: Span) -> Option<Candidate> {
        let meeting = watertight::ShearedRay::new(ray).meet(self.vertices)?;
        span.contains(meeting.t)
            .then_some(Candidate { parameters: meeting.barycentric, ..Candidate::at(meeting.t) })
    }

    fn surface(&self, _: &Ray, at: &Candidate) -> Surface {
        let (point, error) = watertight::point_on(self.vertices, at.parameters, self.normal);
        Surface::new(point, error, self.normal)
    }

    fn bounds(&self) -> Aabb {
        watertight::bounds(self.vertices)
    }
}
