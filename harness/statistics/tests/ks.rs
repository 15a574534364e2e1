//! Kolmogorov–Smirnov's test.

use crate::biased_samples::bent;
use crate::judge::{near, passes, rejects};
use statistics::ks::*;

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
    let samples: Vec<f64> = (1..=10).map(|i| (f64::from(i) / 10.0 - distance).max(0.0)).collect();
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
