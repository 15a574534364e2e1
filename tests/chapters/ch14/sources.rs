//! Point and spot lights: how they fade with distance, and the edges of a spot.

use groundtruth::lights::{Kind, PointLight as Lamp, Spot};
use testkit::properties::*;

use crate::prelude::*;
use crate::support::stage::*;

/// Angles by the arc tangent, a polynomial of them, a power, and products: some roundings each.
const ROUNDING: f64 = 64.0 * U;

/// A white plane in the light of one source.
fn plane(normal: Normal, source: impl Into<Kind>) -> Scene {
    let mut scene = stage(Rgb::BLACK);
    let white = matte(0.0, 1.0, Rgb::WHITE);
    put(&mut scene, Plane { point: Point::ORIGIN, normal: normal.into() }, white);
    shine(&mut scene, source);
    scene
}

/// The radiance of the origin, seen from a direction beside the normal.
fn seen(scene: &Scene, normal: Normal) -> Rgb {
    let to_eye = at_angle(normal, 0.4, 2.0);
    look(&built(scene), Point::ORIGIN + 1e-3 * to_eye, -to_eye)
}

/// A spot light at `far · towards` whose axis leans by `angle` degrees from the direction to the origin.
fn spot(towards: Vector, far: f64, angle: f64, turn: f64, inner: f64, outer: f64) -> Spot {
    let back = Normal::new(-towards).expect("a unit vector");
    let lean = to_radians(angle);
    let across = at_angle(back, 0.0, turn);
    Spot {
        ls: 3.0,
        color: Rgb::new(1.0, 0.5, 0.25),
        location: Point::ORIGIN + far * towards,
        // any length
        direction: 0.3 * (cos(lean) * Vector::from(back) + sin(lean) * across),
        inner,
        outer,
        attenuation: 0.0,
    }
}

proptest! {
    #![proptest_config(laws())]

    /// Law: at the angle a from its axis a spot light sends the share `s² (3 − 2s)`, `s = (outer − a)/(outer
    /// − inner)`, of the light `l_s c_l/d^k`: coloured, and fading as a point light. Oracle: that polynomial,
    /// at the angle from which the light is built; the code finds it by an arc tangent.
    #[test]
    fn a_spot_light_falls_off_by_a_smooth_step(
        (n, towards) in normal_and_direction_above(),
        (inner, width) in (0.0..80.0_f64, 1.0..80.0_f64),
        (at, turn) in (0.0..1.0_f64, 0.0..TAU),
        (far, k) in (0.1..100.0_f64, prop_oneof![Just(0.0), Just(1.0), Just(2.0), 0.0..3.0_f64]),
    ) {
        let outer = inner + width;
        let light =
            Spot { attenuation: k, ..spot(towards, far, inner + at * width, turn, inner, outer) };
        let s = 1.0 - at;
        let share = s * s * (3.0 - 2.0 * s);
        let cosine = n.dot(towards);
        let expected = (share * cosine * FRAC_1_PI * 3.0 / power(far, k)) * light.color;
        let found = seen(&plane(n, light), n);
        // an angle has an error of some u of 180°, so s has one of `180 u/width`, which the step multiplies
        // by `1.5`; the cosine of a grazing light has one of some u
        let tolerance =
            ROUNDING * expected.r.abs() + (power(far, -k) + 1.0) * (2e4 * U / width + 64.0 * U);
        for (found, expected) in found.to_array().into_iter().zip(expected.to_array()) {
            near!(found, expected, tolerance);
        }
    }

    /// Law: up to `inner` a spot light is the point light, bit for bit; from `outer` on it is dark
    /// and nothing is traced; with `inner = outer` the edge is sharp; with 180° it is the point
    /// light everywhere. Oracle: that point light, and the counters.
    #[test]
    fn a_spot_light_is_a_point_light_inside_and_dark_outside(
        (n, towards) in normal_and_direction_above(),
        (inner, width) in (0.0..120.0_f64, prop_oneof![Just(0.0), 0.0..59.0_f64]),
        (share, turn) in (1e-9..1.0_f64, 0.0..TAU),
        k in 0.0..3.0_f64,
    ) {
        let outer = inner + width;
        let point =
            |&Spot { ls, color, location, .. }: &Spot| Lamp { ls, color, location, attenuation: k };
        let with = |angle, inner, outer| Spot {
            attenuation: k,
            ..spot(towards, 2.0, angle, turn, inner, outer)
        };
        // not nearer to the edges than the accuracy of angles
        let within = with((1.0 - share) * (inner - 1e-9).max(0.0), inner, outer);
        if inner > 1e-6 {
            prop_assert_eq!(seen(&plane(n, within.clone()), n), seen(&plane(n, point(&within)), n));
        }
        let beyond = with(outer + 1e-9 + share * (179.9 - outer), inner, outer);
        prop_assert_eq!(seen(&plane(n, beyond.clone()), n), Rgb::BLACK);
        let to_eye = at_angle(n, 0.4, 2.0);
        let counts = counted(&built(&plane(n, beyond)), Point::ORIGIN + to_eye, -to_eye);
        prop_assert_eq!(counts, RayCounts { camera: 1, ..RayCounts::default() });
        let everywhere = with(179.0 * share, 180.0, 180.0);
        prop_assert_eq!(
            seen(&plane(n, everywhere.clone()), n),
            seen(&plane(n, point(&everywhere)), n)
        );
    }

}
