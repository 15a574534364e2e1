//! Levels of significance: of many tests together, and of rates that were counted.

use statrs::distribution::{Beta, ContinuousCDF};

use libm::pow;

/// The level of each of `tests` independent tests that together raise a false alarm with
/// probability `level` (Šidák 1967): `1 − (1 − α)^(1/m)`. Tests that depend on each other raise fewer
/// where they fail together, as those of the same samples mostly do. No tests have the whole.
pub fn sidak(level: f64, tests: usize) -> f64 {
    1.0 - pow(1.0 - level, 1.0 / tests.max(1) as f64)
}

/// An interval that contains the probability of an event with at least this confidence (such as
/// 0.99), if it happened `times` in `trials` independent ones, however few (Clopper & Pearson, "The
/// Use of Confidence or Fiducial Limits Illustrated in the Case of the Binomial", 1934).
///
/// From below, the probability at which as many or more are as rare as `(1 − confidence)/2`; from
/// above, at which as many or fewer are.
///
/// # Panics
/// If it happened more often than it could.
pub fn proportion(times: u64, trials: u64, confidence: f64) -> [f64; 2] {
    assert!(times <= trials, "{times} times in {trials} trials");
    let rare = 0.5 * (1.0 - confidence);
    let (k, n) = (times as f64, trials as f64);
    let quantile = |a, b, share| Beta::new(a, b).map_or(0.0, |beta| beta.inverse_cdf(share));
    [
        if times == 0 { 0.0 } else { quantile(k, n - k + 1.0, rare) },
        if times == trials { 1.0 } else { quantile(k + 1.0, n - k, 1.0 - rare) },
    ]
}
