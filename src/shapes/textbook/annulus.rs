//! The annulus (Suffern, ch. 19).

use super::{Form, first_on, plane};
use crate::math::{Ray, Span};
use crate::shapes::{Annulus, Candidate};

impl Form for Annulus {
    /// `inner² < |p − center|² < outer²`.
    fn first(&self, ray: &Ray, span: Span) -> Option<Candidate> {
        let t = plane::distance(ray, self.center, self.normal);
        first_on([t], span, |t| {
            let squared = self.center.distance_squared(ray.at(t));
            self.inner_radius * self.inner_radius < squared
                && squared < self.outer_radius * self.outer_radius
        })
    }
}
