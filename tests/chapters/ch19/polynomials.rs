//! Roots of polynomials of small degree, which tori and algebraic surfaces need.

use groundtruth::math::polynomial::{real_roots, roots_between};

use crate::prelude::*;

/// The largest allowed residual of a root, relative to its terms: such a root is exact for slightly
/// different coefficients (`numerics.md`).
const RESIDUAL: f64 = 8.0 * U;

/// Law: the roots of known quartics are found: 1, 2, 3 and 4; ±1 and ±2 of `x⁴ − 5x² + 4`; ±1 of `x⁴ −
/// 1`; none of `x⁴ + 1`. Oracle: the polynomials are made from their roots.
/// Book: tori and their quartic equation.
#[test]
fn the_textbook_quartics_have_their_roots() {
    let examples: [(&[f64], &[f64]); 6] = [
        (&[24.0, -50.0, 35.0, -10.0, 1.0], &[1.0, 2.0, 3.0, 4.0]),
        (&[4.0, 0.0, -5.0, 0.0, 1.0], &[-2.0, -1.0, 1.0, 2.0]),
        (&[-1.0, 0.0, 0.0, 0.0, 1.0], &[-1.0, 1.0]),
        (&[1.0, 0.0, 0.0, 0.0, 1.0], &[]),
        (&[-6.0, 2.0], &[3.0]),
        (&[0.0, 0.0, -5.0, 1.0], &[0.0, 5.0]),
    ];
    for (coefficients, expected) in examples {
        let found = real_roots(coefficients);
        assert_eq!(found.len(), expected.len(), "{coefficients:?}: {found:?}");
        for (x, root) in found.iter().zip(expected) {
            assert!((x - root).abs() <= 40.0 * U * root.abs(), "{coefficients:?}: {found:?}");
        }
    }
}

/// Law: a root of multiplicity k is found as near to its value as rounding allows: within about u^(1/k)
/// (numerics.md). Oracle: coefficients made from the roots.
/// Book: tori and their quartic equation.
#[test]
fn roots_that_meet_are_never_lost() {
    let with = |roots: &[f64]| {
        roots.iter().fold(vec![1.0], |p: Vec<f64>, r| {
            let at = |i: usize| p.get(i).copied().unwrap_or(0.0);
            (0..=p.len()).map(|i| if i > 0 { at(i - 1) } else { 0.0 } - r * at(i)).collect()
        })
    };
    let mut draw = Draw::new(1940);
    for _ in 0..4_000 {
        let whole = |draw: &mut Draw| draw.below(41) as f64 - 20.0;
        let times = 2 + draw.below(3);
        // with thirds the coefficients are rounded, by at most 4u, so that there is no exact double root
        let share = if times == 2 { 1.0 / 3.0 } else { 1.0 };
        let (meeting, other) = (share * whole(&mut draw), share * whole(&mut draw));
        let mut roots = vec![meeting; times];
        if times < 4 && draw.coin() {
            roots.push(other);
        }
        let found = real_roots(&with(&roots));
        for &root in &roots {
            let meets = roots.iter().filter(|&&r| r == root).count() as f64;
            // coefficients rounded by 8u change the value by at most 8u ∏(|x| + |r|). An m-fold root
            // moves by the m-th root of that change over the product of its distances to the other
            // roots; twice that is allowed
            let value: f64 = roots.iter().map(|r| root.abs() + r.abs()).product();
            let apart: f64 = roots.iter().map(|r| (root - r).abs()).filter(|&d| d > 0.0).product();
            let moved = groundtruth::math::power(8.0 * U * value / apart, 1.0 / meets);
            let spread = 2.0 * moved + 4.0 * U * root.abs();
            let near = found.iter().any(|x| (x - root).abs() <= spread);
            assert!(near, "{roots:?} gave {found:?}");
        }
        assert!(found.len() <= roots.len(), "{roots:?} gave {found:?}");
        assert!(found.is_sorted(), "{roots:?} gave {found:?}");
    }
}

/// A polynomial of degree 1 to 8 whose coefficients have different magnitudes; one may be zero.
fn any(draw: &mut Draw) -> Vec<f64> {
    let degree = 1 + draw.below(8);
    let spread = draw.between(0.0, 4.0);
    let mut c: Vec<f64> =
        (0..=degree).map(|_| draw.between(-1.0, 1.0) * draw.decades(-spread, spread)).collect();
    if draw.coin() {
        c[draw.below(degree + 1)] = 0.0;
    }
    c
}

/// Law: all real roots of a polynomial are found and no others, unless a change of the coefficients by
/// 16u changes their number, in intervals and on the whole line. Each root has a residual of at most 8u of its terms.
/// Oracle: 512-bit arithmetic.
/// Book: tori and their quartic equation.
#[test]
fn every_root_of_an_interval_is_found() {
    let mut draw = Draw::new(1941);
    let (mut judged, mut roots, mut worst) = (0, 0, 0.0_f64);
    let cases = as_many(300, 10_000);
    for i in 0..cases {
        let c = any(&mut draw);
        let low = -draw.decades(-2.0, 2.0);
        let high = if draw.coin() { -low } else { low + draw.decades(-2.0, 2.0) };
        let whole = i % 8 == 0;
        let [low, high] = if whole { [-1e30, 1e30] } else { [low, high] };
        let found = if whole { real_roots(&c) } else { roots_between(&c, low, high) };
        let within = found.iter().all(|x| (low..=high).contains(x));
        assert!(found.is_sorted() && within, "{found:?} from {low} to {high}");
        for &x in &found {
            let residual = oracle::residual(&c, x);
            worst = worst.max(residual / U);
            assert!(residual <= RESIDUAL, "case {i}: {c:?} at {x}: {} u", residual / U);
        }
        let (exact, margin) = oracle::polynomial_roots(&c, low, high);
        if margin > 16.0 * U && exact.iter().all(|x| x.abs() < 1e20) {
            assert_eq!(found.len(), exact.len(), "case {i}: {c:?}: {found:?}, not {exact:?}");
            judged += 1;
            roots += exact.len();
        }
    }
    println!("worst residual {worst:.2} u, {roots} roots");
    assert!(10 * judged > 8 * cases && 10 * roots > 6 * cases, "{judged} judged, {roots} roots");
}

/// Law: a leading coefficient that is zero or tiny does not change the roots in a bounded interval.
/// Oracle: the roots without it.
#[test]
fn a_tiny_leading_coefficient_changes_nothing_within_reach() {
    let mut draw = Draw::new(1944);
    for _ in 0..4_000 {
        let c = any(&mut draw);
        let plain = roots_between(&c, -3.0, 3.0);
        for leading in [0.0, -0.0, 1e-300, -1e-300, 5e-324] {
            let more: Vec<f64> = c.iter().copied().chain([leading]).collect();
            assert_eq!(roots_between(&more, -3.0, 3.0), plain, "{more:?}");
        }
    }
    let far = real_roots(&[-1.0, 1.0, 0.0, 0.0, 1e-300]);
    assert!(far.len() == 2 && (far[0] / 1e100 + 1.0).abs() < 4.0 * U && far[1] == 1.0, "{far:?}");
}

/// Law: a polynomial without roots, the zero polynomial, no coefficients, coefficients that are not
/// finite, too many coefficients and an empty interval give no roots. Roots at the ends of the interval
/// count.
#[test]
fn ends_count_and_nonsense_has_no_roots() {
    for c in [&[][..], &[0.0], &[0.0, 0.0, 0.0], &[5.0], &[1.0, f64::NAN], &[1.0, f64::INFINITY]] {
        assert!(real_roots(c).is_empty() && roots_between(c, -1.0, 1.0).is_empty(), "{c:?}");
    }
    assert_eq!(roots_between(&[1.0; 18], -1.0, 1.0)[..], [0.0; 0]);
    assert_eq!(roots_between(&[0.0, 1.0], 1.0, -1.0)[..], [0.0; 0]);
    assert_eq!(roots_between(&[2.0, -3.0, 1.0], 1.0, 2.0)[..], [1.0, 2.0]);
    assert_eq!(roots_between(&[2.0, -3.0, 1.0], 1.5, 9.0)[..], [2.0]);
}
