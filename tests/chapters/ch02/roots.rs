//! Roots of quadratics, which the hits of spheres, cylinders and cones need.

use groundtruth::math::{perpendicular_roots, quadratic};
use testkit::properties::*;

use crate::prelude::*;

/// `a t² + 2 b t + c` with these roots; their sum must be even.
fn with_roots(a: i64, [r, s]: [i64; 2]) -> [f64; 3] {
    [a as f64, (-a * (r + s) / 2) as f64, (a * r * s) as f64]
}

proptest! {
    #![proptest_config(laws())]

    /// Law: the roots of a quadratic of whole numbers, in ascending order, to the bit. Oracle: the
    /// equation is made from its roots; the discriminant, its square root and both quotients are
    /// whole numbers.
    #[test]
    fn whole_roots_are_exact(a in prop_oneof![-50..0_i64, 1..50_i64], r: i16, s: i16) {
        let roots = [i64::from(r), i64::from(s) + (i64::from(r) + i64::from(s)).rem_euclid(2)];
        let [qa, qb, qc] = with_roots(a, roots);
        let expected = [roots[0].min(roots[1]) as f64, roots[0].max(roots[1]) as f64];
        prop_assert_eq!(quadratic(qa, qb, qc, qb * qb - qa * qc), Some(expected));
    }

    /// Law: a small root beside a huge one keeps its digits; the textbook's formula loses them all.
    /// Oracle: the equation is made from its roots r and 2ⁿ; rounding `r + 2ⁿ` moves neither by more
    /// than u.
    #[test]
    fn small_roots_survive_beside_huge_ones(r in 1e-3..100.0_f64, n in 30..80_i32, a in 1..5_i32) {
        let (s, a) = (power_of_two(n), f64::from(a));
        let (b, half) = (-0.5 * a * (r + s), 0.5 * a * (s - r));
        let [first, second] = quadratic(a, b, a * r * s, half * half).expect("two roots");
        prop_assert!((first - r).abs() <= 8.0 * U * r, "{first} for {r}");
        near!(second, s, 8.0 * U * s);
    }

    /// Law: for any coefficients, the results are roots of a quadratic whose coefficients differ from the
    /// given ones by a few u (backward error). Oracle: the residual, relative to the sum of the magnitudes of
    /// its terms.
    #[test]
    fn residuals_are_rounding(
        (a, b, c) in (-1.0..1.0_f64, -1.0..1.0_f64, -1.0..1.0_f64),
        (i, j, k) in (-40..40_i32, -40..40_i32, -40..40_i32),
    ) {
        let scale = power_of_two;
        let (a, b, c) = (a * scale(i), b * scale(j), c * scale(k));
        prop_assume!(a != 0.0);
        let discriminant = b * b - a * c;
        let Some([first, second]) = quadratic(a, b, c, discriminant) else {
            below!(discriminant, 0.0);
            return Ok(());
        };
        at_most!(first, second);
        for t in [first, second] {
            let residual = (a * t + 2.0 * b) * t + c;
            let magnitude = (a * t * t).abs() + (2.0 * b * t).abs() + c.abs();
            prop_assert!(residual.abs() <= 16.0 * U * magnitude, "{t}: {}", residual / magnitude);
        }
    }

    /// Law: a negative discriminant gives no real roots, a discriminant of zero a double root. Oracle: a
    /// double root made of whole numbers, and the same with the constant term changed.
    #[test]
    fn double_roots_are_double(a in 1..50_i64, r in -1000..1000_i64) {
        let [qa, qb, qc] = with_roots(a, [r, r]);
        prop_assert_eq!(quadratic(qa, qb, qc, qb * qb - qa * qc), Some([r as f64; 2]));
        prop_assert_eq!(quadratic(qa, qb, qc + 1.0, qb * qb - qa * (qc + 1.0)), None);
        prop_assert_eq!(quadratic(qa, qb, qc, f64::NAN), None);
    }

    /// Law: doubling the direction halves the roots, to the bit; reversing it negates and swaps them.
    #[test]
    fn roots_are_in_units_of_the_direction(
        f in unit(),
        d in unit(),
        far in 0.0..9.0_f64,
        r in 0.1..5.0_f64,
    ) {
        let (f, d) = (far * f, Vector::from(d));
        let roots = perpendicular_roots(f, d, r);
        let doubled = perpendicular_roots(f, 2.0 * d, r).map(|ts| ts.map(|t| 2.0 * t));
        let around = perpendicular_roots(f, -d, r).map(|[a, b]| [-b, -a]);
        prop_assert_eq!(doubled, roots);
        prop_assert_eq!(around, roots);
    }
}
