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
pub fn kolmogorov(lambda: f64) -> f64 {
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
