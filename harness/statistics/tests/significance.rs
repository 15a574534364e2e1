//! Levels of many tests, and counted rates.

use crate::judge::near;
use groundtruth::math::power;
use statistics::significance::*;

#[test]
fn sidak_keeps_the_level_of_the_family() {
    assert_eq!(sidak(0.05, 1), 1.0 - 0.95);
    let each = sidak(0.01, 100);
    near(power(1.0 - each, 100.0), 0.99, 1e-12);
    assert!(each > 0.01 / 100.0, "a little less strict than Bonferroni");
    assert_eq!(sidak(0.05, 0), sidak(0.05, 1));
}

/// The probability of `times` or fewer in `trials`, term by term.
fn or_fewer(times: u64, trials: u64, p: f64) -> f64 {
    let mut term = power(1.0 - p, trials as f64);
    let mut sum = 0.0;
    for k in 0..=times {
        sum += term;
        term *= (trials - k) as f64 / (k + 1) as f64 * p / (1.0 - p);
    }
    sum
}

/// Oracle: the definition, summed; the quantile is found to five digits.
#[test]
fn at_the_ends_of_the_interval_the_count_is_just_as_rare_as_said() {
    for (times, trials) in [(1, 10), (3, 10), (10, 1000), (19, 20), (5, 100_000)] {
        for confidence in [0.9, 0.99, 0.999] {
            let [low, high] = proportion(times, trials, confidence);
            let rare = 0.5 * (1.0 - confidence);
            let (more, fewer) =
                (1.0 - or_fewer(times - 1, trials, low), or_fewer(times, trials, high));
            assert!((more / rare - 1.0).abs() < 1e-5, "{times} of {trials}: {more}");
            assert!((fewer / rare - 1.0).abs() < 1e-5, "{times} of {trials}: {fewer}");
        }
    }
}

#[test]
fn never_and_always_have_closed_forms() {
    let [low, high] = proportion(0, 50, 0.95);
    assert_eq!(low, 0.0);
    near(high, 1.0 - power(0.025, 0.02), 1e-9);
    let [low, high] = proportion(50, 50, 0.95);
    near(low, power(0.025, 0.02), 1e-9);
    assert_eq!(high, 1.0);
    assert_eq!(proportion(0, 0, 0.95), [0.0, 1.0]);
}
