//! Power laws fitted.

use crate::biased_samples::power_of;
use crate::judge::near;
use groundtruth::math::exp;
use statistics::slope::*;

/// Law: a power law without noise is found; with noise, its interval has the true slope as often
/// as it says, and leaves a false one out. Oracle: how the points were made.
#[test]
fn a_fitted_slope_is_the_true_one_and_not_another() {
    let exact = power_law(&power_of(0.25, 0.0, 0), 0.95).expect("twelve points");
    near(exact.exponent, 0.25, 1e-12);
    near(exact.factor, 3.0, 1e-11);
    let fits = || (0..400).map(|seed| power_law(&power_of(-1.5, 0.1, seed), 0.95).expect("fit"));
    let holds = |slope: f64| {
        fits().filter(|fit| fit.interval[0] <= slope && slope <= fit.interval[1]).count()
    };
    // 95 % of 400 is 380 ± 4.4; five standard deviations are allowed
    assert!((358..=400).contains(&holds(-1.5)), "{}", holds(-1.5));
    // the half-width is 2.23 · 0.1 / √143 = 0.019: three times that is off
    assert!(holds(-1.5 + 0.06) < 10, "{}", holds(-1.5 + 0.06));
}

/// Oracle: by hand. Logarithms 0, 1, 0 at 0, 1, 2 have the slope 0, squares of 2/3 about the line and
/// a spread of 2; t of one degree is Cauchy's, with the quantile `tan(π (c/2))`.
#[test]
fn the_interval_of_three_points_is_that_found_by_hand() {
    let e = exp(1.0);
    let fit = power_law(&[(1.0, 1.0), (e, e), (e * e, 1.0)], 0.95).expect("three points");
    let half = groundtruth::math::tan(std::f64::consts::PI * 0.475) * (1.0_f64 / 3.0).sqrt();
    near(fit.exponent, 0.0, 1e-14);
    near(fit.interval[1], half, 1e-9);
    near(fit.interval[0], -half, 1e-9);
}

#[test]
fn a_slope_needs_three_positive_points_that_differ() {
    assert_eq!(power_law(&[(1.0, 1.0), (2.0, 4.0)], 0.95), None);
    assert_eq!(power_law(&[(1.0, 1.0), (2.0, 4.0), (3.0, 0.0)], 0.95), None);
    assert_eq!(power_law(&[(1.0, 1.0), (2.0, f64::NAN), (3.0, 1.0)], 0.95), None);
    for x in [2.0, 3.0, 0.1, 1e-9] {
        assert_eq!(power_law(&[(x, 1.0), (x, 4.0), (x, 1.0)], 0.95), None);
    }
}
