//! Light without shadows, and the media on its way.

use groundtruth::lights::PointLight as Lamp;
use testkit::properties::*;

use super::media::{SIGMA, matte, shadowless_glass, shadows, through, water};
use crate::prelude::*;
use crate::support::stage::*;

/// The way inside the body of radius 1 about the origin, from a point in it in a unit direction.
fn chord(from: Point, direction: Vector) -> f64 {
    let from = from.to_vector();
    let b = from.dot(direction);
    (b * b + 1.0 - from.length_squared()).sqrt() - b
}

proptest! {
    #![proptest_config(laws())]

    /// Law: light without shadows is absorbed on its way inside the body of the hit only, wherever it stands:
    /// from infinity, outside, inside, beyond or in a second absorbing body, past a bubble, through an
    /// opaque wall. It takes one ray, which a hit in clear air does not. Oracle: `exp(−σ d)`, d the chord
    /// of the sphere by the quadratic, less that of the bubble.
    #[test]
    fn light_without_shadows_is_absorbed_inside_the_body_only(
        (n, up) in normal_and_direction_above(),
        distance in 0.01..8.0_f64,
        is_sun in any::<bool>(),
        has_wall in any::<bool>(),
        has_second in any::<bool>(),
        bubble in prop_oneof![Just(0.0), 0.05..0.2_f64],
    ) {
        let way = Vector::from(n) + up;
        let way = way.unit().expect("n and up are less than 90° apart");
        let mut scene = stage(Rgb::BLACK);
        shadowless_glass(&mut scene);
        scene.materials[0].casts_shadows = true;
        put(&mut scene, Sphere { center: Point::ORIGIN, radius: 0.25, inward: false }, matte());
        let start = Point::ORIGIN + 0.25 * n;
        let inside = chord(start, way);
        if has_wall {
            let (min, max) = (Point::new(-9.0, -9.0, -9.0), Point::new(9.0, 9.0, 9.0));
            put(&mut scene, Cuboid { min, max }, matte());
            put(&mut scene, Sphere { center: start + 0.1 * way, radius: 0.02, inward: false }, matte());
        }
        if has_second {
            let center = start + (inside + 2.0) * way;
            let second = Medium { eta: 1.0, absorption: 3.0 * SIGMA };
            let glass = Dielectric { inside: second, ..Dielectric::default() };
            put(&mut scene, Sphere { center, radius: 1.5, inward: false }, glass);
        }
        if bubble > 0.0 {
            let air = Dielectric { inside: Medium::default(), outside: water(), ..Dielectric::default() };
            let center = start + 0.3 * way;
            put(&mut scene, Sphere { center, radius: bubble, inward: false }, air);
        }
        let (ls, color) = (2.0, Rgb::WHITE);
        match is_sun {
            true => shine(&mut scene, Directional { ls, color, direction: way }),
            false => {
                let location = start + distance * way;
                shine(&mut scene, Lamp { ls, color, location, attenuation: 0.0 })
            }
        };
        scene.lights[0].shadows = false;
        let length = if is_sun { inside } else { inside.min(distance) };
        let in_bubble = if is_sun { 2.0 * bubble } else { (distance - 0.3 + bubble).clamp(0.0, 2.0 * bubble) };
        let eye = Point::ORIGIN + 0.27 * n;
        scene.camera.medium = water();
        let seen = recorded(&built(&scene), eye, -Vector::from(n));
        let [ray] = shadows(&seen)[..] else { panic!("one ray to the light: {seen:?}") };
        let expected = through(length - in_bubble);
        prop_assert!(close(ray.transmittance, expected, 1e-12), "{:?}, not {expected:?}", ray.transmittance);
        prop_assert_eq!(seen.root().folded(), seen.root().radiance);

        scene.camera.medium = Medium::default();
        let clear = counted(&built(&scene), eye, -Vector::from(n));
        prop_assert_eq!(clear.shadow, 0);
    }

    /// Law: light without shadows that leaves its own body is absorbed by the sea outside, less where it passes a body
    /// that absorbs less, and no more where it passes one that absorbs more; after each body the sea goes on. Oracle:
    /// `exp(−σ Σ dᵢ σᵢ)` over the stretches of the straight way, whose lengths the test chooses.
    #[test]
    fn light_without_shadows_passes_body_after_body(
        (n, up) in normal_and_direction_above(),
        own in prop_oneof![0.01..1.0_f64, 1.0..3.0_f64],
        sea in 0.1..2.0_f64,
        bodies in prop::collection::vec((0.1..1.0_f64, 0.1..1.0_f64, prop_oneof![Just(0.0), 0.01..4.0_f64]), 0..4),
        last in 0.1..1.0_f64,
    ) {
        let way = Vector::from(n) + up;
        let way = way.unit().expect("n and up are less than 90° apart");
        let medium = |times: f64| Medium { eta: 1.0, absorption: times * SIGMA };
        let glass = |times| Dielectric { inside: medium(times), outside: medium(sea), ..Dielectric::default() };
        let mut scene = stage(Rgb::BLACK);
        scene.tracer = Tracer::Whitted(Whitted { max_depth: 3 });
        let ball = |center, radius| Sphere { center, radius, inward: false };
        put(&mut scene, ball(Point::ORIGIN, 1.0), glass(own));
        put(&mut scene, ball(Point::ORIGIN, 0.25), matte());
        let start = Point::ORIGIN + 0.25 * n;
        let inside = chord(start, way);
        let (mut at, mut depth) = (inside, own * inside);
        for (gap, radius, times) in bodies {
            at += gap + radius;
            put(&mut scene, ball(start + at * way, radius), glass(times));
            at += radius;
            depth += sea * gap + 2.0 * radius * times.min(sea);
        }
        depth += sea * last;
        let location = start + (at + last) * way;
        shine(&mut scene, Lamp { ls: 2.0, color: Rgb::WHITE, location, attenuation: 0.0 });
        scene.lights[0].shadows = false;
        scene.camera.medium = medium(own);
        let seen = recorded(&built(&scene), Point::ORIGIN + 0.27 * n, -Vector::from(n));
        let [ray] = shadows(&seen)[..] else { panic!("one ray to the light: {seen:?}") };
        close!(ray.transmittance, through(depth), 1e-12);
    }
}
