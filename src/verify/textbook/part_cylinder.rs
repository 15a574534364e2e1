//! The part cylinder about the y axis (Suffern, ch. 19).

use super::{Angles, SMALL_K_EPSILON, Textbook, azimuth, open_cylinder};
use crate::math::Ray;

/// The part of an open cylinder at these azimuths.
#[derive(Clone, Debug)]
pub struct PartCylinder {
    /// The lower end.
    pub y0: f64,
    /// The upper end.
    pub y1: f64,
    /// The radius.
    pub radius: f64,
    /// The azimuths, from +z towards +x.
    pub phi: Angles,
}

impl Textbook for PartCylinder {
    /// Both roots in order.
    fn hit(&self, ray: &Ray) -> Option<f64> {
        open_cylinder::roots(ray, self.radius)?.into_iter().find(|&t| {
            let p = ray.at(t);
            t > SMALL_K_EPSILON
                && self.y0 < p.y()
                && p.y() < self.y1
                && self.phi.contains(azimuth(p))
        })
    }
}
