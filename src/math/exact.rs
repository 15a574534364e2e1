//! Products without rounding error, for thin triangles, where cancellation would destroy the
//! result.
//!
//! Source: Dekker, "A floating-point technique for extending the available precision" (1971).
//! Without fused multiply-add, which is a slow library call on processors that lack it.

use super::vectors::{Point, Vector};

/// `a·b` as an unevaluated sum of two numbers (exact unless it overflows or underflows).
pub fn two_product(a: f64, b: f64) -> (f64, f64) {
    let (a_high, a_low) = split(a);
    let (b_high, b_low) = split(b);
    let product = a * b;
    let error = ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low;
    (product, error)
}

/// Halves of 26 bits whose sum is `a`.
fn split(a: f64) -> (f64, f64) {
    let c = 134_217_729.0 * a; // 2^27 + 1
    let high = c - (c - a);
    (high, a - high)
}

/// `a + b` as an unevaluated sum of two numbers, exactly (Knuth).
pub fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let b_part = sum - a;
    (sum, (a - (sum - b_part)) + (b - b_part))
}

/// `a·b − c·d` with a relative error of a few u, however much cancels.
pub fn difference_of_products(a: f64, b: f64, c: f64, d: f64) -> f64 {
    let (ab, ab_error) = two_product(a, b);
    let (cd, cd_error) = two_product(c, d);
    let (difference, error) = two_sum(ab, -cd);
    difference + (error + (ab_error - cd_error))
}

/// `a − b·c`, with the scalar product of two lists, as if in twice the precision (Ogita, Rump &
/// Oishi, "Accurate Sum and Dot Product", 2005).
pub fn less_products(a: f64, b: [f64; 3], c: [f64; 3]) -> f64 {
    let less = |(sum, error): (f64, f64), (b, c): (f64, f64)| {
        let (product, lost) = two_product(-b, c);
        let (sum, lost_too) = two_sum(sum, product);
        (sum, error + (lost + lost_too))
    };
    let (sum, error) = b.into_iter().zip(c).fold((a, 0.0), less);
    sum + error
}

/// `(b − a) × (c − a)` correct to a few u in every component, for triangles of any aspect.
///
/// The rounded edges `e` differ from the true ones by `δ`, which `two_sum` gives exactly. The
/// product is `e₁ × e₂ + δ₁ × e₂ + e₁ × δ₂ + O(u²)`; its first term is computed without
/// cancellation error.
pub fn exact_cross(a: Point, b: Point, c: Point) -> Vector {
    let edge = |to: Point, axis: usize| two_sum(to.along(axis), -a.along(axis));
    let [e1, e2] = [b, c].map(|to| [edge(to, 0), edge(to, 1), edge(to, 2)]);
    let component = |i: usize, j: usize| {
        let ((p, dp), (q, dq)) = (e1[i], e1[j]);
        let ((r, dr), (s, ds)) = (e2[i], e2[j]);
        // the sum p·s − q·r in two parts, then the corrections of first order
        let (ps, ps_error) = two_product(p, s);
        let (qr, qr_error) = two_product(q, r);
        let (difference, error) = two_sum(ps, -qr);
        difference + (error + (ps_error - qr_error) + ((dp * s - dq * r) + (p * ds - q * dr)))
    };
    Vector::new(component(1, 2), component(2, 0), component(0, 1))
}
