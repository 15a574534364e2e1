//! The part sphere (Suffern, ch. 19).

use super::{Angles, first_on, sphere};
use crate::math::{Point, Ray, Span, cos_degrees};
use crate::shapes::{Candidate, PartSphere};

/// The part of a sphere at these azimuths, and between these heights above its centre.
#[derive(Debug)]
pub(super) struct PartSphereForm {
    center: Point,
    radius: f64,
    phi: Angles,
    heights: [f64; 2],
}

impl PartSphereForm {
    /// `r cos θ_max ≤ y ≤ r cos θ_min`.
    pub(super) fn new(part: &PartSphere) -> Self {
        let &PartSphere { center, radius, phi, theta: [min, max], .. } = part;
        let heights = [max, min].map(|theta| radius * cos_degrees(theta));
        Self { center, radius, phi: Angles::degrees(phi), heights }
    }
}

impl super::Form for PartSphereForm {
    fn first(&self, ray: &Ray, span: Span) -> Option<Candidate> {
        let [lowest, highest] = self.heights;
        first_on(sphere::roots(ray, self.center, self.radius)?, span, |t| {
            let from_center = Point::ORIGIN + (ray.at(t) - self.center);
            (lowest..=highest).contains(&from_center.y()) && self.phi.has_azimuth_of(from_center)
        })
    }
}
