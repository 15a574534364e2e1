//! Degrees and radians, spherical coordinates, solid angles, integrals over the hemisphere.

use std::f64::consts::FRAC_PI_2;

use groundtruth::math::Frame;
use testkit::properties::*;

use crate::prelude::*;

/// Law: 180° = π, 1 rad = 57.295 779 513 082 32° (the book prints the inverse factor).
/// Book: degrees and radians.
#[test]
fn half_a_turn_is_pi() {
    assert_eq!((to_radians(180.0), to_degrees(PI)), (PI, 180.0));
    assert_eq!(to_radians(90.0), FRAC_PI_2);
    near!(to_degrees(1.0), 57.295_779_513_082_32, 1e-14);
    near!(to_radians(1.0), 0.017_453_292_519_943_295, 1e-17);
}

/// Law: sines and cosines of quarter turns are exact, however many turns. Oracle: 0, 1, 0, −1.
#[test]
fn quarter_turns_are_exact() {
    let table = [0.0, 1.0, 0.0, -1.0];
    for quarter in (-1000..1000).chain([1 << 40, (1 << 40) + 1, -(1 << 40) - 1]) {
        let degrees = 90.0 * quarter as f64;
        let sine = |quarter: i64| table[quarter.rem_euclid(4) as usize];
        assert_eq!(sin_degrees(degrees), sine(quarter), "{degrees}");
        assert_eq!(cos_degrees(degrees), sine(quarter + 1), "{degrees}");
    }
}

/// The angle in radians and the function are each rounded once, and the slope is at most 1; twice that.
const SINE: f64 = 4.0 * U;

proptest! {
    #![proptest_config(laws())]

    /// Law: a whole turn changes no bit; the sine is odd, the cosine even, and `cos x = sin(90° − x)`;
    /// `cos(x ± 90°) = ∓ sin x` (the book misprints it). Oracle: these identities.
    /// Book: trigonometric identities.
    #[test]
    fn sines_of_degrees_are_periodic(eighths in -2880..2880_i32, turns in -5..6_i32) {
        let x = f64::from(eighths) / 8.0;
        let turned = x + 360.0 * f64::from(turns);
        prop_assert_eq!(sin_degrees(turned), sin_degrees(x));
        prop_assert_eq!(cos_degrees(turned), cos_degrees(x));
        prop_assert_eq!(sin_degrees(-x), -sin_degrees(x));
        prop_assert_eq!(cos_degrees(-x), cos_degrees(x));
        near!(cos_degrees(x), sin_degrees(90.0 - x), SINE);
        near!(cos_degrees(x + 90.0), -sin_degrees(x), SINE);
        near!(cos_degrees(x - 90.0), sin_degrees(x), SINE);
        let (s, c) = (sin_degrees(x), cos_degrees(x));
        near!(s * s + c * c, 1.0, 2.0 * SINE);
    }

    /// Law: the sine of a sum is `sin(a + b) = sin a cos b + cos a sin b`, in degrees and in radians alike.
    /// Book: trigonometric identities.
    #[test]
    fn sines_add(a in -360.0..360.0_f64, b in -360.0..360.0_f64) {
        let sum = sin_degrees(a) * cos_degrees(b) + cos_degrees(a) * sin_degrees(b);
        // a + b is rounded: an error of up to 720 u, in degrees
        let rounding = 4.0 * SINE + to_radians(720.0) * U;
        near!(sin_degrees(a + b), sum, rounding);
        near!(sin_degrees(a), sin(to_radians(a)), SINE + 8.0 * to_radians(360.0) * U);
        near!(tan(to_radians(a)) * cos(to_radians(a)), sin(to_radians(a)), SINE);
    }

    /// Law: the angles (θ, φ) of a point are those it was made from, with θ from +y and φ from +z towards +x,
    /// as the book counts.
    /// Book: spherical coordinates.
    #[test]
    fn spherical_coordinates_go_there_and_back(theta in 0.01..3.13_f64, phi in 0.0..TAU) {
        let p = Vector::new(sin(theta) * sin(phi), cos(theta), sin(theta) * cos(phi));
        let azimuth = atan2(p.x(), p.z());
        let azimuth = if azimuth < 0.0 { azimuth + TAU } else { azimuth };
        prop_assert!((acos(p.y()) - theta).abs() < 1e-12, "θ");
        let turn = (azimuth - phi).abs();
        prop_assert!(turn < 1e-12 || (turn - TAU).abs() < 1e-12, "φ");
    }

    /// Law: the solid angle of an octant is π/2, however the frame is turned. Oracle: the solid angle of a
    /// triangle (van Oosterom & Strackee 1983), `tan(Ω/2) = a·(b × c) / (1 + a·b + b·c + c·a)`.
    /// Book: solid angles.
    #[test]
    fn octants_have_an_eighth_of_the_sphere(n in unit()) {
        let Frame { u, v, w } = Frame::around(n);
        let volume = u.dot(v.cross(w));
        let omega = 2.0 * atan2(volume, 1.0 + u.dot(v) + v.dot(w) + w.dot(u));
        near!(omega, FRAC_PI_2, 1e-14);
        near!(8.0 * omega, 4.0 * PI, 1e-13);
    }
}

/// Law: the axes have the book's angles: φ(+x) = π/2, φ(+z) = 0, φ(−x) = 3π/2, θ(+y) = 0.
/// Book: spherical coordinates.
#[test]
fn the_axes_have_the_books_angles() {
    let azimuth = |n: Normal| atan2(n.x(), n.z()).rem_euclid(TAU);
    assert_eq!(azimuth(Normal::X), FRAC_PI_2);
    assert_eq!(azimuth(Normal::Z), 0.0);
    assert_eq!(azimuth(-Normal::X), 1.5 * PI);
    assert_eq!(acos(Normal::Y.y()), 0.0);
    assert_eq!(acos((-Normal::Y).y()), PI);
}

/// Law: `∫ cosⁿθ dω = 2π/(n + 1)` over the hemisphere. Oracle: the midpoint rule in θ, whose error is
/// h²/24 times the change of slope, here at most n; so 1e-6 with 4000 steps.
/// Book: equation 2.12, the integral of cosⁿθ over the hemisphere.
#[test]
fn powers_of_the_cosine_integrate_over_the_hemisphere() {
    const STEPS: u32 = 4000;
    let h = FRAC_PI_2 / f64::from(STEPS);
    for n in [0.0, 1.0, 1.5, 2.0, 3.0, 10.0, 25.5] {
        let slice = |i: u32| {
            let theta = (f64::from(i) + 0.5) * h;
            TAU * power(cos(theta), n) * sin(theta) * h
        };
        let integral: f64 = (0..STEPS).map(slice).sum();
        assert!((integral - TAU / (n + 1.0)).abs() < 1e-6, "{n}: {integral}");
    }
}
