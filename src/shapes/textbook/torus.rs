//! The torus about the y axis (Suffern, ch. 19): a quartic.

use super::{cuboid, quartic_roots};
use crate::math::{Point, Ray, Span};

/// The roots of `(|p|² − a² − b²)² = 4 a² (b² − y²)`, ascending: after a test of the bounding box,
/// with `e = o·o − a² − b²`, `g = o·d`, `D = d·d`,
/// `D² t⁴ + 4 D g t³ + (2 D e + 4 g² + 4 a² dy²) t² + (4 g e + 8 a² oy dy) t`
/// `+ e² − 4 a² (b² − oy²)`.
pub fn torus_roots(ray: &Ray, a: f64, b: f64, span: Span) -> Vec<f64> {
    let corner = Point::new(a + b, b, a + b);
    let (t0, t1) = cuboid::slabs(ray, corner.scaled(-1.0), corner);
    if !(t0 < t1 && t1 > span.min) {
        return Vec::new();
    }
    let (o, d) = (ray.origin.to_vector(), ray.direction);
    let (oy, dy) = (o.y(), d.y());
    let four_a2 = 4.0 * a * a;
    let e = o.dot(o) - a * a - b * b;
    let (g, dd) = (o.dot(d), d.dot(d));
    let c4 = dd * dd;
    let c3 = 4.0 * dd * g;
    let c2 = 2.0 * dd * e + 4.0 * g * g + four_a2 * dy * dy;
    let c1 = 4.0 * g * e + 2.0 * four_a2 * oy * dy;
    let c0 = e * e - four_a2 * (b * b - oy * oy);
    let mut roots = quartic_roots([c0, c1, c2, c3, c4]);
    roots.sort_by(f64::total_cmp);
    roots
}
