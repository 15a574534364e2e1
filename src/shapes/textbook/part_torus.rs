//! The part torus about the y axis (Suffern, ch. 19).

use super::{Angles, angle, first_on, torus};
use crate::math::{Ray, Span};
use crate::shapes::{Candidate, PartTorus};

/// The part of a torus at these azimuths and angles around the tube.
#[derive(Debug)]
pub(super) struct PartTorusForm {
    a: f64,
    b: f64,
    phi: Angles,
    /// In the tube's cross-section, from the outward horizontal direction upward.
    theta: Angles,
}

impl PartTorusForm {
    pub(super) fn new(part: &PartTorus) -> Self {
        let [phi, theta] = [part.phi, part.theta].map(Angles::degrees);
        Self { a: part.swept_radius, b: part.tube_radius, phi, theta }
    }
}

impl super::Form for PartTorusForm {
    fn first(&self, ray: &Ray, span: Span) -> Option<Candidate> {
        first_on(torus::roots(ray, self.a, self.b, span), span, |t| {
            let p = ray.at(t);
            let rho = (p.x() * p.x() + p.z() * p.z()).sqrt();
            self.phi.has_azimuth_of(p) && self.theta.contains(angle(p.y(), rho - self.a))
        })
    }
}
