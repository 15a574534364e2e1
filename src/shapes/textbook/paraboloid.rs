//! The paraboloid about the y axis, solved as the book solves its cone (Suffern, ch. 19).

use super::{Form, first_on, schoolbook_roots};
use crate::math::{Ray, Span};
use crate::shapes::{Candidate, Paraboloid};

impl Form for Paraboloid {
    /// `(h/r²) (x² + z²) = y` for `y ≤ h`.
    fn first(&self, ray: &Ray, span: Span) -> Option<Candidate> {
        let ([ox, oy, oz], [dx, dy, dz]) = (ray.origin.to_array(), ray.direction.to_array());
        let k = self.height / (self.radius * self.radius);
        let a = k * (dx * dx + dz * dz);
        let b = 2.0 * k * (ox * dx + oz * dz) - dy;
        let c = k * (ox * ox + oz * oz) - oy;
        first_on(schoolbook_roots(a, b, c)?, span, |t| oy + t * dy <= self.height)
    }
}
