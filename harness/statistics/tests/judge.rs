//! Assertions that say what they found.

#[path = "../../pictures/tests/verbs.rs"]
pub mod verbs;

use super::biased_samples::LEVEL;

/// Fails unless `found` is within `tolerance` of `expected`.
#[track_caller]
pub fn near(found: f64, expected: f64, tolerance: f64) {
    let off = (found - expected).abs();
    assert!(off < tolerance, "found {found}, expected {expected}: {off:e} off, not {tolerance:e}");
}

/// Fails if a test of significance rejects the truth.
#[track_caller]
pub fn passes(p: f64) {
    assert!(p > LEVEL, "p = {p:e} is below the level {LEVEL:e}: a false alarm");
}

/// Fails unless a test of significance rejects what is wrong.
#[track_caller]
pub fn rejects(p: f64) {
    assert!(p < LEVEL, "p = {p:e} is above the level {LEVEL:e}: the error is not found");
}
