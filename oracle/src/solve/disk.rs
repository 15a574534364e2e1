//! The disk, and the rim that it shares with the cylinder.

use super::{Beam, Found, facing, flat, height};
use crate::{
    margin::{Verdict, smallest},
    real::{Real, V, nearest, real, sign},
};

/// The plane's hit, if it is inside the rim.
pub(super) fn disk(c: &V, n: &V, r: &Real, beam: &Beam) -> Found {
    let ahead = Verdict::same_sign(&[height(c, n, beam), facing(n, beam)]);
    let verdict = Verdict::all([rim(c, n, r, beam), ahead]);
    let hit = flat::plane_hit(c, n, beam).filter(|_| verdict.holds);
    Found { hits: hit.into_iter().collect(), margin: verdict.margin }
}

/// "The line of the ray meets the plane no farther than r from c."
///
/// With `w = o − c`, `D = n·d`: the hit relative to c is `q/D`, `q = n × (w × d)`, so the statement is
/// `|D| r − |q| ≥ 0`, or `v(u) = |D| r − q·u ≥ 0` for every unit `u` in the plane. Where `v(u)` is 0 the
/// ray passes the rim at `c ± r u`; there, differentiation gives
/// `first = |m × d|·(reach of o, c, t d and of r times n) + |D| r` with `m = u × n`, where
/// `|m × d|² = n² (u·d)² + D²`: flat rays towards the rim are the most sensitive. The weakest `u` is near
/// `q`, or along `d`, or between; it is searched among angles from `q` that double.
pub(super) fn rim(c: &V, n: &V, r: &Real, beam: &Beam) -> Verdict {
    let w = &beam.o - c;
    let slope = n.dot(&beam.d);
    let q = n.cross(&w.cross(&beam.d));
    let q_norm = q.norm();
    let (n_len, d_len, w_len, r_len) = (n.len(), beam.d.len(), w.len(), nearest(r));
    let steep = nearest(&slope).abs();
    let value_real = if sign(&slope).is_lt() { -&slope * r } else { &slope * r } - &q_norm;
    let holds = sign(&value_real).is_ge();
    let (value, q_len) = (nearest(&value_real), nearest(&q_norm));

    // u(Δ) = cosΔ u₀ + sinΔ u₁ with u₀ along q
    let u0 = q.unit().or_else(|| n.cross(&beam.d).unit()).or_else(|| n.cross(&axis(n)).unit());
    let u0 = u0.expect("the axis is not along n");
    let u1 = n.cross(&u0).unit().expect("u0 is perpendicular to n");
    let (d0, d1) = (nearest(&beam.d.dot(&u0)), nearest(&beam.d.dot(&u1)));

    let shift = beam.o_shift + c.len();
    let reach = shift + r_len + beam.d_shift / d_len * (w_len + r_len);
    let second = 2.0 * n_len * (beam.d_shift * (shift + w_len + r_len) + shift * d_len);
    let gate = |cos: f64, sin: f64, one_minus_cos: f64| {
        let v = value + q_len * one_minus_cos;
        let along = n_len * (d0 * cos + d1 * sin);
        let first = (along * along + steep * steep).sqrt() * reach + steep * r_len + 2.0 * v.abs();
        ((v >= 0.0) == holds).then(|| smallest(v.abs(), first, second))
    };
    let margin = directions(d0, d1).filter_map(|(cos, sin, rest)| gate(cos, sin, rest));
    let margin = if holds {
        margin.fold(f64::INFINITY, f64::min) // every u must stay
    } else {
        margin.fold(0.0, f64::max) // every failing u must change
    };
    Verdict { holds, margin }
}

/// Angles Δ as `(cosΔ, sinΔ, 1 − cosΔ)`: 0, ±2·atan 2ᵏ, and both directions along `(d0, d1)`.
fn directions(d0: f64, d1: f64) -> impl Iterator<Item = (f64, f64, f64)> {
    let halves = std::iter::successors(Some(1e-16_f64), |s| Some(2.0 * s)).take(75);
    let doubling = halves.flat_map(|s| [s, -s]).chain([0.0]).map(|s| {
        let square = 1.0 + s * s;
        ((1.0 - s * s) / square, 2.0 * s / square, 2.0 * s * s / square)
    });
    let length = (d0 * d0 + d1 * d1).sqrt();
    let along = [1.0, -1.0].into_iter().filter(move |_| length > 0.0).map(move |side| {
        let (cos, sin) = (side * d0 / length, side * d1 / length);
        let rest = if cos > 0.0 { sin * sin / (1.0 + cos) } else { 1.0 - cos };
        (cos, sin, rest)
    });
    doubling.chain(along)
}

/// The coordinate axis farthest from `n`.
fn axis(n: &V) -> V {
    let smallest = (0..3).min_by_key(|&i| n.0[i].clone() * &n.0[i]).unwrap_or(0);
    V(std::array::from_fn(|i| real(if i == smallest { 1.0 } else { 0.0 })))
}
