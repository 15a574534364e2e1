//! The part cylinder about the y axis (Suffern, ch. 19).

use super::{Angles, first_on, open_cylinder};
use crate::math::{Ray, Span};
use crate::shapes::{Candidate, PartCylinder};

/// The part of an open cylinder at these azimuths.
#[derive(Debug)]
pub(super) struct PartCylinderForm {
    part: PartCylinder,
    phi: Angles,
}

impl PartCylinderForm {
    pub(super) fn new(part: &PartCylinder) -> Self {
        Self { part: part.clone(), phi: Angles::degrees(part.phi) }
    }
}

impl super::Form for PartCylinderForm {
    fn first(&self, ray: &Ray, span: Span) -> Option<Candidate> {
        let PartCylinder { y0, y1, radius, .. } = self.part;
        first_on(open_cylinder::roots(ray, radius)?, span, |t| {
            let p = ray.at(t);
            y0 < p.y() && p.y() < y1 && self.phi.has_azimuth_of(p)
        })
    }
}
