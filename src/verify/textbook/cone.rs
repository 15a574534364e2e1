//! The open cone about the y axis (Suffern, ch. 19).

use super::{SMALL_K_EPSILON, Textbook, schoolbook_roots};
use crate::math::Ray;

/// `(h/r)² (x² + z²) = (h − y)²` for `0 ≤ y ≤ h`: apex at `(0, h, 0)`, radius r at `y = 0`.
#[derive(Clone, Debug)]
pub struct OpenCone {
    /// The height.
    pub height: f64,
    /// The radius at the base.
    pub radius: f64,
}

impl Textbook for OpenCone {
    fn hit(&self, ray: &Ray) -> Option<f64> {
        let ([ox, oy, oz], [dx, dy, dz]) = (ray.origin.to_array(), ray.direction.to_array());
        let (h, k) = (self.height, self.height / self.radius);
        let k2 = k * k;
        let a = k2 * (dx * dx + dz * dz) - dy * dy;
        let b = 2.0 * (k2 * (ox * dx + oz * dz) + dy * (h - oy));
        let c = k2 * (ox * ox + oz * oz) - (h - oy) * (h - oy);
        let mut roots = schoolbook_roots(a, b, c)?;
        // a < 0 turns their order around
        roots.sort_by(f64::total_cmp);
        roots.into_iter().find(|&t| {
            let y = oy + t * dy;
            t > SMALL_K_EPSILON && 0.0 <= y && y <= h
        })
    }
}
