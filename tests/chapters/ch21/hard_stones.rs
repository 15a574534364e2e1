//! Rosettes and archways against exact arithmetic, on rays that are hard for one of their stones.

use groundtruth::verify::many::Kind;

use crate::hard_cases::sweep_many;

/// Law: a rosette has every hit of its wedges but those between two that touch. Oracle: the wedges
/// in 512-bit arithmetic, each for itself.
#[test]
fn rosettes_are_exact_within_their_condition() {
    sweep_many(Kind::Rosette, 2160, 100, 1);
}

/// Law and oracle as above, for the boxes and wedges of an archway.
#[test]
fn archways_are_exact_within_their_condition() {
    sweep_many(Kind::Archway, 2161, 100, 1);
}

/// The same, ten thousand cases a family.
#[test]
#[ignore = "cost: cargo test ch21 -- --ignored"]
fn rosettes_thoroughly() {
    sweep_many(Kind::Rosette, 21_600, 10_000, 1);
}

/// The same, ten thousand cases a family.
#[test]
#[ignore = "cost: cargo test ch21 -- --ignored"]
fn archways_thoroughly() {
    sweep_many(Kind::Archway, 21_610, 10_000, 1);
}
