//! Pure random samples (Suffern, ch. 4 and 5).

use super::Sampler;
use crate::math::Pcg32;

/// Independent uniform points.
#[kind(Copy, PartialEq, Eq)]
pub struct Random {}

without_settings!(Random);

impl Sampler for Random {
    fn fill(&self, n: u32, random: &mut Pcg32) -> Vec<[f64; 2]> {
        (0..n).map(|_| [random.uniform(), random.uniform()]).collect()
    }

    fn round_up(&self, n: u32) -> u32 {
        n
    }
}
