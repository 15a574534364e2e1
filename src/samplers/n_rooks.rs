//! N-rooks samples (Suffern, ch. 5; Shirley, "Discrepancy as a Quality Measure for Sample
//! Distributions", 1991).

use super::{Sampler, in_stratum};
use crate::math::Pcg32;

/// One point in each of `n` rows and in each of `n` columns, as rooks that do not threaten each
/// other: the diagonal of an `n × n` grid, its rows shuffled. Any count; in two dimensions no
/// better spread than random points.
///
/// The book shuffles the columns too. One shuffle gives the same sets, each as likely; their order
/// is decided by the draw.
#[kind(Copy, PartialEq, Eq)]
pub struct NRooks {}

without_settings!(NRooks);

impl Sampler for NRooks {
    fn fill(&self, n: u32, random: &mut Pcg32) -> Vec<[f64; 2]> {
        let mut rows: Vec<u32> = (0..n).collect();
        random.shuffle(&mut rows);
        (0..n)
            .zip(rows)
            .map(|(k, j)| [in_stratum(k, n, random), in_stratum(j, n, random)])
            .collect()
    }

    fn round_up(&self, n: u32) -> u32 {
        n
    }
}
