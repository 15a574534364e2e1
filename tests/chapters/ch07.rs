//! Chapter 7: mapping samples to a hemisphere, and to a sphere.
//!
//! | of the book | what is held | by the law |
//! | --- | --- | --- |
//! | the cosine power distribution | an element of the square maps to a solid angle in inverse proportion to the density `(e + 1) cosᵉθ/2π` on the hemisphere, `1/4π` on the sphere | `solid_angles_are_those_of_the_density` |
//! |  | of the directions of exponent e the share `1 − c^(e+1)` has `cosθ > c`; the angle about z is uniform, and the two are independent | `directions_have_their_density` |
//! | from the unit square to the hemisphere | directions have length 1 and are above the surface, for every exponent and at the ends of the range | `directions_are_unit_and_above` |
//! |  | the point `u₁ = u₂ = 0` maps to the pole, `u₂ → 1` to the horizon, at every exponent; the first coordinate turns from x to y; an infinite exponent gives only the pole | `special_points_have_known_directions` |
//! | uniform and cosine distributions: e = 0 and e = 1 | exponent 0 is uniform in `cosθ = 1 − u₂` exactly, exponent 1 has `cosθ = √(1 − u₂)`, `sinθ = √u₂` | `whole_exponents_have_their_closed_forms` |
//! |  | for e = 1 the directions, projected along z, fill the disk uniformly; and a uniform disk lifted to the hemisphere has the density `cosθ/π` (Malley) | `the_cosine_density_is_a_lifted_disk` |
//! | mapping samples to a sphere | a sphere's points have uniform z and a uniform angle, independent of each other | `sphere_points_are_uniform` |
//!
//! Beyond the book: 3 in this file.

use groundtruth::math::{ONE_MINUS, maps};
use testkit::properties::*;

use crate::prelude::*;
use crate::support::samples::{assert_uniform, random_points};

/// Exponents of the book's lobes, values between them and much larger ones.
const EXPONENTS: [f64; 8] = [0.0, 0.5, 1.0, 2.5, 10.0, 100.0, 1e4, 1e6];

/// Sine and cosine of the angle about z, two powers, products, squares and their sum.
const ROUNDING: f64 = 8.0 * U;

fn exponent() -> impl Strategy<Value = f64> {
    prop_oneof![4 => 0.0..200.0_f64, 2 => proptest::sample::select(&EXPONENTS[..]), 1 => 200.0..1e6]
}

/// Points of the square, also at its ends and within rounding of them.
fn square_point() -> impl Strategy<Value = [f64; 2]> {
    let coordinate = || {
        prop_oneof![
            6 => 0.0..1.0_f64,
            1 => Just(0.0),
            1 => Just(ONE_MINUS),
            1 => 0.0..1e-12,
            1 => 0.0..1e-300,
            1 => 1.0 - 1e-12..1.0
        ]
    };
    [coordinate(), coordinate()]
}

/// The angle about z in turns.
fn turns(v: Vector) -> f64 {
    let turns = atan2(v.y(), v.x()) / (2.0 * PI);
    if turns < 0.0 { turns + 1.0 } else { turns }
}

proptest! {
    #![proptest_config(laws())]

    /// Law: directions have length 1 and are above the surface, for every exponent and at the ends of the
    /// range. Oracle: Pythagoras.
    /// Book: from the unit square to the hemisphere.
    #[test]
    fn directions_are_unit_and_above(u in square_point(), e in exponent()) {
        for direction in [maps::hemisphere(u, e), maps::sphere(u)] {
            prop_assert!((direction.length() - 1.0).abs() < ROUNDING, "{direction:?}");
        }
        at_least!(maps::hemisphere(u, e).z(), 0.0);
    }

    /// Law: an element of the square maps to a solid angle in inverse proportion to the density `(e + 1)
    /// cosᵉθ/2π` on the hemisphere, `1/4π` on the sphere. Oracle: `|∂ω/∂u₁ × ∂ω/∂u₂|` by central differences;
    /// the neighbourhoods of the pole and of `cosθ = 0`, where the third derivatives are large, are left out.
    /// Book: the cosine power distribution.
    #[test]
    fn solid_angles_are_those_of_the_density(
        u1 in 0.01..0.99_f64, u2 in 0.05..0.95_f64, e in 0.0..20.0_f64
    ) {
        const H: f64 = 1e-5;
        let solid_angle = |map: &dyn Fn([f64; 2]) -> Vector| {
            let by_u1 = map([u1 + H, u2]) - map([u1 - H, u2]);
            let by_u2 = map([u1, u2 + H]) - map([u1, u2 - H]);
            by_u1.cross(by_u2).length() / (4.0 * H * H)
        };
        let cos_theta = maps::hemisphere([u1, u2], e).z();
        let expected = 2.0 * PI / ((e + 1.0) * power(cos_theta, e));
        let found = solid_angle(&|u| maps::hemisphere(u, e));
        prop_assert!((found / expected - 1.0).abs() < 1e-6, "{found} for {expected}");
        let sphere = solid_angle(&|[u1, u2]| maps::sphere([u2, u1]));
        prop_assert!((sphere / (4.0 * PI) - 1.0).abs() < 1e-6, "{sphere}");
    }

    /// Law: near the pole sinθ keeps its relative accuracy, however large the exponent. Oracle: the
    /// binomial series of `1 − (1 − u)^x`, x = 2/(e + 1) ≤ 1: its terms are all positive.
    #[test]
    fn polar_angles_are_accurate_near_the_pole(
        u in prop_oneof![0.0..0.5_f64, 0.0..1e-6, 0.0..1e-100],
        e in prop_oneof![1.0..1e3_f64, 1e3..1e6],
    ) {
        let x = 2.0 / (e + 1.0);
        let (mut term, mut series) = (x * u, 0.0);
        for k in 1..80 {
            series += term;
            term *= u * (f64::from(k) - x) / (f64::from(k) + 1.0);
        }
        let v = maps::hemisphere([0.0, u], e);
        prop_assert_eq!(v.y(), 0.0);
        // two square roots of numbers with a few roundings each, and the series' own 80 at most
        prop_assert!(
            (v.x() - series.sqrt()).abs() <= 10.0 * U * v.x(),
            "{} for {}",
            v.x(),
            series.sqrt()
        );
    }

    /// Law: near the poles of the sphere too `sinθ` keeps its relative accuracy. Oracle: `u₁ = sin² θ/2`,
    /// and the sine from the tangent t of θ/2, `2t/(1 + t²)`.
    #[test]
    fn polar_angles_of_the_sphere_are_accurate(
        u in prop_oneof![0.0..1.0_f64, 0.0..1e-6, 0.0..1e-100, 1.0 - 1e-6..1.0]
    ) {
        let t = (u / (1.0 - u)).sqrt();
        let expected = 2.0 * t / (1.0 + t * t);
        let r = maps::sphere([u, 0.0]).x();
        prop_assert!((r - expected).abs() <= ROUNDING * expected, "{r} for {expected}");
    }

    /// Law: the inverses recover the point of the square, for the hemisphere whatever the direction's length.
    /// Oracle: the point itself; at the pole the angle about z is undefined.
    #[test]
    fn the_inverses_undo_the_maps(u in square_point(), e in exponent(), length in 0.1..10.0_f64) {
        // relative, near the poles too; squares of the smallest coordinates are subnormal
        let close =
            |found: f64, expected: f64| (found - expected).abs() <= 1e-13 * expected + 1e-300;
        let around = |found: f64| (found - u[0]).abs().min(1.0 - (found - u[0]).abs()) < ROUNDING;
        let back = maps::hemisphere_inverse(length * maps::hemisphere(u, e), e);
        prop_assert!(back.iter().all(|u| (0.0..1.0).contains(u)), "{back:?}");
        prop_assert!(close(back[1], u[1]), "{back:?}");
        prop_assert!(u[1] < 1e-290 || around(back[0]), "{back:?}");
        let back = maps::sphere_inverse(maps::sphere([u[1], u[0]]));
        prop_assert!(back.iter().all(|u| (0.0..1.0).contains(u)), "{back:?}");
        prop_assert!(close(back[0], u[1]), "{back:?}");
        prop_assert!(u[1] < 1e-290 || around(back[1]), "{back:?}");
    }
}

/// Law: the point `u₁ = u₂ = 0` maps to the pole, `u₂ → 1` to the horizon, at every exponent; the first
/// coordinate turns from x to y; an infinite exponent gives only the pole. The sphere starts at its upper
/// pole.
/// Book: from the unit square to the hemisphere.
#[test]
fn special_points_have_known_directions() {
    for e in EXPONENTS {
        assert_eq!(maps::hemisphere([0.0, 0.0], e), Vector::new(0.0, 0.0, 1.0));
        let low = maps::hemisphere([0.25, ONE_MINUS], e);
        near!(low.z(), power(U, 1.0 / (e + 1.0)), U);
        above!(low.y(), 0.0);
        near!(low.x(), 0.0, U);
        below!(maps::hemisphere([0.5, 0.5], e).x(), 0.0);
    }
    assert_eq!(maps::hemisphere([0.3, 0.7], f64::INFINITY), Vector::new(0.0, 0.0, 1.0));
    assert_eq!(maps::sphere([0.0, 0.3]), Vector::new(0.0, 0.0, 1.0));
    assert_eq!(maps::sphere([0.5, 0.0]), Vector::new(1.0, 0.0, 0.0));
    at_most!(maps::sphere([ONE_MINUS, 0.3]).z(), -1.0 + 2.0 * U);
    assert_eq!(maps::sphere_inverse(Vector::new(0.0, 0.0, 1.0)), [0.0, 0.0]);
    assert_eq!(maps::sphere_inverse(Vector::new(0.0, 0.0, -1.0))[0], ONE_MINUS);
}

/// Law: of the directions of exponent e the share `1 − c^(e+1)` has `cosθ > c`; the angle about z is uniform,
/// and the two are independent. Oracle: Kolmogorov–Smirnov and χ² tests of `cos^(e+1) θ` and the angle.
/// Book: the cosine power distribution.
#[test]
fn directions_have_their_density() {
    for (seed, e) in (70..).zip(EXPONENTS) {
        let points = random_points(20_000, seed).into_iter().map(|u| {
            let v = maps::hemisphere(u, e);
            // of acos, as z is not what the map works with; near the pole the sine tells the angle
            [(1.0 - power(v.z(), e + 1.0)).clamp(0.0, ONE_MINUS), turns(v)]
        });
        assert_uniform(&format!("{e}"), &points.collect::<Vec<_>>(), EXPONENTS.len());
    }
}

/// Law: for e = 1 the directions, projected along z, fill the disk uniformly; and a uniform disk lifted to
/// the hemisphere has the density `cosθ/π` (Malley). Oracle: each map's inverse after the other map; and
/// rejection instead of the map to the disk.
/// Book: uniform and cosine distributions: e = 0 and e = 1.
#[test]
fn the_cosine_density_is_a_lifted_disk() {
    let lift = |[x, y]: [f64; 2]| {
        maps::hemisphere_inverse(Vector::new(x, y, (1.0 - x * x - y * y).max(0.0).sqrt()), 1.0)
    };
    let seen = |u| {
        let v = maps::hemisphere(u, 1.0);
        maps::disk_inverse([v.x(), v.y()])
    };
    let disk = random_points(50_000, 81).into_iter().map(|u| lift(maps::disk(u)));
    assert_uniform("disk", &disk.collect::<Vec<_>>(), 3);
    let rejected = maps::disk_by_rejection(random_points(50_000, 82)).map(lift);
    assert_uniform("rejected", &rejected.collect::<Vec<_>>(), 3);
    let lowered = random_points(50_000, 83).into_iter().map(seen);
    assert_uniform("lowered", &lowered.collect::<Vec<_>>(), 3);
}

/// Law: a sphere's points have uniform z and a uniform angle, independent of each other. Oracle: Archimedes.
/// Book: mapping samples to a sphere.
#[test]
fn sphere_points_are_uniform() {
    let points = random_points(100_000, 85).into_iter().map(|u| {
        let v = maps::sphere(u);
        [(0.5 * (v.z() + 1.0)).min(ONE_MINUS), turns(v)]
    });
    assert_uniform("points", &points.collect::<Vec<_>>(), 1);
}

/// Law: exponent 0 is uniform in `cosθ = 1 − u₂` exactly, exponent 1 has `cosθ = √(1 − u₂)`,
/// `sinθ = √u₂`. Oracle: the square root, which is correctly rounded.
/// Book: uniform and cosine distributions: e = 0 and e = 1.
#[test]
fn whole_exponents_have_their_closed_forms() {
    for u2 in [0.0, 1e-9, 0.1, 0.25, 0.5, 0.75, 0.9, ONE_MINUS] {
        assert_eq!(maps::hemisphere([0.0, u2], 0.0).z(), 1.0 - u2);
        let v = maps::hemisphere([0.0, u2], 1.0);
        near!(v.z(), (1.0 - u2).sqrt(), U * v.z());
        near!(v.x(), u2.sqrt(), 2.0 * U * v.x());
        // the same angle in two ways
        let theta = acos(v.z());
        near!(theta, atan2(v.x(), v.z()), 1e-8);
    }
}
