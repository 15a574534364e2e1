//! The lights that add nothing at a hit, and the sentence about a black ray.

use groundtruth::explain::RecordedRay;
use groundtruth::lights::{Spot, Unlit};
use groundtruth::math::sin_cos;
use groundtruth::shapes::Sampling;
use proptest::test_runner::RngSeed;
use testkit::properties::*;

use crate::prelude::*;

/// A few operations on unit vectors and on points near the origin.
const ROUNDING: f64 = 1e-12;

fn cases() -> ProptestConfig {
    ProptestConfig {
        cases: 64,
        rng_seed: RngSeed::Fixed(2007),
        failure_persistence: None,
        ..ProptestConfig::default()
    }
}

fn unit() -> impl Strategy<Value = Vector> {
    let component = || -1.0..1.0_f64;
    (component(), component(), component())
        .prop_map(|(x, y, z)| Vector::new(x, y, z))
        .prop_filter_map("not near zero", |v| if v.length() > 0.1 { v.unit() } else { None })
}

fn matte(kd: f64, cd: Rgb) -> Matte {
    Matte { ka: 0.0.into(), kd: kd.into(), cd: cd.into() }
}

/// A disk of this material about the origin, seen from `eye`.
fn disk(normal: Vector, eye: Vector, recipe: impl Into<materials::Kind>) -> Scene {
    let camera =
        Viewpoint::new(Point::ORIGIN + 5.0 * eye, Point::ORIGIN, Orthographic { zoom: 1.0 });
    let mut scene = Scene::new("", Image { pixel_size: 1e-6, ..Image::new(1, 1) }, camera);
    scene.camera.up = Vector::new(0.3, 0.5, -0.8);
    scene.materials = vec![Material::new("disk", recipe)];
    let shape = Disk { center: Point::ORIGIN, normal, radius: 1.0 };
    scene.objects = vec![Object::new("disk", "disk", shape)];
    scene
}

/// The same with one light.
fn lit(mut scene: Scene, light: impl Into<lights::Kind>) -> Scene {
    scene.lights = vec![Light::new("light", light)];
    scene
}

fn sun(direction: Vector) -> Directional {
    Directional { ls: 1.0, color: Rgb::WHITE, direction }
}

/// The camera's ray.
fn ray(scene: &Scene) -> RecordedRay {
    let world = World::build(scene).expect("the scene is valid");
    explain::sample(scene, &world, [0, 0], 0).ray.expect("the camera sees all its film")
}

/// Why the only light adds nothing to a black picture.
fn reason(scene: &Scene) -> Unlit {
    let ray = ray(scene);
    assert!(ray.radiance.is_black() && ray.unlit.len() == 1, "{ray:#?}");
    let text = ray.unlit[0].reason.to_string();
    let black = ray.black.expect("a reason");
    assert!(black.contains(&text), "`{black}` does not say `{text}`");
    ray.unlit[0].reason.clone()
}

fn near(found: f64, expected: f64) -> bool {
    (found - expected).abs() <= ROUNDING * expected.abs().max(1.0)
}

proptest! {
    #![proptest_config(cases())]

    /// Law: a light below the plane of a surface that is seen from above is behind the surface, with the
    /// cosine of its angle; a surface seen from below has a viewer behind it, unless it is two-sided.
    /// Oracle: dot products of the given directions.
    #[test]
    fn lights_and_viewers_behind_a_surface(
        (n, eye, light) in (unit(), unit(), unit()),
        two_sided in any::<bool>(),
    ) {
        let (cos_o, cos_i) = (n.dot(eye), n.dot(light));
        prop_assume!(cos_o.abs() > 0.05 && cos_i.abs() > 0.05);
        let mut scene = lit(disk(n, eye, matte(0.5, Rgb::WHITE)), sun(light));
        scene.materials[0].two_sided = two_sided;
        let cos_i = if two_sided { cos_i * cos_o.signum() } else { cos_i };
        if (two_sided || cos_o > 0.0) && cos_i > 0.0 {
            let ray = ray(&scene);
            prop_assert!(ray.unlit.is_empty() && ray.black.is_none());
            prop_assert!(near(ray.radiance.r, 0.5 / PI * cos_i));
            return Ok(());
        }
        match reason(&scene) {
            Unlit::ViewerBehind { cos_o: found } => {
                prop_assert!(!two_sided && cos_o < 0.0 && near(found, cos_o), "{found}, {cos_o}");
            }
            Unlit::BehindSurface { cos_i: found } => {
                prop_assert!((two_sided || cos_o > 0.0) && near(found, cos_i), "{found}, {cos_i}");
            }
            other => prop_assert!(false, "{other:?}"),
        }
    }

    /// Law: a light between the plane of an interpolated normal and that of the true one is behind the true
    /// surface. Oracle: the dot products of a light chosen between both planes.
    #[test]
    fn lights_behind_the_true_surface(angle in 0.2..0.6_f64, share in 0.1..0.9_f64) {
        let (sin, cos) = sin_cos(angle);
        let leaning = Vector::new(sin, cos, 0.0);
        // by `share · angle` below the plane y = 0
        let (sin_below, cos_below) = sin_cos(share * angle);
        let light = Vector::new(cos_below, -sin_below, 0.0);
        let mut scene = lit(disk(Vector::new(0.0, 1.0, 0.0), leaning, matte(0.5, Rgb::WHITE)), sun(light));
        let vertices =
            [[-9.0, 0.0, -9.0], [0.0, 0.0, 9.0], [9.0, 0.0, -9.0]].map(|[x, y, z]| Point::new(x, y, z));
        let normals = Some([leaning; 3]);
        scene.objects = vec![Object::new("disk", "disk", Triangle { vertices, normals })];
        match reason(&scene) {
            Unlit::BehindTrueSurface { cos_i } => prop_assert!(near(cos_i, -sin_below)),
            other => prop_assert!(false, "{other:?}"),
        }
    }

    /// Law: a hit outside the cone of a spot light has its angle to the axis. Oracle: the arc cosine.
    #[test]
    fn hits_outside_a_cone((axis, towards) in (unit(), unit()), outer in 1.0..80.0_f64) {
        let y = Vector::new(0.0, 1.0, 0.0);
        prop_assume!(towards.dot(y) > 0.1);
        let angle = to_degrees(acos(-towards.dot(axis)));
        prop_assume!(angle > outer + 1e-3);
        let location = Point::ORIGIN + 3.0 * towards;
        let (ls, color, inner, attenuation) = (1.0, Rgb::WHITE, 0.5 * outer, 0.0);
        let spot = Spot { ls, color, location, direction: axis, inner, outer, attenuation };
        match reason(&lit(disk(y, y, matte(0.5, Rgb::WHITE)), spot)) {
            Unlit::OutsideCone { angle: found, outer: found_outer } => {
                // the arc cosine loses digits near 0 and 180 degrees
                prop_assert!((found - angle).abs() < 1e-5 && found_outer == outer, "{found}, {angle}");
            }
            other => prop_assert!(false, "{other:?}"),
        }
    }

    /// Law: a hit behind a one-sided lamp has the lamp's cosine. Oracle: the dot product with the only
    /// point of a lamp too small to matter.
    #[test]
    fn hits_behind_a_lamp((normal, towards) in (unit(), unit())) {
        let y = Vector::new(0.0, 1.0, 0.0);
        let cosine = -normal.dot(towards);
        // the camera, straight above, does not see the lamp
        prop_assume!((0.1..0.99).contains(&towards.dot(y)) && cosine < -0.05);
        let mut scene = disk(y, y, matte(0.5, Rgb::WHITE));
        scene.materials.push(Material::new("lamp", Emissive::new(1.0, Rgb::WHITE)));
        let center = Point::ORIGIN + 3.0 * towards;
        let lamp = Disk { center, normal, radius: 1e-14 };
        scene.objects.push(Object::new("lamp", "lamp", lamp));
        let sampling = Some(Sampling::Area);
        match reason(&lit(scene, Area { object: "lamp".to_owned(), sampling })) {
            Unlit::BehindLamp { cos_lamp } => prop_assert!(near(cos_lamp, cosine)),
            other => prop_assert!(false, "{other:?}"),
        }
    }
}

/// The disk in the plane y = 0, seen from above, under a light from above.
fn simple(recipe: impl Into<materials::Kind>, light: impl Into<lights::Kind>) -> Scene {
    let up = Vector::new(0.0, 1.0, 0.0);
    lit(disk(up, up, recipe), light)
}

fn white() -> Matte {
    matte(0.5, Rgb::WHITE)
}

/// Light from above, off the camera's axis.
fn above() -> Directional {
    sun(Vector::new(0.3, 1.0, 0.0))
}

/// Law: each factor that is 0 by itself is the reason. Oracle: scenes in which one factor is 0.
#[test]
fn each_factor_can_be_zero() {
    let red = Rgb::new(1.0, 0.0, 0.0);
    let ambient = Ambient { ls: 1.0, color: Rgb::WHITE };
    assert_eq!(reason(&simple(white(), ambient.clone())), Unlit::NoAmbientReflectance);
    assert_eq!(reason(&simple(matte(0.0, Rgb::WHITE), above())), Unlit::NoLobes);
    assert_eq!(reason(&simple(white(), Directional { ls: 0.0, ..above() })), Unlit::Dark);
    let dark = Ambient { ls: 0.0, ..ambient.clone() };
    assert_eq!(reason(&simple(Matte { ka: 0.5.into(), ..white() }, dark)), Unlit::Dark);
    let blue = Directional { color: Rgb::new(0.0, 0.0, 1.0), ..above() };
    assert_eq!(reason(&simple(matte(0.5, red), blue)), Unlit::OtherColors);
    let red_ambient = Matte { ka: 0.5.into(), ..matte(0.5, red) };
    let blue_ambient = Ambient { color: Rgb::new(0.0, 0.0, 1.0), ..ambient.clone() };
    assert_eq!(reason(&simple(red_ambient, blue_ambient)), Unlit::OtherColors);
    assert_eq!(reason(&simple(white(), Directional { ls: 1e-60, ..above() })), Unlit::TooWeak);
    let (phong, kr) = (Phong::default(), 1.0.into());
    let mirror = Reflective { phong, kr, cr: Rgb::WHITE.into() };
    assert_eq!(reason(&simple(mirror, above())), Unlit::TracedLobesOnly);
    let exponent = 1e6.into();
    let highlight = Phong { ks: 1.0.into(), exponent, ..Phong::default() };
    let cos_i = 1.0 / 1.09_f64.sqrt();
    match reason(&simple(highlight, above())) {
        Unlit::OutsideLobes { cos_i: found } => assert!(near(found, cos_i), "{found}, {cos_i}"),
        other => panic!("{other:?}"),
    }

    let mut off = simple(white(), above());
    off.lights[0].enabled = false;
    assert_eq!(reason(&off), Unlit::SwitchedOff);

    let mut blocked = simple(white(), above());
    let center = Point::new(3.0, 10.0, 0.0);
    blocked.objects.push(Object::new(
        "moon",
        "disk",
        Sphere { center, radius: 1.0, inward: false },
    ));
    assert_eq!(reason(&blocked), Unlit::Blocked { blocked_by: "moon".into() });

    let (ls, color, attenuation) = (1.0, Rgb::WHITE, 2.0);
    let near = lights::PointLight { ls, color, location: Point::ORIGIN, attenuation };
    match reason(&simple(white(), near)) {
        Unlit::AtLight { distance } => assert!(distance < 1e-12, "{distance}"),
        other => panic!("{other:?}"),
    }
}

/// Law: light that a medium absorbs whole is absorbed. Oracle: the way from a sun through an endless medium is
/// infinite.
#[test]
fn a_medium_can_absorb_all() {
    let mut scene = simple(white(), above());
    scene.camera.medium.absorption = Rgb::WHITE;
    assert_eq!(reason(&scene), Unlit::Absorbed);
}

/// A white lamp above the disk, not seen by the camera.
fn under_a_lamp(tracer: Tracer) -> Scene {
    let mut scene = simple(white(), Area { object: "lamp".to_owned(), sampling: None });
    scene.materials.push(Material::new("lamp", Emissive::new(1.0, Rgb::WHITE)));
    let corner = Point::new(1.0, 2.0, -1.0);
    let (a, b) = (Vector::new(2.0, 0.0, 0.0), Vector::new(0.0, 0.0, 2.0));
    scene.objects.push(Object::new("lamp", "lamp", Rectangle { corner, a, b }));
    scene.lights.push(Light::new("sky", Ambient { ls: 1.0, color: Rgb::WHITE }));
    scene.lights.push(Light::new("sun", above()));
    scene.materials[0].recipe = Matte { ka: 1.0.into(), ..white() }.into();
    scene.tracer = tracer;
    scene
}

/// Law: a tracer that does not sample a light says so. Oracle: the table of tracers in `docs/scene.md`:
/// `path_trace` samples none and cannot meet a sun, `global_trace` and `path` with depth 0 would send an edge
/// too many, and no path counts ambient light.
#[test]
fn tracers_that_do_not_sample() {
    let depth = |max_depth| Depth { max_depth };
    let expected = [
        (Tracer::PathTrace(depth(3)), [Unlit::NotSampled, Unlit::LeftOut, Unlit::LeftOut]),
        (Tracer::GlobalTrace(depth(0)), [Unlit::TooDeep, Unlit::LeftOut, Unlit::TooDeep]),
        (Tracer::Path(depth(0)), [Unlit::TooDeep, Unlit::LeftOut, Unlit::TooDeep]),
    ];
    for (tracer, expected) in expected {
        let found: Vec<_> = ray(&under_a_lamp(tracer)).unlit.into_iter().collect();
        let names: Vec<_> = found.iter().map(|unlit| &*unlit.light).collect();
        assert_eq!(names, ["light", "sky", "sun"], "{tracer:?}");
        let reasons: Vec<_> = found.into_iter().map(|unlit| unlit.reason).collect();
        assert_eq!(reasons, expected, "{tracer:?}");
    }
    // the second hit of a path, inside a closed room
    let mut room = super::paths::room(0.5, 0.0, 1);
    room.tracer = Tracer::GlobalTrace(depth(3));
    let first = ray(&room);
    let second = first.children.iter().find(|ray| ray.depth == 1 && ray.hit.is_some());
    let second = second.filter(|ray| !ray.unlit.is_empty()).expect("the path goes on");
    assert_eq!(second.unlit[0].reason, Unlit::FirstHitOnly);
}

/// Law: a black ray says which of its factors is 0; one that is not black says nothing. Oracle: scenes with
/// one such factor, and the words for it.
#[test]
fn a_black_ray_says_why() {
    let says = |scene: &Scene, words: &str| {
        let ray = ray(scene);
        let black = ray.black.as_deref().unwrap_or("nothing");
        assert!(ray.radiance.is_black() && black.contains(words), "`{black}`, not `{words}`");
    };
    let mut none = simple(white(), above());
    none.lights.clear();
    says(&none, "the scene has no lights");
    none.objects.clear();
    says(&none, "the background is black there");
    none.background = Rgb::WHITE.into();
    assert_eq!(ray(&none).black, None);
    none.camera.medium.absorption = Rgb::WHITE;
    says(&none, "the medium transmits nothing over its length");

    let mut lamp = under_a_lamp(Tracer::RayCast);
    lamp.lights.clear();
    lamp.objects[0].material = "lamp".to_owned();
    assert_eq!(ray(&lamp).black, None);
    let seen_from_behind = |scene: &mut Scene| {
        scene.objects[0].shape =
            Disk { center: Point::ORIGIN, normal: Vector::new(0.0, -1.0, 0.0), radius: 1.0 }.into();
    };
    let mut behind = lamp.clone();
    seen_from_behind(&mut behind);
    says(&behind, "it shines on its front only, and the viewer is behind, cos θ_o = -1");
    let mut off = lamp.clone();
    off.lights = vec![Light::new("light", Area { object: "disk".to_owned(), sampling: None })];
    assert_eq!(ray(&off).black, None);
    off.lights[0].enabled = false;
    says(&off, "its area light is switched off");
    lamp.materials[1].recipe = Emissive::new(0.0, Rgb::WHITE).into();
    says(&lamp, "its emission is 0 there");

    // a mirror that shows a black sky, and the ray that would be one too many
    let mirror = Reflective { phong: Phong::default(), kr: 1.0.into(), cr: Rgb::WHITE.into() };
    let mut mirror = simple(mirror, above());
    mirror.tracer = Tracer::Whitted(Whitted { max_depth: 1 });
    says(&mirror, "ray 1 brings 0");
    let deep = |max_depth| {
        let inside = Medium { eta: 1.5, ..Medium::default() };
        let mut glass = simple(Dielectric { inside, ..Dielectric::default() }, above());
        glass.tracer = Tracer::Whitted(Whitted { max_depth });
        ray(&glass)
    };
    assert_eq!(deep(1).black.as_deref().map(|it| it.contains("rays 1, 2 bring 0")), Some(true));
    let too_deep = &deep(0).children[0];
    assert_eq!(too_deep.black.as_deref(), Some("it is beyond the largest depth, and not cast"));
}
