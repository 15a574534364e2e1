//! The relative change that makes a ray pass through a border: a piece of a line or of a circle.

use super::Beam;
use crate::real::{Real, V, nearest, real, sign};

/// The points `center + p cos a + q sin a`, or of a line `center + p + s q`.
pub(super) struct Curve {
    center: V,
    p: V,
    q: V,
    round: bool,
    /// The parameters of the ends: 0 to 1 on a line, the scale of [`quarters`] on a circle.
    ends: [f64; 2],
    /// A relative change of the shape by ε moves a point by at most `reach·ε`.
    reach: f64,
}

/// The tangent of half of an eighth of a turn: `√2 − 1`.
const TANGENT: f64 = 0.414_213_562_373_095_05;

/// An angle, given by its sine and cosine, on a scale from −2 to 2 on which 1 is a quarter of a turn;
/// between whole numbers the scale is only nearly uniform.
pub(super) fn quarters(s: f64, c: f64) -> f64 {
    let scale = |s: f64, c: f64| s / (1.0 + c) / (2.0 * TANGENT); // tan of the half
    match (s, c) {
        _ if c >= s.abs() => scale(s, c),
        _ if s >= c.abs() => 1.0 + scale(-c, s),
        _ if -s >= c.abs() => -1.0 + scale(c, -s),
        _ if s >= 0.0 => 2.0 + scale(-s, -c),
        _ => -2.0 + scale(-s, -c),
    }
}

/// `(sin, cos)` of a value on that scale, normalised to the last bit.
fn on_circle(param: f64) -> (Real, Real) {
    let quarter = param.round();
    let (s, c) = turn(&real((param - quarter) * 2.0 * TANGENT));
    match quarter.rem_euclid(4.0) as u8 {
        0 => (s, c),
        1 => (c, -s),
        2 => (-s, -c),
        _ => (-c, s),
    }
}

/// `(sin, cos)` of the angle whose half has this tangent.
fn turn(m: &Real) -> (Real, Real) {
    let square = m * m;
    let whole = real(1.0) + &square;
    ((real(2.0) * m) / &whole, (real(1.0) - square) / whole)
}

impl Curve {
    pub(super) fn line(from: &V, to: &V, reach: f64) -> Curve {
        let zero = V([(); 3].map(|()| real(0.0)));
        let q = to - from;
        Curve { center: zero, p: from.clone(), q, round: false, ends: [0.0, 1.0], reach }
    }

    /// The part of the circle between two parameters; slightly longer, because the ends are rounded.
    pub(super) fn arc(center: &V, [p, q]: [&V; 2], [from, to]: [f64; 2], reach: f64) -> Curve {
        let ends = [from - 1e-12, to + 1e-12];
        Curve { center: center.clone(), p: p.clone(), q: q.clone(), round: true, ends, reach }
    }

    pub(super) fn circle(center: &V, axes: [&V; 2], reach: f64) -> Curve {
        Curve::arc(center, axes, [-2.0, 2.0], reach)
    }

    /// The point relative to the centre, and its derivative.
    fn at(&self, param: f64) -> [V; 2] {
        if !self.round {
            return [&self.p + &(&self.q * &real(param)), self.q.clone()];
        }
        let (s, c) = on_circle(param);
        [&(&self.p * &c) + &(&self.q * &s), &(&self.q * &c) - &(&self.p * &s)]
    }
}

/// The least relative change of all inputs that makes the ray pass through the curve: the minimum, over
/// the points of the curve and of the ray, of their distance divided by how far both move. It is found
/// approximately first, then by the Gauss–Newton method with full precision.
pub(super) fn approach(curve: &Curve, beam: &Beam) -> f64 {
    let rough = Rough::new(curve, beam);
    let [from, to] = curve.ends;
    let steps = if curve.round { 12.0 * (to - from).ceil() } else { 4.0 };
    let param = |i: f64| from + (to - from) * i / steps;
    let mut best = f64::INFINITY;
    let values: Vec<f64> = (0..=steps as usize).map(|i| rough.least(param(i as f64)).0).collect();
    for i in 0..values.len() {
        let before = i.checked_sub(1).map_or(f64::INFINITY, |j| values[j]);
        let after = values.get(i + 1).copied().unwrap_or(f64::INFINITY);
        if values[i] > before || values[i] > after {
            continue;
        }
        let around = [i as f64 - 1.0, i as f64 + 1.0].map(|i| param(i.clamp(0.0, steps)));
        let found = rough.search(around);
        let (value, t) = rough.least(found);
        best = best.min(if value < 1e-3 { exact(curve, beam, found, t) } else { value });
    }
    // steps may be too coarse to separate two minima; the decisive one is where the ray crosses the plane
    if let Some((param, t)) = crossing(curve, beam) {
        best = best.min(exact(curve, beam, param, t));
    }
    if best < NOTHING { 0.0 } else { best }
}

/// The parameter on a circle nearest to where the ray crosses its plane, and the `t` of the crossing.
fn crossing(curve: &Curve, beam: &Beam) -> Option<(f64, f64)> {
    let normal = curve.p.cross(&curve.q);
    let slope = normal.dot(&beam.d);
    if !curve.round || sign(&slope).is_eq() {
        return None;
    }
    let t = (&curve.center - &beam.o).dot(&normal) / slope;
    let off = &beam.at(&t) - &curve.center;
    let (s, c) = (curve.q.dot(&off), curve.p.dot(&off));
    let length = (&s * &s + &c * &c).sqrt();
    if sign(&t).is_lt() || sign(&length).is_eq() {
        return None;
    }
    let param = quarters(nearest(&(s / &length)), nearest(&(c / &length)));
    let param = if param < curve.ends[0] { param + 4.0 } else { param };
    (param <= curve.ends[1]).then(|| (param, nearest(&t)))
}

/// Smaller results are rounding errors of 512 bits: the ray passes through the border exactly.
const NOTHING: f64 = 1e-120;

/// The curve and the ray in `f64`.
struct Rough {
    /// From the ray's origin to the centre, and the two axes.
    center: [f64; 3],
    p: [f64; 3],
    q: [f64; 3],
    d: [f64; 3],
    round: bool,
    own: f64,
    d_shift: f64,
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

impl Rough {
    fn new(curve: &Curve, beam: &Beam) -> Rough {
        let v = |v: &V| v.0.each_ref().map(nearest);
        Rough {
            center: v(&(&curve.center - &beam.o)),
            p: v(&curve.p),
            q: v(&curve.q),
            d: v(&beam.d),
            round: curve.round,
            own: beam.o_shift + curve.reach,
            d_shift: beam.d_shift,
        }
    }

    /// At this parameter of the curve: the least ratio of distance to movement, and the ray's `t` there.
    fn least(&self, param: f64) -> (f64, f64) {
        let (s, c) = if self.round {
            let (s, c) = on_circle_rough(param);
            (s, c)
        } else {
            (param, 1.0)
        };
        let w: [f64; 3] =
            std::array::from_fn(|i| -(self.center[i] + c * self.p[i] + s * self.q[i]));
        let (wd, dd, ww) = (dot(w, self.d), dot(self.d, self.d), dot(w, w));
        let down = self.own * dd - self.d_shift * wd;
        let t = (self.d_shift * ww - self.own * wd) / down;
        let t = if down > 0.0 { t.max(0.0) } else { 0.0 };
        let off: [f64; 3] = std::array::from_fn(|i| w[i] + t * self.d[i]);
        (dot(off, off).sqrt() / (self.own + t * self.d_shift), t)
    }

    /// Golden-section search for the minimum of [`Rough::least`].
    fn search(&self, [mut low, mut high]: [f64; 2]) -> f64 {
        const GOLDEN: f64 = 0.618_033_988_749_894_8;
        let inner = |low: f64, high: f64| {
            let step = GOLDEN * (high - low);
            [high - step, low + step]
        };
        let [mut a, mut b] = inner(low, high);
        let (mut at_a, mut at_b) = (self.least(a).0, self.least(b).0);
        for _ in 0..60 {
            if at_a < at_b {
                (high, b, at_b) = (b, a, at_a);
                a = inner(low, high)[0];
                at_a = self.least(a).0;
            } else {
                (low, a, at_a) = (a, b, at_b);
                b = inner(low, high)[1];
                at_b = self.least(b).0;
            }
        }
        if at_a < at_b { a } else { b }
    }
}

fn on_circle_rough(param: f64) -> (f64, f64) {
    let quarter = param.round();
    let m = (param - quarter) * 2.0 * TANGENT;
    let (s, c) = (2.0 * m / (1.0 + m * m), (1.0 - m * m) / (1.0 + m * m));
    match quarter.rem_euclid(4.0) as u8 {
        0 => (s, c),
        1 => (c, -s),
        2 => (-s, -c),
        _ => (-c, s),
    }
}

/// Descends from a parameter and a `t` near the minimum. A step may slightly leave the curve, which only
/// reduces the margin; a step that would leave the ray ends at its origin.
fn exact(curve: &Curve, beam: &Beam, param: f64, t: f64) -> f64 {
    let [mut along, mut tangent] = curve.at(param);
    let mut t = real(t);
    let ratio = |along: &V, t: &Real| {
        let w = &beam.at(t) - &(&curve.center + along);
        let reach = beam.o_shift + nearest(t) * beam.d_shift + curve.reach;
        (nearest(&w.norm()) / reach, w)
    };
    let (mut best, mut w) = ratio(&along, &t);
    for _ in 0..6 {
        // minimise |w + δt d − δs tangent|
        let (dd, ss, ds) = (beam.d.dot(&beam.d), tangent.dot(&tangent), beam.d.dot(&tangent));
        let (wd, ws) = (w.dot(&beam.d), w.dot(&tangent));
        let determinant = &dd * &ss - &ds * &ds;
        if sign(&determinant).is_eq() {
            break;
        }
        let mut dt = (&ds * &ws - &ss * &wd) / &determinant;
        let mut step = (&dd * &ws - &ds * &wd) / &determinant;
        if sign(&(&t + &dt)).is_lt() {
            dt = -t.clone();
            step = &ws / &ss;
        }
        let moved = if curve.round {
            let (s, c) = turn(&(step / real(2.0)));
            [&(&along * &c) + &(&tangent * &s), &(&tangent * &c) - &(&along * &s)]
        } else {
            [&along + &(&tangent * &step), tangent.clone()]
        };
        let there = &t + dt;
        let (value, off) = ratio(&moved[0], &there);
        if value >= best {
            break;
        }
        ([along, tangent], t, best, w) = (moved, there, value, off);
    }
    best
}
