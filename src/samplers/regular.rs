//! Regular samples (Suffern, ch. 4 and 5): the centres of a grid.

use super::{Sampler, next_square, side};
use crate::math::Pcg32;

/// The point `((k + ½)/n, (j + ½)/n)` in row `j` and column `k` of an `n × n` grid. A count that is
/// no square is rounded up to the next.
#[kind(Copy, PartialEq, Eq)]
pub struct Regular {}

without_settings!(Regular);

impl Sampler for Regular {
    fn fill(&self, n: u32, _: &mut Pcg32) -> Vec<[f64; 2]> {
        let side = side(n);
        let center = |i: u32| (f64::from(i) + 0.5) / f64::from(side);
        (0..side * side).map(|i| [center(i % side), center(i / side)]).collect()
    }

    fn round_up(&self, n: u32) -> u32 {
        next_square(n)
    }
}
