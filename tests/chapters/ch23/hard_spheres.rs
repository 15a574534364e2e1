//! Tessellated spheres against exact arithmetic, on rays that are hard for one of their triangles.

use exact::composites::Kind;

use crate::support::hard_cases::sweep_many;

/// Law: a tessellated sphere has every hit of its triangles, whichever method searches them. Oracle:
/// those triangles in 512-bit arithmetic, one by one; another test checks the positions of their
/// corners.
#[test]
fn tessellated_spheres_are_exact_within_their_condition() {
    sweep_many(Kind::TessellatedSphere, 2360, 100, 1);
}

/// The same, ten thousand cases a family.
#[test]
#[ignore = "cost: cargo test ch23 -- --ignored"]
fn tessellated_spheres_thoroughly() {
    sweep_many(Kind::TessellatedSphere, 23_600, 10_000, 1);
}
