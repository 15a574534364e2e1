//! Quantiles.

use statistics::quantile;

#[test]
fn quantiles_are_the_nearest_ranks() {
    let values: Vec<f64> = (1..=1000).rev().map(f64::from).collect();
    assert_eq!(quantile(&values, 0.5), Some(500.0));
    assert_eq!(quantile(&values, 0.999), Some(999.0));
    assert_eq!(quantile(&values, 1.0), Some(1000.0));
    assert_eq!(quantile(&values[..3], 0.5), Some(999.0));
    assert_eq!(quantile(&[], 0.5), None);
}
