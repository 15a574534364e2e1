//! Powers, exponentials, and the geometric series.

use groundtruth::math::{floor, ln};
use testkit::properties::*;

use crate::prelude::*;

proptest! {
    #![proptest_config(laws())]

    /// Law: a whole power is the repeated product. Oracle: repeated multiplication, one rounding each;
    /// repeated squaring makes at most as many rounding errors.
    #[test]
    fn whole_powers_are_repeated_products(base in 0.0..3.0_f64, n in 0..200_u32) {
        let product = (0..n).fold(1.0, |product, _| product * base);
        let rounding = 2.0 * f64::from(n) * U * product + f64::MIN_POSITIVE;
        near!(power(base, f64::from(n)), product, rounding);
    }

    /// Law: `x^½ · x^½ = x`, `x^(a+b) = x^a x^b`, `x^−a = 1/x^a`, `x^a = exp(a ln x)`.
    #[test]
    fn powers_obey_their_laws(x in 1e-3..1e3_f64, a in -4.0..4.0_f64, b in -4.0..4.0_f64) {
        let [product, inverse] = [power(x, a) * power(x, b), 1.0 / power(x, a)];
        near!(power(x, 0.5), x.sqrt(), 1e-13 * x.sqrt());
        near!(power(x, a + b), product, 1e-13 * product);
        near!(power(x, -a), inverse, 1e-13 * inverse);
        near!(power(x, a), exp(a * ln(x)), 1e-13 * power(x, a));
    }

    /// Law: powers of two are exact, by doubling and halving.
    #[test]
    fn powers_of_two_are_exact(exponent in -1022..1024_i32) {
        let step = if exponent < 0 { 0.5 } else { 2.0 };
        let product = (0..exponent.abs()).fold(1.0, |product, _| product * step);
        prop_assert_eq!(power_of_two(exponent), product);
    }

    /// Law: `s_n = a (1 − rⁿ)/(1 − r)` is the sum of `a rʲ` for j below n, and `n a` for r = 1 (the book
    /// prints n for j in the summand); six terms with a = 1 and r = ½ make 1.968 75; without an end it
    /// is `a/(1 − r)`. Oracle: adding up.
    /// Book: equation 2.15, geometric series.
    #[test]
    fn geometric_series_add_up(a in 0.1..10.0_f64, r in 0.0..0.99_f64, n in 0..60_u32) {
        let sum: f64 = (0..n).map(|j| a * power(r, f64::from(j))).sum();
        let closed = a * (1.0 - power(r, f64::from(n))) / (1.0 - r);
        near!(sum, closed, 1e-12 * a / (1.0 - r));
        prop_assert_eq!((0..6).map(|j| power(0.5, f64::from(j))).sum::<f64>(), 1.96875);
        let all: f64 = (0..5000).map(|j| a * power(r, f64::from(j))).sum();
        near!(all, a / (1.0 - r), 1e-12 * a / (1.0 - r));
    }

    /// Law: the floor is the largest whole number not above x.
    #[test]
    fn floors_are_whole(x in -1e6..1e6_f64) {
        at_most!(floor(x), x);
        below!(x, floor(x) + 1.0);
        prop_assert_eq!(floor(x), floor(x) as i64 as f64);
    }
}

/// Law: special cases of `power`: 0⁰ = 1 (a glossy lobe of exponent 0 is white), 0ⁿ = 0, 1ⁿ = 1.
#[test]
fn powers_of_nought_and_one() {
    assert_eq!(power(0.0, 0.0), 1.0);
    for n in [0.5, 1.0, 2.0, 1e4, 1e9] {
        assert_eq!((power(0.0, n), power(1.0, n)), (0.0, 1.0), "{n}");
    }
    assert_eq!(power(2.0, 10.0), 1024.0);
    assert_eq!(power(0.5, 2000.0), 0.0);
}
