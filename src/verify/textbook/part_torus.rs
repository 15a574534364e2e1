//! The part torus about the y axis (Suffern, ch. 19).

use super::{Angles, SMALL_K_EPSILON, Textbook, azimuth, torus};
use crate::math::{Ray, atan2};

/// The part of a torus at these azimuths and angles around the tube.
#[derive(Clone, Debug)]
pub struct PartTorus {
    /// The radius of the circle that the tube follows.
    pub a: f64,
    /// The radius of the tube.
    pub b: f64,
    /// The azimuths, from +z towards +x.
    pub phi: Angles,
    /// The angles in the tube's cross-section, from the outward horizontal direction upward.
    pub theta: Angles,
}

impl Textbook for PartTorus {
    fn hit(&self, ray: &Ray) -> Option<f64> {
        torus::roots(ray, self.a, self.b).into_iter().find(|&t| {
            let p = ray.at(t);
            let rho = (p.x() * p.x() + p.z() * p.z()).sqrt();
            let mut theta = atan2(p.y(), rho - self.a);
            if theta < 0.0 {
                theta += 2.0 * std::f64::consts::PI;
            }
            t > SMALL_K_EPSILON && self.phi.contains(azimuth(p)) && self.theta.contains(theta)
        })
    }
}
