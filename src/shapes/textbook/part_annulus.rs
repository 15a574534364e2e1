//! The part annulus (Suffern, ch. 19).

use super::{Angles, first_on};
use crate::math::{Point, Ray, Span};
use crate::shapes::{Annulus, Candidate, PartAnnulus};

/// A level annulus, and its azimuths, which are measured about its centre.
#[derive(Debug)]
pub(super) struct PartAnnulusForm {
    whole: Annulus,
    phi: Angles,
}

impl PartAnnulusForm {
    pub(super) fn new(part: &PartAnnulus) -> Self {
        let &PartAnnulus { center, normal, inner_radius, outer_radius, phi } = part;
        let whole = Annulus { center, normal, inner_radius, outer_radius };
        Self { whole, phi: Angles::degrees(phi) }
    }
}

impl super::Form for PartAnnulusForm {
    fn first(&self, ray: &Ray, span: Span) -> Option<Candidate> {
        let at = super::Form::first(&self.whole, ray, span)?;
        first_on([at.t], span, |t| {
            self.phi.has_azimuth_of(Point::ORIGIN + (ray.at(t) - self.whole.center))
        })
    }
}
