//! The statistical tests of the chapters: with fixed seeds, at one significance level for all tests of a law
//! together (Šidák), and without retries.

use statistics::chi_square::goodness_of_fit;
use statistics::significance::sidak;
use statrs::distribution::{ContinuousCDF, Normal};

/// The probability, over the choice of seeds, that a law that holds is reported as broken.
const SIGNIFICANCE: f64 = 1e-3;

/// The largest number of standard errors by which a sample mean may differ from the true mean, on either
/// side, in `tests` tests.
pub fn most_sigmas(tests: usize) -> f64 {
    let normal = Normal::standard();
    -normal.inverse_cdf(sidak(SIGNIFICANCE, tests) / 2.0)
}

/// Fails unless `observed` counts follow equal `expected` ones, as one of `tests`.
pub fn assert_all_equal(what: &str, observed: &[u64], expected: f64, tests: usize) {
    let p = goodness_of_fit(observed, &vec![expected; observed.len()]);
    let level = sidak(SIGNIFICANCE, tests);
    let shown = &observed[..observed.len().min(12)];
    assert!(
        p > level,
        "{what}: counts as far from {expected} as these {} have the probability {p:e}, expected more \
         than {level:e}: {shown:?}, …",
        observed.len()
    );
}

/// Mean and variance of a sample.
pub fn moments(values: &[f64]) -> (f64, f64) {
    let n = values.len() as f64;
    let mean = values.iter().sum::<f64>() / n;
    (mean, values.iter().map(|x| (x - mean) * (x - mean)).sum::<f64>() / (n - 1.0))
}

/// By how many of its standard errors the mean of `values` is away from `expected`.
pub fn sigmas(values: &[f64], expected: f64) -> f64 {
    let (mean, variance) = moments(values);
    (mean - expected) / (variance / values.len() as f64).sqrt()
}
