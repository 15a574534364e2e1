//! Tessellated spheres against exact arithmetic, on rays that are hard for one of their triangles.

use exact::composites::Kind;

use crate::support::hard_cases::sweep_many;
use testkit::as_many;

/// Law: a tessellated sphere has every hit of its triangles, whichever method searches them. Oracle:
/// those triangles in 512-bit arithmetic, one by one; another test checks the positions of their
/// corners.
#[test]
fn tessellated_spheres_are_exact_within_their_condition() {
    sweep_many(Kind::TessellatedSphere, 2360, as_many(100, 10_000), 1);
}
