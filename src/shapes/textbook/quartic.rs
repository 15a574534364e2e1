//! Cubics and quartics in radicals: Cardano's formula and Ferrari's, as ray tracers have used them
//! since Schwarze, "Cubic and Quartic Roots" (Graphics Gems, 1990).
//!
//! Written from the mathematics. What is compared here is the method: shift, resolvent, radicals,
//! and a test for zero that hardly ever succeeds. (The sample code's is `|x| < 1e-90`, which small
//! scenes would meet.)

use std::f64::consts::PI;

use crate::math::{acos, cbrt, cos};

/// The real roots of `x² + 2 p x + q`.
fn quadratic_roots(p: f64, q: f64) -> Vec<f64> {
    let d = p * p - q;
    if d == 0.0 {
        vec![-p]
    } else if d < 0.0 {
        Vec::new()
    } else {
        let root = d.sqrt();
        vec![root - p, -root - p]
    }
}

/// The real roots of `x³ + a x² + b x + c`, given as `[c, b, a]`. With `x = y − a/3` it is
/// `y³ + 3 p y + 2 q`, whose discriminant is `q² + p³`: three roots by an angle if it is negative
/// (the irreducible case), one by cube roots if it is positive.
pub fn cubic_roots([c, b, a]: [f64; 3]) -> Vec<f64> {
    let p = (b - a * a / 3.0) / 3.0;
    let q = (2.0 / 27.0 * a * a * a - a * b / 3.0 + c) / 2.0;
    let discriminant = q * q + p * p * p;
    let shift = a / 3.0;
    if discriminant == 0.0 {
        if q == 0.0 {
            return vec![-shift];
        }
        let u = cbrt(-q);
        return vec![2.0 * u - shift, -u - shift];
    }
    if discriminant < 0.0 {
        let phi = acos((-q / (-p * p * p).sqrt()).clamp(-1.0, 1.0)) / 3.0;
        let size = 2.0 * (-p).sqrt();
        let third = 2.0 * PI / 3.0;
        return [0.0, third, -third].map(|turn| size * cos(phi + turn) - shift).into();
    }
    let root = discriminant.sqrt();
    vec![cbrt(root - q) - cbrt(root + q) - shift]
}

/// The real roots of `c₄ x⁴ + c₃ x³ + c₂ x² + c₁ x + c₀`, given from `c₀` on; a double root may
/// stand there twice. With `x = y − c₃/(4 c₄)` it is `y⁴ + p y² + q y + r`, which for every root z
/// of the resolvent `z³ − p/2 z² − r z + (4 p r − q²)/8` is the difference of the squares of
/// `y² + z` and `v y − s u`, where `u² = z² − r`, `v² = 2 z − p` and s is the sign of q.
pub fn quartic_roots([c0, c1, c2, c3, c4]: [f64; 5]) -> Vec<f64> {
    let [a, b, c, d] = [c3 / c4, c2 / c4, c1 / c4, c0 / c4];
    let a2 = a * a;
    let p = b - 3.0 / 8.0 * a2;
    let q = a2 * a / 8.0 - a * b / 2.0 + c;
    let r = -3.0 / 256.0 * a2 * a2 + a2 * b / 16.0 - a * c / 4.0 + d;
    let shift = a / 4.0;
    let mut roots = if r == 0.0 {
        let mut roots = cubic_roots([q, p, 0.0]); // y (y³ + p y + q)
        roots.push(0.0);
        roots
    } else {
        let resolvent = cubic_roots([0.5 * r * p - q * q / 8.0, -r, -0.5 * p]);
        let z = resolvent[0];
        let (u2, v2) = (z * z - r, 2.0 * z - p);
        let [u, v] = [u2, v2].map(|x| x.sqrt());
        // the square of either may be negative by rounding alone: then the roots are lost
        if u.is_nan() || v.is_nan() {
            return Vec::new();
        }
        let s = if q < 0.0 { -1.0 } else { 1.0 };
        let mut roots = quadratic_roots(0.5 * v, z - s * u);
        roots.extend(quadratic_roots(-0.5 * v, z + s * u));
        roots
    };
    roots.iter_mut().for_each(|y| *y -= shift);
    roots
}
