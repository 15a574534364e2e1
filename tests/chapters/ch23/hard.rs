//! Triangles of meshes against exact arithmetic, on hard cases.

use exact::composites::Kind;
use oracle::Shape;
use oracle::hard::{Family, Kind as Hard, cases};

use crate::support::hard_cases::{sweep_many, sweep_many_as};
use testkit::as_many;

fn sweep_meshes(seed: u64, count: usize) {
    sweep_many(Kind::Mesh, seed, count, 1);
}

fn sweep_instances(seed: u64, count: usize) {
    let matrices: Vec<_> = cases(Hard::Instance, Family::Scaled, 2300, 64)
        .into_iter()
        .filter_map(|(shape, _)| match shape {
            Shape::Instance { matrix, .. } => Some(matrix),
            _ => None,
        })
        .collect();
    // the method changes after every three cases, so that each of the 64 matrices meets each of the four
    // methods
    let instanced = |index: usize| &matrices[index % matrices.len()];
    sweep_many_as(Kind::Mesh, seed, count, 3, |case, index| case.instanced(instanced(index)));
}

/// Law: a mesh has every hit of its triangles, as exactly as their condition allows, whichever method
/// searches them. Oracle: 512-bit arithmetic, one triangle after the other.
#[test]
fn meshes_are_exact_within_their_condition() {
    sweep_meshes(23, as_many(100, 10_000));
}

/// Law and oracle as above, for instances of meshes.
#[test]
fn instances_of_meshes_are_exact_within_their_condition() {
    sweep_instances(231, as_many(100, 10_000));
}
