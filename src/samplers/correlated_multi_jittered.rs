//! Correlated multi-jittered samples (Kensler, "Correlated Multi-Jittered Sampling", Pixar
//! Technical Memo 13-01, 2013); not in the book.

use super::{Sampler, in_stratum};
use crate::math::Pcg32;

/// One point in each cell of an `m × n` grid and, at the same time, one in each of the `m n` rows
/// and columns, like multi-jittered samples; but one order serves all columns of cells, and one all
/// rows, so that points of neighbouring cells keep their distance.
///
/// The grid has `m = ⌊√N⌋` columns and `n = ⌈N/m⌉` rows. A count N that is not `m n` is rounded up
/// to it: k² to `k (k + 2)` become k², `k (k + 1)` or `k (k + 2)`, far fewer than the next square.
/// (The paper leaves cells empty instead.) The orders are the paper's hashed permutations.
#[kind(Copy, PartialEq, Eq)]
pub struct CorrelatedMultiJittered {}

without_settings!(CorrelatedMultiJittered);

/// The columns and rows of the smallest grid for at least `count` points.
fn grid(count: u32) -> [u32; 2] {
    let m = count.isqrt();
    [m, count.div_ceil(m)]
}

impl Sampler for CorrelatedMultiJittered {
    fn fill(&self, count: u32, random: &mut Pcg32) -> Vec<[f64; 2]> {
        let [m, n] = grid(count);
        let pattern = random.next_u32();
        let across = |i: u32| permuted(i, m, pattern.wrapping_mul(0xa511_e9b3));
        let along = |j: u32| permuted(j, n, pattern.wrapping_mul(0x63d8_3595));

        let mut points = Vec::with_capacity(count as usize);
        for j in 0..n {
            for i in 0..m {
                // of the m n fine columns and rows, those of cell (i, j) start at i n and j m
                let column = i * n + along(j);
                let row = j * m + across(i);
                points.push([in_stratum(column, count, random), in_stratum(row, count, random)]);
            }
        }
        points
    }

    fn round_up(&self, n: u32) -> u32 {
        let [columns, rows] = grid(n);
        columns * rows
    }
}

/// The image of `i` under permutation `pattern` of `0..n` (the paper's hash). Each step is a
/// bijection of the numbers below a power of two; results of at least `n` are hashed again.
pub fn permuted(mut i: u32, n: u32, pattern: u32) -> u32 {
    let mask = n.next_power_of_two() - 1;
    loop {
        i = (i ^ pattern).wrapping_mul(0xe170_893d) ^ (pattern >> 16);
        i ^= (i & mask) >> 4;
        i = (i ^ (pattern >> 8)).wrapping_mul(0x0929_eb3f) ^ (pattern >> 23);
        i ^= (i & mask) >> 1;
        i = i.wrapping_mul(1 | (pattern >> 27)).wrapping_mul(0x6935_fa69);
        i ^= (i & mask) >> 11;
        i = i.wrapping_mul(0x74dc_b303);
        i ^= (i & mask) >> 2;
        i = i.wrapping_mul(0x9e50_1cc3);
        i ^= (i & mask) >> 2;
        i = i.wrapping_mul(0xc860_a3df) & mask;
        i ^= i >> 5;
        if i < n {
            return (i.wrapping_add(pattern)) % n;
        }
    }
}
