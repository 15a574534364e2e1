//! The panoramas: longitude and latitude.

use testkit::properties::*;

use super::views::{cylindrical, looking, spherical};
use crate::prelude::*;

fn horizontal() -> impl Strategy<Value = f64> {
    prop_oneof![4 => 1.0..360.0_f64, 1 => 1e-9..1.0_f64, 1 => Just(360.0)]
}

fn vertical() -> impl Strategy<Value = f64> {
    prop_oneof![4 => 1.0..180.0_f64, 1 => 1e-9..1.0_f64, 1 => Just(180.0)]
}

proptest! {
    #![proptest_config(laws())]

    /// Law: a spherical panorama looks along `cos ψ sin λ u + sin ψ v − cos ψ cos λ w` at `λ = xn λ_max`, `ψ
    /// = yn ψ_max`. Oracle: the book's form, with `φ = π − λ` and `θ = π/2 − ψ`, in radians.
    /// Book: spherical panoramic projections.
    #[test]
    fn spherical_panoramas_follow_the_book(
        h in horizontal(), v in vertical(), xn in -1.0..1.0_f64, yn in -1.0..1.0_f64,
    ) {
        let d = looking(&spherical(h, v), [xn, yn]).expect("it sees all its film");
        let (lambda, psi) = (xn * to_radians(0.5 * h), yn * to_radians(0.5 * v));
        let (phi, theta) = (std::f64::consts::PI - lambda, 0.5 * std::f64::consts::PI - psi);
        let expected = Vector::new(sin(theta) * sin(phi), cos(theta), sin(theta) * cos(phi));
        // the angles of up to 2π have been rounded
        prop_assert!((d - expected).length() < 32.0 * U, "{d:?} {expected:?}");
    }

    /// Law: longitude and latitude grow evenly, each with its own field of view, to some roundings of the
    /// angles themselves, however small. Oracle: arc tangents of the direction.
    /// Book: spherical panoramic projections.
    #[test]
    fn longitude_and_latitude_grow_evenly(
        h in horizontal(), v in vertical(), xn in -1.0..1.0_f64, yn in -1.0..1.0_f64,
    ) {
        let d = looking(&spherical(h, v), [xn, yn]).expect("it sees all its film");
        let level = (d.x() * d.x() + d.z() * d.z()).sqrt();
        let (lambda, psi) = (to_degrees(atan2(d.x(), -d.z())), to_degrees(atan2(d.y(), level)));
        near!(lambda, 0.5 * xn * h, 16.0 * U * (0.5 * xn * h).abs());
        near!(psi, 0.5 * yn * v, 16.0 * U * (0.5 * yn * v).abs());
    }

    /// Law: on a cylindrical panorama the longitude and the tangent of the latitude grow evenly. Oracle:
    /// slopes of the direction.
    #[test]
    fn the_cylinder_keeps_heights(
        h in horizontal(), v in 1e-9..179.0_f64, xn in -1.0..1.0_f64, yn in -1.0..1.0_f64,
    ) {
        let d = looking(&cylindrical(h, v), [xn, yn]).expect("it sees all its film");
        let lambda = to_degrees(atan2(d.x(), -d.z()));
        near!(lambda, 0.5 * xn * h, 16.0 * U * (0.5 * xn * h).abs());
        let slope = d.y() / (d.x() * d.x() + d.z() * d.z()).sqrt();
        let expected = yn * tan(to_radians(0.5 * v));
        // near 180° the tangent's condition grows with it
        let rounding = 32.0 * U * (1.0 + tan(to_radians(0.5 * v)));
        prop_assert!((slope - expected).abs() <= rounding * expected.abs(), "{slope} {expected}");
    }
}

/// Law: the seam of 360°: both edges look straight back, exactly; the top row of 180° straight up, the
/// bottom row straight down, at every x; right of the middle is u. Oracle: by hand.
/// Book: spherical panoramic projections.
#[test]
fn seams_and_poles() {
    let whole = spherical(360.0, 180.0);
    for x in [-1.0, 1.0] {
        assert_eq!(looking(&whole, [x, 0.0]), Some(Vector::Z));
        assert_eq!(looking(&cylindrical(360.0, 90.0), [x, 0.0]), Some(Vector::Z));
        // the seam is closed: the rays on both sides of it are the same, at every height
        let [a, b] = [1.0, -1.0].map(|side| looking(&whole, [side * x, 0.4]).expect("seen"));
        assert_eq!(a, b);
    }
    for x in [-1.0, -0.3, 0.0, 0.7, 1.0] {
        assert_eq!(looking(&whole, [x, 1.0]), Some(Vector::Y));
        assert_eq!(looking(&whole, [x, -1.0]), Some(-Vector::Y));
    }
    for view in [whole, cylindrical(360.0, 120.0)] {
        assert_eq!(looking(&view, [0.5, 0.0]), Some(Vector::X));
        assert_eq!(looking(&view, [-0.5, 0.0]), Some(-Vector::X));
    }
}

/// Law: a cylinder of nearly 180° ends at the tangent of nearly 90°, the cotangent of the small angle that is
/// missing. Oracle: 1/x.
#[test]
fn nearly_180_degrees_is_accurate() {
    for missing in [1e-3, 1e-6, 1e-9] {
        let missing = 180.0 - (180.0 - missing); // as rounded
        let d = looking(&cylindrical(90.0, 180.0 - missing), [0.0, 1.0]).expect("seen");
        let cotangent = 1.0 / tan(to_radians(0.5 * missing));
        assert!((d.y() / -d.z() / cotangent - 1.0).abs() < 1e-12, "{missing:e}");
    }
}
