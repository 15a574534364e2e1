//! The checkers of chance, checked.

use crate::support::statistics::{all_equal, most_sigmas, sigmas};

/// The checkers accept what is true and refuse what is just beyond their power.
#[test]
fn the_checkers_check() {
    // χ² = x²/100 with 100 cells: the 99.9 % quantile of 99 degrees is 148.2
    let cells = |x: u64| [10_000 - x, 10_000 + x].repeat(50);
    assert!(all_equal(&cells(120), 1e4, 1));
    assert!(!all_equal(&cells(123), 1e4, 1));
    // the 99.95 % quantile of the normal distribution
    assert!((most_sigmas(1) - 3.290_526_731_491_926).abs() < 1e-9);
    assert!(most_sigmas(100) > most_sigmas(1));
    let values: Vec<f64> = (0..1000).map(f64::from).collect();
    assert!(sigmas(&values, 499.5).abs() < 1e-9 && sigmas(&values, 460.0) > most_sigmas(1));
}
