//! The contract of [`Filter`] (Suffern, ch. 4).

use std::sync::Arc;

use groundtruth::filters::{Filter, Kind};
use groundtruth::math::ONE_MINUS;
use libtest_mimic::Trial;

use super::{Holds, ensure};

pub fn trials() -> Vec<Trial> {
    super::trials(
        Kind::ENTRIES,
        &[
            ("the_value_is_even_and_integrates_to_1", the_value_is_even_and_integrates_to_1),
            (
                "places_are_as_dense_as_the_value_is_large",
                places_are_as_dense_as_the_value_is_large,
            ),
            ("places_are_mirrored_about_the_centre", places_are_mirrored_about_the_centre),
        ],
    )
}

fn built(kind: &Kind) -> Arc<dyn Filter> {
    kind.build(&mut ()).expect("specimens are valid")
}

/// Steps of the midpoint rule for each pixel. Its error is at most h²/24 times the integral of the second
/// derivative, below 1e-6 here; if a value has a kink or a jump that is not at a multiple of 1/4096, it is
/// below h = 2.4e-4.
const STEPS: u32 = 4096;
const QUADRATURE: f64 = 3e-4;

/// The integral of a function of distance over `[−r, x]`, by the midpoint rule.
fn integral(r: f64, x: f64, f: impl Fn(f64) -> f64) -> f64 {
    let n = ((x + r) * f64::from(STEPS)).ceil().max(1.0) as u32;
    let h = (x + r) / f64::from(n);
    (0..n).map(|i| h * f(-r + h * (f64::from(i) + 0.5))).sum()
}

/// Law: even, 0 beyond its radius, and of integral 1. Oracle: quadrature.
fn the_value_is_even_and_integrates_to_1(kind: &Kind) -> Holds {
    let filter = built(kind);
    let r = filter.radius();
    let whole = integral(r, r, |x| filter.value(x));
    ensure!((whole - 1.0).abs() < QUADRATURE, "the integral is {whole}");
    for i in 0..1000 {
        let x = 1.2 * r * f64::from(i) / 1000.0;
        let [right, left] = [filter.value(x), filter.value(-x)];
        ensure!(right == left, "{right} at {x}, {left} at {}", -x);
        ensure!(x <= r || right == 0.0, "{right} at {x}, beyond the radius {r}");
    }
    Ok(())
}

/// Law: a sampled point is left of `x` with a probability that is the integral of the filter's absolute value
/// up to `x`, divided by the whole integral; its weight is the whole integral, with the filter's sign.
/// Oracle: quadrature.
fn places_are_as_dense_as_the_value_is_large(kind: &Kind) -> Holds {
    let filter = built(kind);
    let r = filter.radius();
    let size = |x: f64| filter.value(x).abs();
    let mass = integral(r, r, size);
    let mut last = f64::NEG_INFINITY;
    for i in 0..400 {
        let u = match i {
            0 => 0.0,
            399 => ONE_MINUS,
            _ => f64::from(i) / 399.0,
        };
        let (place, weight) = filter.draw(u);
        let x = place - 0.5;
        ensure!(x.abs() <= r, "{x} for {u} is beyond the radius {r}");
        ensure!(x >= last, "{x} for {u} comes after {last}");
        last = x;
        let before = integral(r, x, size) / mass;
        ensure!((before - u).abs() < QUADRATURE, "{u} gives {x}, before which lie {before}");
        ensure!((weight.abs() - mass).abs() < QUADRATURE, "weight {weight} at {x} of mass {mass}");
        let value = filter.value(x);
        // at the very ends and zeros the value is rounding
        ensure!(value.abs() < 1e-9 || (weight > 0.0) == (value > 0.0), "weight {weight} at {x}");
    }
    Ok(())
}

/// Law: `1 − u` is as far right of the centre as `u` is left of it, up to some roundings; a half is
/// the centre.
fn places_are_mirrored_about_the_centre(kind: &Kind) -> Holds {
    let filter = built(kind);
    for i in 0..=512 {
        // both are exact
        let u = f64::from(i) / 1024.0;
        let [(left, a), (right, b)] = [u, 1.0 - u].map(|u| filter.draw(u.min(ONE_MINUS)));
        // at the very end the point of a tent changes as the square root of u, that of the B-spline
        // (Mitchell's with b = 1) as the fourth root, for its zero is triple: a rounding there moves it by
        // (24 · 1e-16)^¼ = 2e-4
        let off = (left + right - 1.0).abs();
        ensure!(off < if i == 0 { 1e-3 } else { 1e-12 }, "{u} gives {left} and {right}");
        ensure!(a == b, "{u} counts {a} on the left and {b} on the right");
    }
    let middle = filter.draw(0.5).0;
    ensure!((middle - 0.5).abs() < 4.0 * f64::EPSILON, "a half gives {middle}");
    Ok(())
}
