//! Scrambled Sobol samples (Burley, "Practical Hash-based Owen Scrambling", Journal of Computer
//! Graphics Techniques 9(4), 2020); not in the book.

use super::{Sampler, in_stratum};
use crate::math::{Pcg32, splitmix};

/// The first n points of Sobol's sequence (1967) in two dimensions, each set with its own Owen
/// scramble ("Randomly Permuted (t,m,s)-Nets", 1995). Any count; best are powers of two `n = 2^m`:
/// then each of the n boxes `2^−a × 2^(a−m)` has one point, whatever the scramble.
#[kind(Copy, PartialEq, Eq)]
pub struct Sobol {}

without_settings!(Sobol);

impl Sampler for Sobol {
    fn fill(&self, n: u32, random: &mut Pcg32) -> Vec<[f64; 2]> {
        // n points differ in this many binary digits in each dimension
        let digits = n.next_power_of_two().ilog2();
        let mut seed = || u64::from(random.next_u32()) << 32 | u64::from(random.next_u32());
        let seeds = [seed(), seed()];
        let mut scrambled = |i: u32, axis: usize| {
            let first = scramble(sobol(i)[axis] >> (31 - digits) >> 1, digits, seeds[axis]);
            // the digits after these are random and independent for each point
            in_stratum(first, 1 << digits, random)
        };
        (0..n).map(|i| [scrambled(i, 0), scrambled(i, 1)]).collect()
    }

    fn round_up(&self, n: u32) -> u32 {
        n
    }
}

/// Point i of the sequence, in units of 2⁻³²: each binary digit of i that is 1 contributes its
/// direction number, without carries.
///
/// In the first dimension digit k contributes `2^−(k+1)`, which mirrors i. In the second it is
/// `m_k 2^−(k+1)` with `m₀ = 1` and `m_k = 2 m_(k−1) ⊕ m_(k−1)`: 1, 3, 5, 15, 17, 51 … (Joe & Kuo,
/// "Constructing Sobol Sequences with Better Two-Dimensional Projections", 2008: s = 1, a = 0).
fn sobol(i: u32) -> [u32; 2] {
    let mut y = 0;
    let mut direction = 1 << 31;
    for k in 0..32 {
        if i >> k & 1 == 1 {
            y ^= direction;
        }
        direction ^= direction >> 1;
    }
    [i.reverse_bits(), y]
}

/// A nested uniform scramble of a number of `digits` binary digits: whether a digit flips depends
/// only on the digits before it, so that points in one box `2^−k` wide stay together.
///
/// A hash of the preceding digits decides (Burley). Burley's faster hash of the whole number is
/// biased in its first digits, because few bits of the seed determine them.
fn scramble(x: u32, digits: u32, seed: u64) -> u32 {
    let flips = (0..digits).map(|k| {
        // the digits before this one, with a leading 1: the index of a node in a binary tree
        let node = 1 << k | x >> (digits - k);
        splitmix(seed ^ u64::from(node)) as u32 & 1
    });
    x ^ flips.fold(0, |word, flip| word << 1 | flip)
}
