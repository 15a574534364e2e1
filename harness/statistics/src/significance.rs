//! Levels of significance of many tests together.

use libm::pow;

/// The level of each of `tests` independent tests that together raise a false alarm with
/// probability `level` (Šidák 1967): `1 − (1 − α)^(1/m)`. Tests that depend on each other raise fewer
/// where they fail together, as those of the same samples mostly do. No tests have the whole.
pub fn sidak(level: f64, tests: usize) -> f64 {
    1.0 - pow(1.0 - level, 1.0 / tests.max(1) as f64)
}
