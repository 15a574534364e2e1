//! The sphere. Its margins follow from two distances: to the ray, and to the ray's origin.

use super::{Beam, Found, Hit, quadratic};
use crate::{
    margin::Gate,
    real::{M, Real, V, nearest, real, sign},
};

/// `F(x) = (|x − c|² − r²)/2`, so `F_c = −(x − c)` and `F_r = −r`.
pub(super) fn sphere(c: &V, r: &Real, beam: &Beam) -> Found {
    let w = &beam.o - c;
    let (a, b) = (beam.d.dot(&beam.d), w.dot(&beam.d));
    let power = w.dot(&w) - r * r;
    let discriminant = &b * &b - &a * &power;
    let hits = quadratic(&a, &b, &power, &discriminant).into_iter().map(|t| {
        let gradient = &beam.at(&t) - c;
        let inputs = gradient.len() * c.len() + nearest(&(r * r));
        Hit::new(t, gradient, inputs, Some(M::identity()))
    });
    Found { hits: hits.collect(), margin: margin(c, r, &w, -b / a, beam) }
}

/// Inside, there is one root until the origin leaves. Outside, the answer changes if the distance of the
/// half-line from the centre crosses r, or if the origin enters.
///
/// The point at t moves by at most `(o_shift + t·d_shift)·ε`. To first order the nearest point of the
/// half-line decides; other points of the ray, which move more, add the second-order term.
fn margin(c: &V, r: &Real, w: &V, closest: Real, beam: &Beam) -> f64 {
    let own = c.len() + nearest(r);
    let start = Gate::new(&(w.norm() - r), beam.o_shift + own, 0.0).not_negative();
    if !start.holds {
        return start.margin;
    }
    let t = if sign(&closest).is_gt() { closest } else { real(0.0) };
    let distance = (&beam.at(&t) - c).norm();
    let drift = beam.d_shift / beam.d.len();
    let first = beam.o_shift + nearest(&t) * beam.d_shift + own;
    let second = 0.5 * drift * drift * nearest(&distance);
    let missed = Gate::new(&(distance - r), first, second).not_negative();
    if missed.holds { missed.margin } else { missed.margin.min(start.margin) }
}
