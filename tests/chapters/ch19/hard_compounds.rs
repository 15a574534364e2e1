//! Compounds of three shapes against exact arithmetic, on hard cases.

use exact::composites::Kind;

use crate::support::hard_cases::sweep_many;
use testkit::as_many;

/// Compounds cycle through twelve kinds; each round of twelve is searched by the next method.
fn sweep(seed: u64, count: usize) {
    sweep_many(Kind::Compound, seed, count, 12);
}

/// Law: a compound has every hit of its parts, in their order, with their normals, whichever method
/// searches them. Oracle: its parts in 512-bit arithmetic, one by one.
#[test]
fn compounds_are_exact_within_their_condition() {
    sweep(191, as_many(100, 10_000));
}
