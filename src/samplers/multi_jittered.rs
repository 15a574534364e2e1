//! Multi-jittered samples (Suffern, ch. 5; Chiu, Shirley & Wang, Graphics Gems IV, 1994).

use super::{Sampler, in_stratum, next_square, side};
use crate::math::Pcg32;

/// One point in each cell of an `n × n` grid and, at the same time, one in each of the `n²` rows
/// and columns. A count that is no square is rounded up to the next.
#[kind(Copy, PartialEq, Eq)]
pub struct MultiJittered {}

without_settings!(MultiJittered);

impl Sampler for MultiJittered {
    fn fill(&self, n: u32, random: &mut Pcg32) -> Vec<[f64; 2]> {
        let (n, side) = (next_square(n), side(n) as usize);
        // the canonical arrangement: in cell (i, j), column i n + j and row j n + i of n²
        let mut columns: Vec<u32> = (0..n).collect();
        let mut rows = columns.clone();
        // within each column of cells the fine columns are permuted; within each row the fine rows
        columns.chunks_mut(side).for_each(|fine| random.shuffle(fine));
        rows.chunks_mut(side).for_each(|fine| random.shuffle(fine));

        let mut jitter = |fine: u32| in_stratum(fine, n, random);
        let mut points = Vec::with_capacity(n as usize);
        for i in 0..side {
            for j in 0..side {
                points.push([jitter(columns[i * side + j]), jitter(rows[j * side + i])]);
            }
        }
        points
    }

    fn round_up(&self, n: u32) -> u32 {
        next_square(n)
    }
}
