//! The smallest change of the inputs that can change an exact answer.
//!
//! An answer depends on signs. A [`Gate`] is one sign with a bound on how much a relative change of the
//! inputs by ε changes its value: `|Δ| ≤ first·ε + second·ε²`. A [`Verdict`] is a statement composed of
//! such signs, with a lower bound of the ε that makes it false (if it holds) or true (if not).

use std::cmp::Ordering;

use crate::real::{Real, magnitude, sign};

/// A value whose sign matters.
#[derive(Clone, Debug)]
pub(crate) struct Gate {
    sign: Ordering,
    margin: f64,
}

impl Gate {
    pub(crate) fn new(value: &Real, first: f64, second: f64) -> Gate {
        Gate { sign: sign(value), margin: smallest(magnitude(value), first, second) }
    }

    /// "The value is not negative."
    pub(crate) fn not_negative(&self) -> Verdict {
        Verdict { holds: self.sign.is_ge(), margin: self.margin }
    }

    /// "The value is not positive."
    pub(crate) fn not_positive(&self) -> Verdict {
        Verdict { holds: self.sign.is_le(), margin: self.margin }
    }

    /// "The value is not negative", or if `up` is false, "not positive".
    pub(crate) fn has_sign(&self, up: bool) -> Verdict {
        if up { self.not_negative() } else { self.not_positive() }
    }
}

/// The positive solution of `first·ε + second·ε² = value`, without cancellation.
pub(crate) fn smallest(value: f64, first: f64, second: f64) -> f64 {
    if value == 0.0 {
        return 0.0;
    }
    2.0 * value / (first + (first * first + 4.0 * second * value).sqrt())
}

/// A statement, and the relative change of the inputs below which it stays as it is.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Verdict {
    pub(crate) holds: bool,
    pub(crate) margin: f64,
}

impl Verdict {
    pub(crate) fn not(self) -> Verdict {
        Verdict { holds: !self.holds, ..self }
    }

    /// All parts hold. The weakest part breaks this; if it does not hold, every failing part must change.
    pub(crate) fn all(parts: impl IntoIterator<Item = Verdict>) -> Verdict {
        let (mut weakest, mut mended, mut holds) = (f64::INFINITY, 0.0_f64, true);
        for part in parts {
            if part.holds {
                weakest = weakest.min(part.margin);
            } else {
                (holds, mended) = (false, mended.max(part.margin));
            }
        }
        Verdict { holds, margin: if holds { weakest } else { mended } }
    }

    /// At least one part holds.
    pub(crate) fn any(parts: impl IntoIterator<Item = Verdict>) -> Verdict {
        Verdict::all(parts.into_iter().map(Verdict::not)).not()
    }

    /// "All gates have the same sign" (0 counts as either).
    pub(crate) fn same_sign(gates: &[Gate]) -> Verdict {
        Verdict::any([
            Verdict::all(gates.iter().map(Gate::not_negative)),
            Verdict::all(gates.iter().map(Gate::not_positive)),
        ])
    }
}
