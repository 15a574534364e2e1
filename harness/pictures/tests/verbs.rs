//! Assertions that say what was measured, what was found and what was expected.

use std::fmt::{Debug, Display};

/// Fails unless a quantity is within `tolerance` of what is expected; NaN is near nothing.
#[track_caller]
pub fn near(what: impl Display, found: f64, expected: f64, tolerance: f64) {
    let apart = (found - expected).abs();
    let is_near = apart <= tolerance || found == expected;
    assert!(
        is_near,
        "{what}: found {found:?}, expected {expected:?}: {apart:e} apart, allowed {tolerance:e}"
    );
}

/// Fails unless a quantity is what is expected.
#[track_caller]
pub fn equal<T: PartialEq + Debug>(what: impl Display, found: T, expected: T) {
    assert!(found == expected, "{what}: found {found:?}, expected {expected:?}");
}

/// Fails unless a quantity lies between two others, or is one of them.
#[track_caller]
pub fn between(what: impl Display, found: f64, [least, most]: [f64; 2]) {
    assert!(
        (least..=most).contains(&found),
        "{what}: found {found:?}, expected {least:?} to {most:?}"
    );
}
