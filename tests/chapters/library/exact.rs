//! Arithmetic that knows its rounding.

use groundtruth::math::{difference_of_products, less_products, two_product, two_sum};

/// Law: a difference of two products has one rounding. Oracle: products of small numbers, by hand.
#[test]
fn difference_of_products_survives_cancellation() {
    // (2^27 + 1)(2^27 − 1) − 2^54 = −1, which plain arithmetic rounds to 0
    let big = 134_217_728.0;
    assert_eq!(difference_of_products(big + 1.0, big - 1.0, big, big), -1.0);
    let plain: f64 = (1.0 + f64::EPSILON) * (1.0 - f64::EPSILON) - 1.0;
    assert_eq!(plain, 0.0);
    let exact = difference_of_products(1.0 + f64::EPSILON, 1.0 - f64::EPSILON, 1.0, 1.0);
    assert_eq!(exact, -f64::EPSILON * f64::EPSILON);
}

/// Law: a number less three products has no more error than its terms. Oracle: by hand.
#[test]
fn less_products_survives_cancellation() {
    // 1 − (1 + ε)(1 − ε) − ε·1 = ε² − ε; without the last product, ε²
    let e = f64::EPSILON;
    assert_eq!(less_products(1.0, [1.0 + e, 0.0, 0.0], [1.0 - e, 0.0, 0.0]), e * e);
    assert_eq!(less_products(1.0, [1.0 + e, e, 0.0], [1.0 - e, 1.0, 0.0]), e * e - e);
    // what the first sum loses is all that is left
    assert_eq!(less_products(1.0, [-1e-20, 1.0, 0.0], [1.0, 1.0, 0.0]), 1e-20);
}

/// Law: sum and error are the exact sum, product and error the exact product. Oracle: by hand.
#[test]
fn two_sum_and_two_product_lose_nothing() {
    let (s, e) = two_sum(1.0, 1e-30);
    assert_eq!((s, e), (1.0, 1e-30));
    let (p, e) = two_product(1.0 + f64::EPSILON, 1.0 + f64::EPSILON);
    assert_eq!((p, e), (1.0 + 2.0 * f64::EPSILON, f64::EPSILON * f64::EPSILON));
}
