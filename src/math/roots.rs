//! Real roots of quadratics, without the cancellations of the textbook formula.

use super::vectors::Vector;

/// The roots of `a t² + 2 b t + c`, in ascending order, given `discriminant = b² − a c` however it
/// was computed. `None` if it is negative or NaN, or if a and b are 0 and c is not. For `a = 0` one
/// root is infinite or NaN, which no span contains.
pub fn quadratic(a: f64, b: f64, c: f64, discriminant: f64) -> Option<[f64; 2]> {
    if discriminant.is_nan() || discriminant < 0.0 {
        return None;
    }
    // root away from −b first: no cancellation when b² ≫ a c
    let q = -(b + discriminant.sqrt().copysign(b));
    if q == 0.0 {
        return (c == 0.0).then_some([0.0; 2]);
    }
    if b == 0.0 {
        let root = (q / a).abs(); // and the sign of that zero does not matter
        return Some([-root, root]);
    }
    let (first, second) = (q / a, c / q);
    Some(if first <= second { [first, second] } else { [second, first] })
}

/// Where `|f + t·d| = r`, in ascending order: a sphere about the origin, or with a zero component
/// in both vectors a cylinder about that axis.
///
/// The discriminant comes from the part of `f` perpendicular to `d`, `a (r² − |l|²)`, instead of
/// `b² − a c`, which cancels for far, small and huge spheres (Haines et al., "Precision
/// Improvements for Ray/Sphere Intersection", Ray Tracing Gems, ch. 7).
pub fn perpendicular_roots(f: Vector, d: Vector, r: f64) -> Option<[f64; 2]> {
    let a = d.length_squared();
    let b = f.dot(d);
    let l = f - (b / a) * d;
    let discriminant = a * ((r - l.length()) * (r + l.length()));
    // (|f| − r)(|f| + r) keeps its digits where |f|² − r² loses them
    let length = f.length();
    let c = (length - r) * (length + r);
    quadratic(a, b, c, discriminant)
}
