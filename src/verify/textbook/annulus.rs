//! The annulus, whole and in part (Suffern, ch. 19).

use super::{Angles, K_EPSILON, SMALL_K_EPSILON, Textbook, azimuth, plane};
use crate::math::{Point, Ray, Vector};

/// The part of a plane with `inner² < |p − center|² < outer²`.
#[derive(Clone, Debug)]
pub struct Annulus {
    /// The centre.
    pub center: Point,
    /// Of any length.
    pub normal: Vector,
    /// The radius of the hole.
    pub inner: f64,
    /// The radius of the whole.
    pub outer: f64,
}

impl Annulus {
    fn beyond(&self, ray: &Ray, epsilon: f64) -> Option<f64> {
        let t = plane::distance(ray, self.center, self.normal);
        if t <= epsilon {
            return None;
        }
        let squared = self.center.distance_squared(ray.at(t));
        let (inner, outer) = (self.inner * self.inner, self.outer * self.outer);
        (inner < squared && squared < outer).then_some(t)
    }
}

impl Textbook for Annulus {
    fn hit(&self, ray: &Ray) -> Option<f64> {
        self.beyond(ray, K_EPSILON)
    }
}

/// The part of a horizontal annulus at these azimuths, which are measured about its centre.
#[derive(Clone, Debug)]
pub struct PartAnnulus {
    /// The whole; its normal is along y.
    pub whole: Annulus,
    /// The azimuths, from +z towards +x.
    pub phi: Angles,
}

impl Textbook for PartAnnulus {
    fn hit(&self, ray: &Ray) -> Option<f64> {
        let t = self.whole.beyond(ray, SMALL_K_EPSILON)?;
        let from_center = Point::ORIGIN + (ray.at(t) - self.whole.center);
        self.phi.contains(azimuth(from_center)).then_some(t)
    }
}
