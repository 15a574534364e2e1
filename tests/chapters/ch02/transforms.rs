//! Points, vectors and normals transform each in their own way; chapter 20 has the rest.

use testkit::properties::*;

use crate::prelude::*;

proptest! {
    #![proptest_config(laws())]

}

/// Law: stretching a sphere along an axis moves its points towards that axis, but turns its normals away from
/// it. Oracle: the ellipsoid `(x/2)² + y² = 1` has the gradient (x/2, 2y).
/// Book: transforming points, vectors and normals.
#[test]
fn normals_of_an_ellipse_are_its_gradient() {
    let stretch = Transform::from_steps(&[Step::Scale(Vector::new(2.0, 1.0, 1.0))]);
    let stretch = stretch.expect("invertible");
    let n = Normal::new(Vector::new(3.0, 4.0, 0.0)).expect("not zero");
    let p = stretch.point(Point::ORIGIN + Vector::from(n));
    let gradient = Vector::new(0.5 * p.x(), 2.0 * p.y(), 0.0);
    below!(gradient.cross(stretch.covector(n)).length(), 4.0 * U);
}
