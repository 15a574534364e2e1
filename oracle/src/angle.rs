//! Sine and cosine of degrees, and ranges of azimuths.

use std::sync::OnceLock;

use crate::{
    margin::{Gate, Verdict},
    real::{Real, V, magnitude, nearest, real, sign},
};

/// `(sin, cos)` of an angle in degrees. Quarter turns are subtracted exactly; the Taylor series of the
/// rest ends when its terms are negligible.
pub(crate) fn sin_cos(degrees: &Real) -> (Real, Real) {
    let quarter = (nearest(degrees) / 90.0).round();
    let rest = degrees - real(90.0) * real(quarter);
    let x = rest * degree();
    let square = &x * &x;
    let series = |first: Real, start: f64| {
        let (mut sum, mut term, mut n) = (first.clone(), first, start);
        while magnitude(&term) > 1e-165 {
            term = -(term * &square) / real((n + 1.0) * (n + 2.0));
            n += 2.0;
            sum += &term;
        }
        sum
    };
    let (s, c) = (series(x.clone(), 1.0), series(real(1.0), 0.0));
    match quarter.rem_euclid(4.0) as u8 {
        0 => (s, c),
        1 => (c, -s),
        2 => (-s, -c),
        _ => (-c, s),
    }
}

/// π/180, with π = 16 atan(1/5) − 4 atan(1/239) (Machin, 1706).
pub(crate) fn degree() -> &'static Real {
    static DEGREE: OnceLock<Real> = OnceLock::new();
    DEGREE.get_or_init(|| {
        let atan_of_inverse = |n: f64| {
            let (mut sum, mut power, mut k) = (real(0.0), real(1.0) / real(n), 1.0);
            while magnitude(&power) > 1e-165 {
                sum += &power / real(k);
                power = -power / real(n * n);
                k += 2.0;
            }
            sum
        };
        (real(16.0) * atan_of_inverse(5.0) - real(4.0) * atan_of_inverse(239.0)) / real(180.0)
    })
}

/// The azimuths from `phi[0]` up to `phi[1]` degrees, through 360 if the first is larger;
/// `x = ρ sin φ` and `z = ρ cos φ`.
pub(crate) struct Wedge {
    /// `(sin φ, 0, cos φ)` of the ends.
    pub(crate) ends: [V; 2],
    /// The angle in radians by which a relative change of 1 turns each end: `|φ|`.
    pub(crate) turns: [f64; 2],
    wide: bool,
    pub(crate) all: bool,
    /// The smallest relative change that makes the range empty or a full turn.
    pub(crate) order: f64,
}

impl Wedge {
    pub(crate) fn new(phi: &[Real; 2]) -> Wedge {
        let end = |phi: &Real| {
            let (s, c) = sin_cos(phi);
            V([s, real(0.0), c])
        };
        let mut width = &phi[1] - &phi[0];
        while sign(&width).is_lt() {
            width += real(360.0);
        }
        let all = width >= real(360.0);
        let near = magnitude(&width).min(magnitude(&(real(360.0) - &width)));
        let moves = magnitude(&phi[0]) + magnitude(&phi[1]);
        Wedge {
            ends: phi.each_ref().map(end),
            turns: phi.each_ref().map(|phi| magnitude(&(phi * degree()))),
            wide: width > real(180.0),
            all,
            order: if all { f64::INFINITY } else { near / moves },
        }
    }

    /// The distances of a point from the planes of both ends, positive on the side of the range.
    pub(crate) fn sides(&self, p: &V) -> [Real; 2] {
        let [x, _, z] = &p.0;
        let [a, b] = &self.ends;
        [x * &a.0[2] - z * &a.0[0], z * &b.0[0] - x * &b.0[2]]
    }

    /// Whether the range contains the point, which moves by at most `reach·ε`.
    pub(crate) fn holds(&self, p: &V, reach: f64) -> Verdict {
        if self.all {
            return Verdict { holds: true, margin: f64::INFINITY };
        }
        let sides = self.sides(p);
        let size = p.len();
        let gate = |i: usize| {
            let (turn, value): (f64, &Real) = (self.turns[i], &sides[i]);
            Gate::new(value, reach + turn * size, turn * (reach + turn * size)).not_negative()
        };
        let sides = [gate(0), gate(1)];
        if self.wide { Verdict::any(sides) } else { Verdict::all(sides) }
    }
}
