//! The Kolmogorov–Smirnov test: do samples follow a continuous distribution?

use libm::exp;

/// The p-value of the hypothesis that the samples are independent and uniform on `[0, 1]`, by the largest
/// distance of their empirical distribution function from the true one (Kolmogorov 1933; for small `n`
/// with the correction of Stephens, "Use of the Kolmogorov–Smirnov, Cramér–von Mises and Related
/// Statistics without Extensive Tables", 1970).
///
/// For another continuous distribution, of function F, pass `F(x)` for each sample x; F must be known
/// beforehand. Not for stratified points, nor for discrete samples. The result is 0 if a sample is
/// outside `[0, 1]` or NaN, and 1 without samples. `docs/accuracy.md` has the accuracy for small `n`.
///
/// Power: at level 1e-6, a distribution whose F is off by `δ` somewhere is found, 98 times in 100 or
/// more, if `n δ² > 14`.
pub fn uniform(samples: &[f64]) -> f64 {
    if samples.is_empty() {
        return 1.0;
    }
    let mut sorted = samples.to_vec();
    sorted.sort_by(f64::total_cmp);
    let n = sorted.len() as f64;
    let mut distance = 0.0_f64;
    for (i, &x) in sorted.iter().enumerate() {
        if !(0.0..=1.0).contains(&x) {
            return 0.0;
        }
        distance = distance.max(x - i as f64 / n).max((i + 1) as f64 / n - x);
    }
    let root = n.sqrt();
    kolmogorov((root + 0.12 + 0.11 / root) * distance)
}

/// `2 Σ (−1)^(j−1) exp(−2 j² λ²)`, the tail of Kolmogorov's distribution.
fn kolmogorov(lambda: f64) -> f64 {
    if lambda < 0.2 {
        return 1.0; // the series converges slowly, and the tail is 1 to twelve digits
    }
    let term = |j: u32| {
        let size = exp(-2.0 * f64::from(j * j) * lambda * lambda);
        if j.is_multiple_of(2) { -size } else { size }
    };
    let sum: f64 = (1..=50).map(term).sum();
    (2.0 * sum).clamp(0.0, 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::verify::biased_samples::bent;
    use crate::verify::judge::{near, passes, rejects};

    #[test]
    fn the_tail_has_the_tables_values() {
        // critical values of the limit distribution: 1.3581 at 5 %, 1.6276 at 1 %
        near(kolmogorov(1.358_1), 0.05, 1e-5);
        near(kolmogorov(1.627_6), 0.01, 1e-5);
        assert_eq!(kolmogorov(0.0), 1.0);
    }

    /// Oracle: the exact critical distance of ten samples at 5 %, 0.40925 (Miller, "Table of Percentage
    /// Points of Kolmogorov Statistics", 1956).
    #[test]
    fn few_samples_are_corrected_for() {
        let distance = 0.40925;
        let samples: Vec<f64> =
            (1..=10).map(|i| (f64::from(i) / 10.0 - distance).max(0.0)).collect();
        assert!((uniform(&samples) - 0.05).abs() < 0.001, "{}", uniform(&samples));
    }

    #[test]
    fn it_passes_the_truth_and_finds_an_error_just_above_its_power() {
        let n = 20_000;
        let smallest = (14.0 / n as f64).sqrt();
        for seed in 0..8 {
            passes(uniform(&bent(n, 0.0, seed)));
            rejects(uniform(&bent(n, 1.1 * smallest, seed)));
        }
    }

    #[test]
    fn samples_outside_are_found_and_none_say_nothing() {
        assert_eq!(uniform(&[0.5, f64::NAN]), 0.0);
        assert_eq!(uniform(&[0.5, 1.5]), 0.0);
        assert_eq!(uniform(&[]), 1.0);
    }
}
