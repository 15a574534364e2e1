//! Jittered samples (Suffern, ch. 4 and 5): one anywhere in each cell of a grid.

use super::{Sampler, in_stratum, next_square, side};
use crate::math::Pcg32;

/// The point `((k + ξ₁)/n, (j + ξ₂)/n)` in row `j` and column `k` of an `n × n` grid. A count that
/// is no square is rounded up to the next.
#[kind(Copy, PartialEq, Eq)]
pub struct Jittered {}

without_settings!(Jittered);

impl Sampler for Jittered {
    fn fill(&self, n: u32, random: &mut Pcg32) -> Vec<[f64; 2]> {
        let side = side(n);
        let mut jitter = |i: u32| in_stratum(i, side, random);
        (0..side * side).map(|i| [jitter(i % side), jitter(i / side)]).collect()
    }

    fn round_up(&self, n: u32) -> u32 {
        next_square(n)
    }
}
