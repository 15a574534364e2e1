//! Outliers against Rosner's published example.

use statistics::outliers;

/// Rosner's data (Technometrics 25(2), 1983), as in the NIST/SEMATECH handbook, section 1.3.5.17.3.
const ROSNER: [f64; 54] = [
    -0.25, 0.68, 0.94, 1.15, 1.20, 1.26, 1.26, 1.34, 1.38, 1.43, 1.49, 1.49, 1.55, 1.56, 1.58,
    1.65, 1.69, 1.70, 1.76, 1.77, 1.81, 1.91, 1.94, 1.96, 1.99, 2.06, 2.09, 2.10, 2.14, 2.15, 2.23,
    2.24, 2.26, 2.35, 2.37, 2.40, 2.47, 2.54, 2.62, 2.64, 2.90, 2.92, 2.92, 2.93, 3.21, 3.26, 3.30,
    3.59, 3.68, 4.30, 4.64, 5.34, 5.42, 6.01,
];

/// Law: three of Rosner's values are outliers at 5 %. The two farthest do not exceed their critical values, the third does,
/// and then all three count. Oracle: the published table.
#[test]
fn three_values_of_rosner_are_outliers() {
    let found: Vec<f64> = outliers(&ROSNER, 10, 0.05).into_iter().map(|it| ROSNER[it]).collect();
    assert_eq!(found, [6.01, 5.42, 5.34]);
    assert!(outliers(&ROSNER, 2, 0.05).is_empty());
}

/// Law: equal values, too few values and values without a far one have no outlier. Closed form.
#[test]
fn ordinary_values_have_none() {
    assert!(outliers(&[2.0; 30], 5, 0.05).is_empty());
    assert!(outliers(&[0.0, 100.0], 5, 0.05).is_empty());
    let even: Vec<f64> = (0..40).map(f64::from).collect();
    assert!(outliers(&even, 5, 0.05).is_empty());
    assert!(outliers(&[], 5, 0.05).is_empty());
}
