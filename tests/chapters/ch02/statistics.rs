//! The statistical tests of the chapters, tested.

use crate::prelude::*;
use crate::support::statistics::{all_equal, assert_all_equal};

/// Law: the tests accept deviations just below their limits and refuse those just above. Oracle: tables
/// of quantiles.
#[test]
fn statistical_tests_accept_and_refuse_at_their_limits() {
    // χ² = x²/100 with 100 cells: the 99.9 % quantile of 99 degrees is 148.2
    let cells = |x: u64| [10_000 - x, 10_000 + x].repeat(50);
    assert_all_equal("cells", &cells(120), 1e4, 1);
    assert!(!all_equal(&cells(123), 1e4, 1), "123 off in each cell is accepted");
    // the 99.95 % quantile of the normal distribution
    near!(most_sigmas(1), 3.290_526_731_491_926, 1e-9);
    above!(most_sigmas(100), most_sigmas(1));
    let values: Vec<f64> = (0..1000).map(f64::from).collect();
    near!(sigmas(&values, 499.5), 0.0, 1e-9);
    above!(sigmas(&values, 460.0), most_sigmas(1));
}
