//! Shadow rays through absorbing media.

use groundtruth::lights::{AmbientOccluder, Kind, PointLight as Lamp};
use groundtruth::scene::TransparentShadows;
use groundtruth::trace::{RecordedRay, TermSource};
use testkit::properties::*;

use crate::prelude::*;
use crate::support::lamps::all_lights;
use crate::support::stage::*;

/// Per unit of length; blue is not absorbed.
pub(super) const SIGMA: Rgb = Rgb::new(0.3, 0.7, 0.0);

/// `exp(−σ d)` in each channel.
pub(super) fn through(distance: f64) -> Rgb {
    let [r, g, b] = SIGMA.to_array().map(|sigma| exp(-sigma * distance));
    Rgb::new(r, g, b)
}

pub(super) fn water() -> Medium {
    Medium { eta: 1.0, absorption: SIGMA }
}

pub(super) fn matte() -> Matte {
    Matte { ka: 0.5.into(), kd: 1.0.into(), cd: Rgb::WHITE.into() }
}

/// A floor under water; the camera is under water too.
fn sea(source: impl Into<Kind>) -> Scene {
    let mut scene = stage(Rgb::BLACK);
    scene.camera.medium = water();
    put(&mut scene, Plane { point: Point::ORIGIN, normal: Vector::Y }, matte());
    shine(&mut scene, source);
    scene
}

pub(super) fn shadows(tree: &RayTree) -> Vec<&RecordedRay> {
    tree.rays().into_iter().filter(|node| matches!(node.kind, RayKind::Shadow { .. })).collect()
}

/// The length of a shadow ray lacks its offsets from the surface and from the light, of some error bounds
/// each.
const OFFSETS: f64 = 4096.0 * U;

/// A ball of absorbing glass that casts no shadow, of radius 1, without refraction.
pub(super) fn shadowless_glass(scene: &mut Scene) {
    scene.tracer = Tracer::Whitted(Whitted { max_depth: 3 });
    let sphere = Sphere { center: Point::ORIGIN, radius: 1.0, inward: false };
    put(scene, sphere, Dielectric { inside: water(), ..Dielectric::default() });
    scene.materials.last_mut().expect("just put").casts_shadows = false;
}

/// Law: light that reaches a surface inside glass which casts no shadow is absorbed inside the glass only.
/// Oracle: `exp(−σ/2)` twice, from the sun and to the eye, for a ball of half the radius.
#[test]
fn shadowless_glass_absorbs_only_inside() {
    let mut scene = stage(Rgb::BLACK);
    shadowless_glass(&mut scene);
    put(&mut scene, Sphere { center: Point::ORIGIN, radius: 0.5, inward: false }, matte());
    shine(&mut scene, Directional { ls: 2.0, color: Rgb::WHITE, direction: Vector::Y });
    let seen = look(&built(&scene), Point::new(0.0, 4.0, 0.0), -Vector::Y);
    close!(seen, (2.0 * FRAC_1_PI) * through(1.0), OFFSETS);
}

/// Law: glass that casts no shadow does not colour the light that passes it, whether transparent shadows are
/// attenuated or not. Oracle: the floor without the glass.
#[test]
fn shadowless_glass_leaves_no_shadow_on_the_floor() {
    let floor = |has_glass: bool, shadows| {
        let mut scene = stage(Rgb::BLACK);
        scene.transparency.shadows = shadows;
        if has_glass {
            shadowless_glass(&mut scene);
        }
        let point = Point::new(0.0, -2.0, 0.0);
        put(&mut scene, Plane { point, normal: Vector::Y }, matte());
        shine(&mut scene, Directional { ls: 2.0, color: Rgb::WHITE, direction: Vector::Y });
        look(&built(&scene), Point::new(3.0, -1.0, 0.0), Vector::new(-3.0, -1.0, 0.0))
    };
    for shadows in [TransparentShadows::Opaque, TransparentShadows::Attenuated] {
        let bare = floor(false, shadows);
        close!(bare, (2.0 * FRAC_1_PI) * Rgb::WHITE, OFFSETS);
        assert_eq!(floor(true, shadows), bare, "{shadows:?}");
    }
}

/// Law: a sun without shadows outside absorbing glass lights the ball inside as if glass and ball cast no
/// shadow. Oracle: the same scene with shadows, and with objects that cast none.
#[test]
fn a_sun_without_shadows_sees_shadowless_objects() {
    for direction in [Vector::new(0.3, 1.0, 0.2), Vector::new(-0.5, 0.1, 0.4)] {
        let mut scene = stage(Rgb::BLACK);
        shadowless_glass(&mut scene);
        put(&mut scene, Sphere { center: Point::ORIGIN, radius: 0.5, inward: false }, matte());
        shine(&mut scene, Directional { ls: 2.0, color: Rgb::WHITE, direction });
        let mut unshadowed = scene.clone();
        unshadowed.lights[0].shadows = false;
        unshadowed.materials[0].casts_shadows = true;
        scene.materials[1].casts_shadows = false;
        let [shadowed, unshadowed] = [scene, unshadowed]
            .map(|scene| look(&built(&scene), Point::new(0.0, 4.0, 0.1), -Vector::Y));
        assert!(shadowed.r > 0.01);
        close!(unshadowed, shadowed, OFFSETS, "{direction:?}");
    }
}

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
        prop_assert!(
            close(shadow.transmittance, expected, OFFSETS),
            "the shadow ray's transmittance is {:?}, expected {expected:?}", shadow.transmittance
        );
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
        prop_assert!(
            close(seen, expected, 16.0 * U / direction.y()),
            "{seen:?}, expected {expected:?}"
        );
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
            assert!(
                close(found, expected, 64.0 * U),
                "light {light}: {found:?}, expected {expected:?}"
            );
            *seen.entry(light).or_insert(0) += 1;
        }
    }
    // plain ambient light casts no ray
    assert_eq!(seen.len(), scene.lights.len() - 1, "{seen:?}");
}

/// A glass ball of radius 2, filled with coloured water, around a small matte ball.
fn aquarium(location: Point) -> Scene {
    let mut scene = stage(Rgb::BLACK);
    scene.tracer = Tracer::Whitted(Whitted { max_depth: 2 });
    let glass = Dielectric { phong: Phong::default(), inside: water(), outside: Medium::default() };
    put(&mut scene, Sphere { center: Point::ORIGIN, radius: 2.0, inward: false }, glass);
    put(&mut scene, Sphere { center: Point::ORIGIN, radius: 0.5, inward: false }, matte());
    shine(&mut scene, Lamp { ls: 2.0, color: Rgb::WHITE, location, attenuation: 0.0 });
    scene
}

/// Law: a surface inside a dielectric is lit through the medium inside: the shadow ray has the transmittance
/// of its path to a lamp inside, and the path to the eye is dimmed inside only. A lamp outside is hidden by
/// the boundary, as shadow rays are not refracted. Oracle: Beer's law for the two distances; equal indices,
/// so that rays pass unchanged.
#[test]
fn a_surface_inside_a_dielectric_is_lit_through_its_medium() {
    let eye = Point::new(0.0, 0.0, 9.0);
    for far in [0.2, 0.7, 1.4] {
        let point = Point::new(0.0, 0.0, 0.5);
        let location = point + far * Vector::new(0.6, 0.0, 0.8);
        let tree = recorded(&built(&aquarium(location)), eye, -Vector::Z);
        let inside = shadows(&tree).into_iter().find(|node| node.ray.origin.z() < 1.9);
        let shadow = inside.expect("a shadow ray from the matte ball");
        let expected = through(far);
        let found = shadow.transmittance;
        close!(found, expected, OFFSETS, "lamp at {far}");
        let seen = tree.root().radiance;
        let expected = (2.0 * FRAC_1_PI * 0.8) * (through(far) * through(1.5));
        close!(seen, expected, OFFSETS, "lamp at {far}");
    }
    let outside = recorded(&built(&aquarium(Point::new(0.0, 0.0, 5.0))), eye, -Vector::Z);
    assert_eq!(outside.root().radiance, Rgb::BLACK);
    assert!(!shadows(&outside).is_empty(), "its shadow rays are cast and blocked");
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
        put(&mut scene, Sphere { center: Point::ORIGIN, radius: 1.0, inward: false }, glass);
        let location = Point::new(0.5, 0.0, 4.0);
        shine(&mut scene, Lamp { ls: 2.0, color: Rgb::WHITE, location, attenuation: 0.0 });
        let tree = recorded(&built(&scene), Point::new(0.0, 0.0, 9.0), -Vector::Z);
        let [shadow] = shadows(&tree)[..] else { panic!("one light, one shadow ray: {tree:?}") };
        let length = location.distance(Point::new(0.0, 0.0, 1.0));
        let expected = if outside == water() { through(length) } else { Rgb::WHITE };
        let found = shadow.transmittance;
        assert!(
            close(found, expected, OFFSETS),
            "outside {outside:?}: {found:?}, expected {expected:?}"
        );
        let direct = |term: &&groundtruth::trace::RecordedTerm| {
            matches!(term.source, TermSource::Direct { .. })
        };
        assert!(tree.root().terms.iter().any(|term| direct(&term)), "there is a highlight");
    }
}
