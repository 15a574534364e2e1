//! The open cylinder about the y axis (Suffern, ch. 19).

use super::{K_EPSILON, Textbook, schoolbook_roots};
use crate::math::Ray;

/// `x² + z² = radius²` for `y0 < y < y1`.
#[derive(Clone, Debug)]
pub struct OpenCylinder {
    /// The lower end.
    pub y0: f64,
    /// The upper end.
    pub y1: f64,
    /// The radius.
    pub radius: f64,
}

/// `a = dx² + dz²`, `b = 2 (ox dx + oz dz)`, `c = ox² + oz² − r²`.
pub(super) fn roots(ray: &Ray, radius: f64) -> Option<[f64; 2]> {
    let ([ox, _, oz], [dx, _, dz]) = (ray.origin.to_array(), ray.direction.to_array());
    let a = dx * dx + dz * dz;
    let b = 2.0 * (ox * dx + oz * dz);
    let c = ox * ox + oz * oz - radius * radius;
    schoolbook_roots(a, b, c)
}

impl Textbook for OpenCylinder {
    fn hit(&self, ray: &Ray) -> Option<f64> {
        roots(ray, self.radius)?.into_iter().find(|&t| {
            let y = ray.origin.y() + t * ray.direction.y();
            t > K_EPSILON && self.y0 < y && y < self.y1
        })
    }
}
