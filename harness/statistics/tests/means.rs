//! Means, and their differences.

use crate::biased_samples::normals;
use crate::judge::{near, passes, rejects};
use groundtruth::math::{Pcg32, atan2};
use statistics::means::*;
use std::f64::consts::PI;

/// Oracle: by hand. 1 … 4 have the mean 2.5 and the variance 5/3, so that 1 is t = 1.5/√(5/12) off;
/// three degrees have a closed form, and so have two: `½ + t/(2√(2 + t²))`.
#[test]
fn they_have_the_values_found_by_hand() {
    let p = one_sample(&[1.0, 2.0, 3.0, 4.0], 1.0);
    let s = 1.5 / (5.0_f64 / 12.0).sqrt() / 3.0_f64.sqrt(); // t/√3
    let below = 0.5 + (atan2(s, 1.0) + s / (1.0 + s * s)) / PI;
    near(p, 2.0 * (1.0 - below), 1e-12);
    // equal counts and variances: 2 (n − 1) degrees, here two; both means have the variance ½/2
    let p = two_samples(&[0.0, 1.0], &[2.0, 3.0]);
    let t = 2.0 / 0.5_f64.sqrt();
    near(p, 1.0 - t / (2.0 + t * t).sqrt(), 1e-12);
    // one side without variance: the degrees are those of the other
    let p = two_samples(&[1.0, 1.0, 1.0], &[1.0, 2.0, 3.0, 4.0]);
    near(p, one_sample(&[1.0, 2.0, 3.0, 4.0], 1.0), 1e-12);
}

#[test]
fn they_pass_the_truth_and_find_an_error_just_above_their_power() {
    for seed in 0..8 {
        let random = &mut Pcg32::new(seed, 6);
        for (n, smallest) in [(16, 3.3), (2500, 7.2 / 50.0)] {
            let values = normals(n, 5.0, 2.0, random);
            passes(one_sample(&values, 5.0));
            rejects(one_sample(&values, 5.0 + 1.1 * 2.0 * smallest));
        }
        let (a, b) = (normals(500, 1.0, 3.0, random), normals(2000, 1.0, 1.0, random));
        passes(two_samples(&a, &b));
        let apart = 7.2 * (9.0 / 500.0 + 1.0 / 2000.0_f64).sqrt();
        let moved: Vec<f64> = b.iter().map(|x| x + 1.1 * apart).collect();
        rejects(two_samples(&a, &moved));
    }
}

/// Law: the interval of a difference ends where the test of equal means has the probability
/// 1 − confidence. Oracle: by hand, as above: two degrees, variance ½, `t = √2 c/√(1 − c²)` is the
/// quantile whose two sides leave 1 − c; and the test of means moved by the interval's end.
#[test]
fn the_interval_of_a_difference_is_that_found_by_hand() {
    let c: f64 = 0.9;
    let [apart, low, high] = difference(&[0.0, 1.0], &[2.0, 3.0], c).expect("two and two");
    let half = (2.0 * c * c / (1.0 - c * c)).sqrt() * 0.5_f64.sqrt();
    near(apart, -2.0, 1e-15);
    near(low, apart - half, 1e-9);
    near(high, apart + half, 1e-9);
    let random = &mut Pcg32::new(4, 6);
    let (a, b) = (normals(5, 1.0, 3.0, random), normals(9, 1.5, 1.0, random));
    let [_, low, high] = difference(&a, &b, c).expect("values");
    for end in [low, high] {
        let moved: Vec<f64> = b.iter().map(|x| x + end).collect();
        near(two_samples(&a, &moved), 1.0 - c, 1e-9);
    }
    let [mean, low, high] = interval(&[1.0, 2.0, 3.0], c).expect("three values");
    let half = (2.0 * c * c / (1.0 - c * c)).sqrt() / 3.0_f64.sqrt();
    assert_eq!(mean, 2.0);
    near(low, 2.0 - half, 1e-9);
    near(high, 2.0 + half, 1e-9);
    assert_eq!(interval(&[1.0], c), None);
    assert_eq!(difference(&[1.0, 1.0], &[3.0, 3.0], c), Some([-2.0; 3]));
    assert_eq!(difference(&[1.0], &[3.0, 3.0], c), None);
}

#[test]
fn constants_and_what_is_no_number_are_judged_exactly() {
    assert_eq!(one_sample(&[0.1; 7], 0.1), 1.0);
    assert_eq!(one_sample(&[0.1; 7], 0.1 + 1e-16), 0.0);
    assert_eq!(two_samples(&[0.1; 7], &[0.1; 3]), 1.0);
    assert_eq!(two_samples(&[0.1; 7], &[0.2; 3]), 0.0);
    assert_eq!(one_sample(&[1.0, f64::NAN, 2.0], 1.5), 0.0);
    assert_eq!(one_sample(&[1.0], 100.0), 1.0);
}
