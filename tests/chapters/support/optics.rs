//! Integrals and formulas of optics, computed differently from the library.

use std::f64::consts::FRAC_PI_2;

use groundtruth::math::{ln, ln_1p};

use crate::prelude::*;

/// The reflected share by sums and differences of the angles, for light from the rarer side (`eta > 1`)
/// whose angle has this sine: `½ (sin²(i − t)/sin²(i + t) + tan²(i − t)/tan²(i + t))`.
pub fn by_angles(sine: f64, eta: f64) -> f64 {
    if sine < 1e-8 {
        let r = (eta - 1.0) / (eta + 1.0);
        return r * r;
    }
    let angle = |sine: f64| FRAC_PI_2 - acos(sine.min(1.0));
    let (i, t) = (angle(sine), angle(sine / eta));
    let s = sin(i - t) / sin(i + t);
    let p = tan(i - t) / tan(i + t);
    0.5 * (s * s + p * p)
}

/// Nodes in `[−1, 1]` and weights of the Gauss–Legendre rule of so many points: roots of the
/// Legendre polynomial by Newton's method, from its recurrence.
fn gauss_legendre(n: u32) -> Vec<(f64, f64)> {
    let legendre = |x: f64| {
        let (mut before, mut p) = (1.0, x);
        for k in 1..n {
            let k = f64::from(k);
            (before, p) = (p, ((2.0 * k + 1.0) * x * p - k * before) / (k + 1.0));
        }
        (p, f64::from(n) * (x * p - before) / (x * x - 1.0))
    };
    let node = |i: u32| {
        let mut x = cos(PI * (f64::from(i) + 0.75) / (f64::from(n) + 0.5));
        for _ in 0..6 {
            let (p, slope) = legendre(x);
            x -= p / slope;
        }
        let (_, slope) = legendre(x);
        (x, 2.0 / ((1.0 - x * x) * slope * slope))
    };
    (0..n).map(node).collect()
}

/// The integral of `f` from `a` to `b`.
fn integral(rule: &[(f64, f64)], [a, b]: [f64; 2], f: impl Fn(f64) -> f64) -> f64 {
    let (middle, half) = (0.5 * (a + b), 0.5 * (b - a));
    half * rule.iter().map(|(x, weight)| weight * f(middle + half * x)).sum::<f64>()
}

/// `∫ cosᵉα max(0, cosθ_i) dω` about the mirror direction, which is `α_h` above the horizon,
/// `sin α_h = cos_o`: rings `α`, and of each the arc `|φ| ≤ φ_h` above the horizon, over which
/// `cosθ_i = cosα cosθ_o + sinα sinθ_o cosφ` is integrated separately. The panels grow by factors of two from
/// the width of the lobe, from `α_h` and from the end. Beyond `α_h` the arc shrinks like a square root, so
/// the variable there is `√(α − α_h)`.
pub fn albedo_about_the_mirror_direction(e: f64, cos_o: f64) -> f64 {
    let rule = gauss_legendre(24);
    let sin_o = ((1.0 - cos_o) * (1.0 + cos_o)).sqrt();
    let horizon = atan2(cos_o, sin_o);
    let ring = |alpha: f64, beyond: f64| {
        let (along, across) = (cos(alpha) * cos_o, sin(alpha) * sin_o);
        // beyond the horizon by so much: 1 − cos(π − φ_h) = sin(beyond)/(sinα sinθ_o)
        let short = (sin(beyond) / across).clamp(0.0, 2.0);
        let arc = if beyond > 0.0 { PI - acos_of_one_minus(short) } else { PI };
        let whole = 2.0 * integral(&rule, [0.0, arc], |phi| along + across * cos(phi));
        // cosᵉα by the logarithm: a large exponent multiplies the rounding of a cosine near 1
        let log = if alpha > 1.0 { ln(cos(alpha)) } else { 0.5 * ln_1p(-sin(alpha) * sin(alpha)) };
        exp(e * log) * sin(alpha) * whole
    };
    let mut edges = vec![0.0, horizon, FRAC_PI_2];
    for scale in [1.0 / (e + 2.0).sqrt(), horizon] {
        let powers = (-3..64).map(|k| scale * exp(f64::from(k) * std::f64::consts::LN_2));
        edges.extend(powers.filter(|edge| *edge < FRAC_PI_2));
    }
    // `cosᵉα` of a small exponent has an infinite slope at its end
    edges.extend((1..30).map(|k| FRAC_PI_2 - exp(-f64::from(k) * std::f64::consts::LN_2)));
    edges.sort_by(f64::total_cmp);
    edges.dedup_by(|a, b| *a - *b < 1e-9 * *b);
    let panel = |pair: &[f64]| {
        let [a, b] = [pair[0], pair[1]];
        if 0.5 * (a + b) < horizon {
            return integral(&rule, [a, b], |alpha| ring(alpha, 0.0));
        }
        let part = |s: f64| 2.0 * s * ring(horizon + s * s, s * s);
        integral(&rule, [(a - horizon).max(0.0).sqrt(), (b - horizon).sqrt()], part)
    };
    edges.windows(2).map(panel).sum()
}

/// `acos(1 − x)`, without the cancellation for small x.
pub fn acos_of_one_minus(x: f64) -> f64 {
    2.0 * atan2(x.sqrt(), (2.0 - x).sqrt())
}
