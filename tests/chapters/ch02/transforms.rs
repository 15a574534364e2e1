//! Points, vectors and normals transform each in their own way; chapter 20 has the rest.

use testkit::properties::*;

use crate::prelude::*;

/// Transformations of every kind, well-conditioned.
fn transform() -> impl Strategy<Value = Transform> {
    let factor = || prop_oneof![0.25..4.0_f64, -4.0..-0.25_f64];
    let angle = || -360.0..360.0_f64;
    let step = prop_oneof![
        point(10.0).prop_map(|p| Step::Translate(p.to_vector())),
        (factor(), factor(), factor()).prop_map(|(x, y, z)| Step::Scale(Vector::new(x, y, z))),
        angle().prop_map(Step::RotateX),
        angle().prop_map(Step::RotateY),
        angle().prop_map(Step::RotateZ),
        Just(Step::Reflect(Axis::Y)),
        (-0.5..0.5_f64).prop_map(|a| Step::Shear([a, 0.25, 0.0, 0.0, -a, 0.125])),
    ];
    prop::collection::vec(step, 0..4)
        .prop_map(|steps| Transform::from_steps(&steps).expect("well-conditioned"))
}

/// Three steps of condition at most 16 each: rounding errors of 4u grow to 2¹⁴ u at most, relative to the
/// largest intermediate number, 10·4³.
const ROUNDING: f64 = 16_384.0 * U * 640.0;

proptest! {
    #![proptest_config(laws())]

    /// Law: points move with a translation, vectors do not; otherwise alike: `T(p) − T(q) = T(p − q)`.
    /// Book: transforming points, vectors and normals.
    #[test]
    fn vectors_ignore_translations(t in transform(), p in point(5.0), q in point(5.0)) {
        near!(t.point(p) - t.point(q), t.vector(p - q), ROUNDING);
        let shift = Vector::new(3.0, -5.0, 7.0);
        let moved = Transform::from_steps(&[Step::Translate(shift)]).expect("invertible");
        prop_assert_eq!(moved.point(Point::ORIGIN), Point::ORIGIN + shift);
        prop_assert_eq!(moved.vector(p.to_vector()), p.to_vector());
    }

    /// Law: a transformed normal is perpendicular to every transformed tangent: `M⁻ᵀn · M v = n·v`.
    /// Moving it as a vector would not do that.
    /// Book: transforming points, vectors and normals.
    #[test]
    fn normals_stay_perpendicular(t in transform(), n in unit(), v in point(5.0)) {
        let v = v.to_vector();
        near!(t.covector(n).dot(t.vector(v)), n.dot(v), ROUNDING);
    }
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
