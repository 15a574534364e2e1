//! The disk (Suffern, ch. 19).

use super::{Form, first_on, plane};
use crate::math::{Ray, Span};
use crate::shapes::{Candidate, Disk};

impl Form for Disk {
    /// `|p − center|² < radius²`.
    fn first(&self, ray: &Ray, span: Span) -> Option<Candidate> {
        let t = plane::distance(ray, self.center, self.normal);
        let r_squared = self.radius * self.radius;
        first_on([t], span, |t| self.center.distance_squared(ray.at(t)) < r_squared)
    }
}
