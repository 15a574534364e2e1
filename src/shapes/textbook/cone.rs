//! The open cone about the y axis (Suffern, ch. 19).

use super::{Form, first_on, schoolbook_roots};
use crate::math::{Ray, Span};
use crate::shapes::{Candidate, Cone};

impl Form for Cone {
    /// `(h/r)² (x² + z²) = (h − y)²` for `0 ≤ y ≤ h`.
    fn first(&self, ray: &Ray, span: Span) -> Option<Candidate> {
        let ([ox, oy, oz], [dx, dy, dz]) = (ray.origin.to_array(), ray.direction.to_array());
        let (h, k) = (self.height, self.height / self.radius);
        let k2 = k * k;
        let a = k2 * (dx * dx + dz * dz) - dy * dy;
        let b = 2.0 * (k2 * (ox * dx + oz * dz) + dy * (h - oy));
        let c = k2 * (ox * ox + oz * oz) - (h - oy) * (h - oy);
        let mut roots = schoolbook_roots(a, b, c)?;
        // a < 0 turns their order around
        roots.sort_by(f64::total_cmp);
        first_on(roots, span, |t| (0.0..=h).contains(&(oy + t * dy)))
    }
}
