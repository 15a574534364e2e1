//! The paraboloid about the y axis, solved as the book solves its cone (Suffern, ch. 19).

use super::{SMALL_K_EPSILON, Textbook, schoolbook_roots};
use crate::math::Ray;

/// `(h/r²) (x² + z²) = y` for `y ≤ h`: vertex in the origin, radius r at the height h.
#[derive(Clone, Debug)]
pub struct Paraboloid {
    /// The height.
    pub height: f64,
    /// The radius of the rim.
    pub radius: f64,
}

impl Textbook for Paraboloid {
    fn hit(&self, ray: &Ray) -> Option<f64> {
        let ([ox, oy, oz], [dx, dy, dz]) = (ray.origin.to_array(), ray.direction.to_array());
        let k = self.height / (self.radius * self.radius);
        let a = k * (dx * dx + dz * dz);
        let b = 2.0 * k * (ox * dx + oz * dz) - dy;
        let c = k * (ox * ox + oz * oz) - oy;
        schoolbook_roots(a, b, c)?
            .into_iter()
            .find(|&t| t > SMALL_K_EPSILON && oy + t * dy <= self.height)
    }
}
