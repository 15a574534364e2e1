//! The cut face (Suffern, ch. 19), a square with a round hole: the points of the plane y = 0 with
//! `|x|, |z| ≤ size/2` and `x² + z² ≥ radius²`.
//!
//! A ray meets the plane at `t = −o_y/d_y`, and then the point is tested, as in the book.
//!
//! The book's own routine: `src/shapes/textbook/cut_face.rs`.

use std::sync::Arc;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::invalid::{Invalid, length, shown};
use crate::math::{Aabb, Length, Normal, Point, Ray, Span, Vector};
use crate::shapes::border::{Border, along, is_rounding, nears};
use crate::shapes::{Candidate, Context, Shape, Specification, Surface, plane_distance};

/// The points of the plane y = 0 with `|x|, |z| ≤ size/2` and `x² + z² ≥ radius²`; the normal is
/// (0, 1, 0).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CutFace {
    /// The side of the square; positive.
    #[schemars(with = "Length")]
    pub size: f64,
    /// The radius of the hole: positive, and less than from the middle to a corner. Where it is more than
    /// half of `size`, four corners are left.
    #[schemars(with = "Length")]
    pub radius: f64,
}

impl Specification for CutFace {
    fn build(&self, _: &mut Context) -> Result<Arc<dyn Shape>, Invalid> {
        let size = length("size", self.size)?;
        let radius = length("radius", self.radius)?;
        let to_corner = size * std::f64::consts::FRAC_1_SQRT_2;
        if radius >= to_corner {
            let (radius, size, most) = (shown(radius), shown(size), shown(to_corner));
            let problem = format!(
                "found {radius}, but it must be less than {most}: nothing is left of size {size}"
            );
            return Err(Invalid::field("radius", problem));
        }
        Ok(Arc::new(self.clone()))
    }
}

impl CutFace {
    /// The distances from the nearer sides and from the hole.
    fn edge_distances(&self, p: Vector) -> [f64; 3] {
        let half = 0.5 * self.size;
        [half - p.x().abs(), half - p.z().abs(), p.length() - self.radius]
    }
}

impl Shape for CutFace {
    fn hit(&self, ray: &Ray, span: Span) -> Option<Candidate> {
        let t = plane_distance(ray, Point::ORIGIN, Normal::Y);
        if !span.contains(t) {
            return None;
        }
        let p = ray.at(t).to_vector().across_y();
        let in_square = p.max_abs() <= 0.5 * self.size;
        let in_hole = p.length_squared() < self.radius * self.radius;
        let is_nearly = || nears(self.edge_distances(p), self.size) && is_rounding(self, ray, t);
        (in_square && !in_hole || is_nearly()).then(|| Candidate::at(t))
    }

    fn surface(&self, ray: &Ray, at: &Candidate) -> Surface {
        let surface = Surface::flat(ray.at(at.t), Point::ORIGIN, Normal::Y);
        let p = surface.point.to_vector().across_y();
        surface.within(Border::of(self.edge_distances(p), self.size, || {
            let to_middle = |x: f64| -1.0_f64.copysign(x);
            [to_middle(p.x()) * Vector::X, to_middle(p.z()) * Vector::Z, along(p)]
        }))
    }

    fn bounds(&self) -> Aabb {
        let half = 0.5 * self.size;
        Aabb { min: Point::new(-half, 0.0, -half), max: Point::new(half, 0.0, half) }
    }
}
