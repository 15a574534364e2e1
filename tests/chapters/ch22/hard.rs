//! Random spheres and lattices against exact arithmetic, on rays that are hard for one of their parts.

use exact::composites::Kind;

use crate::support::hard_cases::sweep_many;
use testkit::as_many;

fn sweep_spheres(seed: u64, count: usize) {
    sweep_many(Kind::RandomSpheres, seed, count, 1);
}

/// Lattices cycle through five kinds; each round of five is searched by the next method.
fn sweep_lattices(seed: u64, count: usize) {
    sweep_many(Kind::Lattice, seed, count, 5);
}

/// Law: random spheres have every hit of each sphere, whichever method searches them. Oracle: the
/// spheres in 512-bit arithmetic, one by one.
#[test]
fn random_spheres_are_exact_within_their_condition() {
    sweep_spheres(2270, as_many(100, 10_000));
}

/// Law and oracle as above, for the copies of a lattice.
#[test]
fn lattices_are_exact_within_their_condition() {
    sweep_lattices(2271, as_many(100, 10_000));
}
