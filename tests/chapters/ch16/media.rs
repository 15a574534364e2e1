//! Shadow rays through absorbing media, and light without shadows.

use explain::RecordedRay;
use groundtruth::lights::{AmbientOccluder, Kind, PointLight as Lamp};
use groundtruth::trace::TermSource;
use testkit::properties::*;

use crate::prelude::*;
use crate::support::lamps::all_lights;
use crate::support::stage::*;

/// Per unit of length; blue is not absorbed.
const SIGMA: Rgb = Rgb::new(0.3, 0.7, 0.0);

/// `exp(−σ d)` in each channel.
fn through(distance: f64) -> Rgb {
    let [r, g, b] = SIGMA.to_array().map(|sigma| exp(-sigma * distance));
    Rgb::new(r, g, b)
}

fn water() -> Medium {
    Medium { eta: 1.0, absorption: SIGMA }
}

fn white() -> Matte {
    matte(0.5, 1.0, Rgb::WHITE)
}

/// A floor under water; the camera is under water too.
fn sea(source: impl Into<Kind>) -> Scene {
    let mut scene = stage(Rgb::BLACK);
    scene.camera.medium = water();
    put(&mut scene, ground(0.0), white());
    shine(&mut scene, source);
    scene
}

fn shadows(tree: &RayTree) -> Vec<&RecordedRay> {
    tree.rays().into_iter().filter(|node| matches!(node.kind, RayKind::Shadow { .. })).collect()
}

/// The length of a shadow ray lacks its offsets from the surface and from the light, of some error bounds
/// each.
const OFFSETS: f64 = 4096.0 * U;

proptest! {
    #![proptest_config(laws())]

    /// Law: in an absorbing medium light is dimmed twice: `exp(−σ d)` from the lamp to the surface
    /// and again to the eye; the shadow ray records the first. Oracle: the closed form, with the
    /// distances of the three points (Beer).
    #[test]
    fn a_lamp_under_water_is_dimmed_on_both_ways(
        (x, y, z) in (-3.0..3.0_f64, 0.2..5.0_f64, -3.0..3.0_f64),
        (ex, ey, ez) in (-3.0..3.0_f64, 0.2..5.0_f64, -3.0..3.0_f64),
    ) {
        let (location, eye) = (Point::new(x, y, z), Point::new(ex, ey, ez));
        let scene = sea(Lamp { ls: 2.0, color: Rgb::WHITE, location, attenuation: 0.0 });
        let tree = recorded(&built(&scene), eye, Point::ORIGIN - eye);
        let [to_lamp, to_eye] = [location, eye].map(|p| p.distance(Point::ORIGIN));
        let [shadow] = shadows(&tree)[..] else { panic!("one light, one shadow ray: {tree:?}") };
        let expected = through(to_lamp);
        close!(shadow.transmittance, expected, OFFSETS);
        let expected = (2.0 * FRAC_1_PI * y / to_lamp) * (through(to_lamp) * through(to_eye));
        let seen = tree.root().radiance;
        close!(seen, expected, 2.0 * OFFSETS);
    }

    /// Law: of light from infinitely far away an absorbing medium transmits nothing, except in channels that
    /// it does not absorb. Oracle: the limits 0 and 1.
    #[test]
    fn no_light_comes_through_infinitely_much_water(
        (ex, ey) in (-3.0..3.0_f64, 0.2..5.0_f64),
        (n, up) in normal_and_direction_above(),
    ) {
        prop_assume!(up.y().abs() > 0.01);
        let direction = up.y().signum() * up;
        let scene = sea(Directional { ls: 2.0, color: Rgb::WHITE, direction });
        let eye = Point::new(ex, ey, n.x());
        let tree = recorded(&built(&scene), eye, Point::ORIGIN - eye);
        let [shadow] = shadows(&tree)[..] else { panic!("one light, one shadow ray: {tree:?}") };
        prop_assert_eq!(shadow.transmittance, Rgb::new(0.0, 0.0, 1.0));
        let expected = Rgb::new(0.0, 0.0, 2.0 * FRAC_1_PI * direction.y());
        let seen = tree.root().radiance;
        close!(seen, expected, 16.0 * U / direction.y());
    }

    /// Law: ambient light, plain or occluded, has no path length to the surface and is not dimmed there. Only
    /// the path to the eye dims it. Oracle: the product `k_a l_s exp(−σ d)`.
    #[test]
    fn ambient_light_is_dimmed_on_the_way_to_the_eye_only(
        (ex, ey, ez) in (-3.0..3.0_f64, 0.2..5.0_f64, -3.0..3.0_f64),
    ) {
        let (ls, color, eye) = (1.5, Rgb::new(1.0, 0.5, 0.75), Point::new(ex, ey, ez));
        let occluder = AmbientOccluder {
            ls,
            color,
            min_amount: 0.0,
            occluded_color: None,
            max_distance: None,
        };
        let within = AmbientOccluder { max_distance: Some(4.0), ..occluder.clone() };
        for source in [Kind::from(Ambient { ls, color }), occluder.into(), within.into()] {
            let tree = recorded(&built(&sea(source)), eye, Point::ORIGIN - eye);
            for shadow in shadows(&tree) {
                prop_assert_eq!(shadow.transmittance, Rgb::WHITE);
            }
            let expected = (0.5 * ls) * (color * through(eye.distance(Point::ORIGIN)));
            let seen = tree.root().radiance;
            close!(seen, expected, 64.0 * U);
        }
    }

    /// Law: without shadows no ray is cast and no object blocks the light, but the medium dims it all the
    /// same. Oracle: clear air, times `exp(−σ d)` of both paths.
    #[test]
    fn without_shadows_the_medium_dims_a_lamp_all_the_same(
        (x, y, z) in (-3.0..3.0_f64, 0.2..5.0_f64, -3.0..3.0_f64),
    ) {
        let (location, eye) = (Point::new(x, y, z), Point::new(1.0, 2.0, 2.0));
        let mut scene = sea(Lamp { ls: 2.0, color: Rgb::WHITE, location, attenuation: 0.0 });
        scene.lights[0].shadows = false;
        let tree = recorded(&built(&scene), eye, Point::ORIGIN - eye);
        prop_assert_eq!(shadows(&tree).len(), 0);
        scene.camera.medium = Medium::default();
        let clear = look(&built(&scene), eye, Point::ORIGIN - eye);
        let expected = through(3.0) * (through(location.distance(Point::ORIGIN)) * clear);
        let seen = tree.root().radiance;
        close!(seen, expected, 64.0 * U);
    }
}

/// Law: for every kind of light, a shadow ray records the transmittance of its own length: 0 from infinity;
/// that of ambient light is 1. Oracle: `exp(−σ |ray|)` for a segment, which the ray spans from t = 0 to 1;
/// for all kinds of light, sampled.
#[test]
fn each_shadow_ray_records_the_transmittance_of_its_length() {
    let mut scene = all_lights();
    scene.camera.medium = water();
    let world = built(&scene);
    let eye = Point::new(1.0, 1.8, 4.0);
    let mut seen = std::collections::BTreeMap::new();
    for i in 0..60 {
        let spot = Point::new(0.1 * f64::from(i % 8) - 0.4, 0.1 * f64::from(i / 8), 0.3);
        let mut tree = RayTree::of(&world);
        radiance(&world, &ray(eye, spot - eye), world.draws([i, 1], 0), &mut tree);
        for node in shadows(&tree) {
            let RayKind::Shadow { light } = node.kind else { unreachable!() };
            let expected = match scene.lights[light as usize].source {
                Kind::Ambient(_) | Kind::AmbientOccluder(_) => Rgb::WHITE,
                Kind::Directional(_) | Kind::JitteredDirectional(_) | Kind::Environment(_) => {
                    Rgb::new(0.0, 0.0, 1.0)
                }
                _ => through(node.ray.direction.length()),
            };
            let found = node.transmittance;
            close!(found, expected, 64.0 * U, "light {light}");
            *seen.entry(light).or_insert(0) += 1;
        }
    }
    // plain ambient light casts no ray
    assert_eq!(seen.len(), scene.lights.len() - 1, "{seen:?}");
}

/// Law: the light of a highlight on a boundary passes through the medium on the light's side, that outside
/// the ball, whatever the camera's medium is. Oracle: the transmittances 1 and `exp(−σ d)`.
#[test]
fn a_highlight_on_a_boundary_comes_through_the_medium_outside() {
    let phong = Phong { ks: 0.5.into(), exponent: 4.0.into(), ..Phong::default() };
    for (outside, inside) in [(Medium::default(), water()), (water(), Medium::default())] {
        let mut scene = stage(Rgb::BLACK);
        scene.camera.medium = Medium { eta: 1.0, absorption: Rgb::new(0.0, 0.1, 0.2) };
        let glass = Dielectric { phong: phong.clone(), inside, outside };
        put(&mut scene, sphere(Point::ORIGIN, 1.0), glass);
        let location = Point::new(0.5, 0.0, 4.0);
        shine(&mut scene, Lamp { ls: 2.0, color: Rgb::WHITE, location, attenuation: 0.0 });
        let tree = recorded(&built(&scene), Point::new(0.0, 0.0, 9.0), -Vector::Z);
        let [shadow] = shadows(&tree)[..] else { panic!("one light, one shadow ray: {tree:?}") };
        let length = location.distance(Point::new(0.0, 0.0, 1.0));
        let expected = if outside == water() { through(length) } else { Rgb::WHITE };
        let found = shadow.transmittance;
        close!(found, expected, OFFSETS, "outside {outside:?}");
        let direct =
            |term: &&explain::RecordedTerm| matches!(term.source, TermSource::Direct { .. });
        assert!(tree.root().terms.iter().any(|term| direct(&term)), "there is a highlight");
    }
}

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
        scene.tracer = Tracer::Whitted(Whitted { max_depth: 3 });
        put(&mut scene, sphere(Point::ORIGIN, 1.0), Dielectric { inside: water(), ..Dielectric::default() });
        put(&mut scene, sphere(Point::ORIGIN, 0.25), white());
        let start = Point::ORIGIN + 0.25 * n;
        let inside = chord(start, way);
        if has_wall {
            let (min, max) = (Point::new(-9.0, -9.0, -9.0), Point::new(9.0, 9.0, 9.0));
            put(&mut scene, boxed(min, max), white());
            put(&mut scene, sphere(start + 0.1 * way, 0.02), white());
        }
        if has_second {
            let center = start + (inside + 2.0) * way;
            let second = Medium { eta: 1.0, absorption: 3.0 * SIGMA };
            let glass = Dielectric { inside: second, ..Dielectric::default() };
            put(&mut scene, sphere(center, 1.5), glass);
        }
        if bubble > 0.0 {
            let air = Dielectric { inside: Medium::default(), outside: water(), ..Dielectric::default() };
            let center = start + 0.3 * way;
            put(&mut scene, sphere(center, bubble), air);
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
        put(&mut scene, sphere(Point::ORIGIN, 1.0), glass(own));
        put(&mut scene, sphere(Point::ORIGIN, 0.25), white());
        let start = Point::ORIGIN + 0.25 * n;
        let inside = chord(start, way);
        let (mut at, mut depth) = (inside, own * inside);
        for (gap, radius, times) in bodies {
            at += gap + radius;
            put(&mut scene, sphere(start + at * way, radius), glass(times));
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
