//! Pearson's and Spearman's correlation.

use crate::biased_samples::{LEVEL, correlated};
use crate::judge::{near, passes};
use statistics::correlation::*;
use statrs::distribution::{ContinuousCDF, StudentsT};

/// Oracle: by hand. x = 1 … 5 and y = 2, 1, 4, 3, 5 have Σxy = 8, Σxx = Σyy = 10: r = 0.8, and
/// t = 0.8 √(3/0.36) = 4/√3; Student's t of three degrees is `½ + (arctan(t/√3) + (t/√3)/(1 +
/// t²/3))/π` in closed form.
#[test]
fn it_has_the_values_found_by_hand() {
    let found = pearson(&[1.0, 2.0, 3.0, 4.0, 5.0], &[2.0, 1.0, 4.0, 3.0, 5.0]);
    let found = found.expect("five pairs");
    near(found.r, 0.8, 1e-15);
    let s: f64 = 4.0 / 3.0; // t/√3
    let below = 0.5 + (groundtruth::math::atan2(s, 1.0) + s / (1.0 + s * s)) / std::f64::consts::PI;
    assert!((found.p - 2.0 * (1.0 - below)).abs() < 1e-12, "{}", found.p);
    let line = pearson(&[1.0, 2.0, 3.0], &[5.0, 3.0, 1.0]).expect("three pairs");
    assert_eq!((line.r, line.p), (-1.0, 0.0));
}

/// Oracle: with a million pairs, t is normal: two-sided 5.733e-7 at 5 σ.
#[test]
fn the_probability_is_right_for_a_million_pairs() {
    let student = StudentsT::new(0.0, 1.0, 999_998.0).expect("it is one");
    near(2.0 * student.sf(5.0) / 5.733_031_4e-7, 1.0, 1e-3);
    near(2.0 * student.sf(1.0) / 0.317_310_507_9, 1.0, 1e-5);
}

#[test]
fn it_passes_the_truth_and_finds_a_correlation_just_above_its_power() {
    let n = 10_000;
    let smallest = 7.2 / (n as f64).sqrt();
    for seed in 0..8 {
        let [xs, ys] = correlated(n, 0.0, seed);
        passes(pearson(&xs, &ys).expect("many pairs").p);
        let [xs, ys] = correlated(n, -1.1 * smallest, seed);
        let found = pearson(&xs, &ys).expect("many pairs");
        assert!(found.p < LEVEL && found.r < 0.0, "{found:?}");
    }
}

/// Law: translation does not change the correlation. Oracle: the same pairs, a million spreads away,
/// where the sum of squares less the square of the sum would lose all but four digits.
#[test]
fn a_far_mean_does_not_matter() {
    let [xs, ys] = correlated(1000, 0.3, 1);
    let small = pearson(&xs, &ys).expect("many pairs").r;
    let far: Vec<f64> = xs.iter().map(|x| x + 1e6).collect();
    near(pearson(&far, &ys).expect("many pairs").r, small, 1e-8);
}

#[test]
fn there_is_none_of_too_few_or_of_constants() {
    assert_eq!(pearson(&[1.0, 2.0], &[1.0, 2.0]), None);
    assert_eq!(pearson(&[0.1; 10], &[0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0]), None);
    assert_eq!(pearson(&[1.0, 2.0, f64::NAN], &[1.0, 2.0, 3.0]), None);
}
