//! Shadow rays through absorbing media, and light without shadows.

use explain::RecordedRay;
use groundtruth::lights::{Kind, PointLight as Lamp};
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

fn shadows(tree: &RayTree) -> Vec<&RecordedRay> {
    tree.rays().into_iter().filter(|node| matches!(node.kind, RayKind::Shadow { .. })).collect()
}

/// The length of a shadow ray lacks its offsets from the surface and from the light, of some error bounds
/// each.
const OFFSETS: f64 = 4096.0 * U;

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
