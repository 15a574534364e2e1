//! Correlated multi-jittered samples (Kensler, "Correlated Multi-Jittered Sampling", Pixar Technical
//! Memo 13-01, 2013); not in the book.

use serde::{Deserialize, Serialize};

use super::{Sampler, place};
use crate::math::Pcg32;

/// One point in each cell of an `m × n` grid and, at the same time, one in each of the `m n` rows and
/// columns, like multi-jittered samples; but one order serves all columns of cells, and one all rows,
/// so that points of neighbouring cells keep their distance.
///
/// The grid has `m = ⌊√N⌋` columns and `n = ⌈N/m⌉` rows. A count N that is not `m n` is rounded up to
/// it: k² to `k (k + 2)` become k², `k (k + 1)` or `k (k + 2)`, far fewer than the next square. (The
/// paper leaves cells empty instead; its hashed permutations do without the memory of a set, which is
/// there anyway.)
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
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
        let (mut across, mut along): (Vec<u32>, Vec<u32>) = ((0..m).collect(), (0..n).collect());
        random.shuffle(&mut across);
        random.shuffle(&mut along);

        let mut points = Vec::with_capacity(count as usize);
        for j in 0..n {
            for i in 0..m {
                // of the m n fine columns and rows, those of cell (i, j) start at i n and j m
                let column = i * n + along[j as usize];
                let row = j * m + across[i as usize];
                points.push([place(column, count, random), place(row, count, random)]);
            }
        }
        points
    }

    fn round_up(&self, n: u32) -> u32 {
        let [columns, rows] = grid(n);
        columns * rows
    }
}
