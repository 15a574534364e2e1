//! The triangle (Suffern, ch. 19): barycentric coordinates by Cramer's rule.

use super::Form;
use crate::math::{Point, Ray, Span};
use crate::shapes::Candidate;

/// The corners.
impl Form for [Point; 3] {
    /// `p = (1 − β − γ) v₀ + β v₁ + γ v₂`: the columns are `v₀ − v₁`, `v₀ − v₂` and `d`, the right
    /// side is `v₀ − o`.
    fn first(&self, ray: &Ray, span: Span) -> Option<Candidate> {
        let [v0, v1, v2] = *self;
        let [a, e, i] = (v0 - v1).to_array();
        let [b, f, j] = (v0 - v2).to_array();
        let [c, g, k] = ray.direction.to_array();
        let [d, h, l] = (v0 - ray.origin).to_array();

        let (m, n, p) = (f * k - g * j, h * k - g * l, f * l - h * j);
        let (q, s) = (g * i - e * k, e * j - f * i);
        let inv_denom = 1.0 / (a * m + b * q + c * s);

        let beta = (d * m - b * n - c * p) * inv_denom;
        if beta < 0.0 {
            return None;
        }
        let r = e * l - h * i;
        let gamma = (a * n + d * q + c * r) * inv_denom;
        if gamma < 0.0 || beta + gamma > 1.0 {
            return None;
        }
        let t = (a * p - b * r + d * s) * inv_denom;
        span.contains(t).then(|| Candidate { parameters: [beta, gamma], ..Candidate::at(t) })
    }
}
