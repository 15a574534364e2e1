//! The cut face (Suffern, ch. 19): a square with a hole.

use super::{Form, first_on, plane};
use crate::math::{Point, Ray, Span, Vector};
use crate::shapes::{Candidate, CutFace};

impl Form for CutFace {
    /// The points of `y = 0` with `|x|, |z| ≤ size/2` and `x² + z² ≥ radius²`.
    fn first(&self, ray: &Ray, span: Span) -> Option<Candidate> {
        let t = plane::distance(ray, Point::ORIGIN, Vector::Y);
        first_on([t], span, |t| {
            let (p, half) = (ray.at(t), 0.5 * self.size);
            p.x().abs() <= half
                && p.z().abs() <= half
                && p.x() * p.x() + p.z() * p.z() >= self.radius * self.radius
        })
    }
}
