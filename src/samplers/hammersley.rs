//! Hammersley samples (Suffern, ch. 5; Hammersley 1960).

use super::{Made, Sampler, Specification, made};
use crate::math::{Pcg32, power_of_two};

/// The points `(i/n, Φ(i))`, where Φ mirrors the binary digits of i at the point: Φ(6) = Φ(110₂) =
/// 0.011₂ = 3/8. Any count; with `n = 2^m` each of the n boxes `2^−a × 2^(a−m)` has one point.
///
/// This is one fixed set. As in the book, all pixels use it, and show the same artefacts; only the
/// order differs. `shifted` moves it by another random vector for each draw, across the edges of
/// the square, which makes averages right on average.
#[kind(Copy, Default, PartialEq, Eq)]
pub struct Hammersley {
    /// Whether each draw shifts the set; not if left out.
    #[optional]
    pub shifted: bool,
}

impl Specification for Hammersley {
    fn make(&self, (): &mut ()) -> Made {
        made(*self)
    }
}

impl Sampler for Hammersley {
    fn fill(&self, n: u32, _: &mut Pcg32) -> Vec<[f64; 2]> {
        let mirrored = |i: u32| f64::from(i.reverse_bits()) * power_of_two(-32);
        (0..n).map(|i| [f64::from(i) / f64::from(n), mirrored(i)]).collect()
    }

    fn round_up(&self, n: u32) -> u32 {
        n
    }

    fn is_shifted(&self) -> bool {
        self.shifted
    }
}
