//! The open cylinder about the y axis (Suffern, ch. 19).

use super::{Form, first_on, schoolbook_roots};
use crate::math::{Ray, Span};
use crate::shapes::{Candidate, OpenCylinder};

/// `a = dx² + dz²`, `b = 2 (ox dx + oz dz)`, `c = ox² + oz² − r²`.
pub(super) fn roots(ray: &Ray, radius: f64) -> Option<[f64; 2]> {
    let ([ox, _, oz], [dx, _, dz]) = (ray.origin.to_array(), ray.direction.to_array());
    let a = dx * dx + dz * dz;
    let b = 2.0 * (ox * dx + oz * dz);
    let c = ox * ox + oz * oz - radius * radius;
    schoolbook_roots(a, b, c)
}

impl Form for OpenCylinder {
    /// `x² + z² = radius²` for `y0 < y < y1`.
    fn first(&self, ray: &Ray, span: Span) -> Option<Candidate> {
        first_on(roots(ray, self.radius)?, span, |t| {
            let y = ray.origin.y() + t * ray.direction.y();
            self.y0 < y && y < self.y1
        })
    }
}
