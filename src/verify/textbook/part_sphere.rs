//! The part sphere (Suffern, ch. 19).

use super::{Angles, SMALL_K_EPSILON, Textbook, azimuth, sphere};
use crate::math::{Point, Ray, cos};

/// The part of a sphere at these azimuths and polar angles.
#[derive(Clone, Debug)]
pub struct PartSphere {
    /// The centre.
    pub center: Point,
    /// The radius.
    pub radius: f64,
    /// The azimuths, from +z towards +x.
    pub phi: Angles,
    /// The polar angles, from +y down, in `[0, π]`.
    pub theta: Angles,
}

impl Textbook for PartSphere {
    /// Both roots in order; `r cos θ_max ≤ y ≤ r cos θ_min`.
    fn hit(&self, ray: &Ray) -> Option<f64> {
        let (lowest, highest) =
            (self.radius * cos(self.theta.max), self.radius * cos(self.theta.min));
        sphere::roots(ray, self.center, self.radius)?.into_iter().find(|&t| {
            let from_center = Point::ORIGIN + (ray.at(t) - self.center);
            let y = from_center.y();
            t > SMALL_K_EPSILON
                && lowest <= y
                && y <= highest
                && self.phi.contains(azimuth(from_center))
        })
    }
}
