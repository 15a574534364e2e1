//! The statistical tests of the chapters: with fixed seeds, at one significance level for all tests of a law
//! together (Šidák), and without retries.

use statrs::distribution::{ChiSquared, ContinuousCDF, Normal};

use crate::prelude::*;

/// The probability, over the choice of seeds, that a law that holds is reported as broken.
const SIGNIFICANCE: f64 = 1e-3;

/// The significance of each of `tests` independent tests.
fn sidak(tests: u32) -> f64 {
    1.0 - power(1.0 - SIGNIFICANCE, 1.0 / f64::from(tests))
}

/// The largest number of standard errors by which a sample mean may differ from the true mean, on either
/// side, in `tests` tests.
pub fn most_sigmas(tests: u32) -> f64 {
    let normal = Normal::standard();
    -normal.inverse_cdf(sidak(tests) / 2.0)
}

/// Pearson's χ² test of equal `expected` counts: the probability of `observed` counts that deviate as much as
/// these, or more.
fn probability(observed: &[u64], expected: f64) -> f64 {
    assert!(expected >= 5.0, "cells too small for χ²: {expected} expected");
    let deviation = |&count: &u64| (count as f64 - expected) * (count as f64 - expected);
    let statistic = observed.iter().map(deviation).sum::<f64>() / expected;
    let freedom = ChiSquared::new(observed.len() as f64 - 1.0).expect("at least two cells");
    freedom.sf(statistic)
}

/// Whether `observed` counts follow equal `expected` ones, as one of `tests`.
pub fn all_equal(observed: &[u64], expected: f64, tests: u32) -> bool {
    probability(observed, expected) > sidak(tests)
}

/// Fails unless `observed` counts follow equal `expected` ones, as one of `tests`.
pub fn assert_all_equal(what: &str, observed: &[u64], expected: f64, tests: u32) {
    let (p, level) = (probability(observed, expected), sidak(tests));
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
