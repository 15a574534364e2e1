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
fn permuted(mut i: u32, n: u32, pattern: u32) -> u32 {
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

#[cfg(test)]
mod tests {
    use super::*;

    /// Law: the permutations are the paper's. Oracle: `permute_kensler` of Mitsuba 3.9.1.
    #[test]
    fn permutations_are_those_of_the_paper() {
        let published: [(u32, &[u32]); 6] = [
            (7, &[0]),
            (1, &[0, 1]),
            (3, &[4, 0, 2, 3, 1]),
            (1, &[5, 1, 0, 7, 3, 2, 4, 6]),
            (0xa511_e9b3, &[5, 2, 0, 10, 11, 9, 4, 7, 6, 8, 3, 1, 12]),
            (u32::MAX, &[10, 4, 1, 11, 7, 0, 9, 3, 6, 13, 15, 5, 14, 12, 8, 2]),
        ];
        for (pattern, expected) in published {
            let n = expected.len() as u32;
            let found: Vec<u32> = (0..n).map(|i| permuted(i, n, pattern)).collect();
            assert_eq!(found, expected, "pattern {pattern}");
        }
    }

    /// Law: each pattern is a permutation. Oracle: sorting, for every n up to 99 and next to powers
    /// of two.
    #[test]
    fn every_pattern_permutes() {
        let mut random = Pcg32::new(2013, 0);
        for n in (1..100).chain([127, 128, 129, 1023, 1024, 1025]) {
            let pattern = random.next_u32();
            let mut found: Vec<u32> = (0..n).map(|i| permuted(i, n, pattern)).collect();
            found.sort_unstable();
            assert!(found.into_iter().eq(0..n), "{n}, pattern {pattern}");
        }
    }
}
