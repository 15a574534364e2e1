//! Regressions: each test is named after the symptom, its comment gives the cause.

use groundtruth::samplers::Hammersley;
use groundtruth::trace;

use crate::prelude::*;

/// A camera at z = 5 that looks along −z, with these objects of one matte material.
fn scene(objects: Vec<shapes::Kind>) -> Scene {
    let lens = Pinhole { distance: 40.0, zoom: 1.0 };
    let camera = Viewpoint::new(Point::new(0.0, 0.0, 5.0), Point::ORIGIN, lens);
    let mut scene = Scene::new("", Image::new(24, 24), camera);
    let matte = Matte { ka: 0.0.into(), kd: 1.0.into(), cd: Rgb::WHITE.into() };
    scene.materials.push(Material::new("white", matte));
    for (i, shape) in objects.into_iter().enumerate() {
        scene.objects.push(Object::new(&format!("object {i}"), "white", shape));
    }
    scene
}

/// A simple transparent surface does not define a medium, and yet it removed the fog behind it.
#[test]
fn an_invisible_ball_does_not_clear_the_fog() {
    let mut scene =
        scene(vec![Sphere { center: Point::ORIGIN, radius: 1.0, inward: false }.into()]);
    scene.background = Rgb::WHITE.into();
    scene.tracer = Tracer::Whitted(Whitted { max_depth: 4 });
    let wall = Plane { point: Point::new(0.0, 0.0, -5.0), normal: Vector::Z };
    scene.objects.push(Object::new("wall", "glow", wall));
    let glow = groundtruth::materials::Emissive::new(1.0, Rgb::WHITE);
    scene.materials.push(Material::new("glow", glow));
    let invisible = Transparent {
        phong: groundtruth::materials::Phong::default(),
        kr: 0.0.into(),
        cr: Rgb::WHITE.into(),
        kt: 1.0.into(),
        eta: 1.0,
    };
    scene.materials[0].recipe = invisible.into();
    scene.camera.medium = Medium { eta: 1.0, absorption: Rgb::grey(0.125) };
    let world = World::build(&scene).expect("valid");
    let ray = Ray::new(Point::new(0.0, 0.0, 5.0), -Vector::Z);
    let seen = trace::radiance(&world, &ray, world.draws([0, 0], 0), &mut ()).r;
    // ten units of fog along the whole way; the tolerance is a few roundings of each of three factors
    assert!((seen - exp(-1.25)).abs() < 1e-14, "{seen}");
}

/// The scene with a two-sided lamp of this shape and of radiance 1.
fn with_lamp(mut scene: Scene, shape: impl Into<shapes::Kind>) -> Scene {
    let mut glow = Material::new("glow", Emissive::new(1.0, Rgb::WHITE));
    glow.two_sided = true;
    scene.materials.push(glow);
    scene.objects.push(Object::new("lamp", "glow", shape));
    scene.lights.push(Light::new("lamp", Area { object: "lamp".to_owned(), sampling: None }));
    scene
}

/// The mean of a pixel's samples along a ray.
fn mean_along(world: &World, origin: Point, direction: Vector) -> f64 {
    let ray = Ray::new(origin, direction.unit().expect("not zero"));
    let sample = |i| trace::radiance(world, &ray, world.draws([0, 0], i), &mut ());
    render::mean((0..world.samples_per_pixel()).map(sample)).g
}

/// The corner (0, 0) of the square, which Hammersley's set contains, maps to the rim of the disk or, by
/// rounding, beyond it; the sample of a spherical lamp was then lost. Oracle: the closed form
/// `(R/D)² cosθ`; one lost sample of 4 would cost a quarter.
#[test]
fn no_sample_of_a_spherical_lamp_is_lost_at_the_rim() {
    let floor = Plane { point: Point::ORIGIN, normal: Vector::Y };
    let ball = Sphere { center: Point::new(0.0, 20.0, 0.0), radius: 1.0, inward: false };
    let mut scene = with_lamp(scene(vec![floor.into()]), ball);
    scene.image.samples = 4;
    scene.image.sampler = Some(Hammersley { shifted: false }.into());
    let world = World::build(&scene).expect("valid");
    for i in 0..60 {
        let (x, z) = (0.031 * f64::from(i), 0.12 - 0.017 * f64::from(i));
        let distance_squared = x * x + 400.0 + z * z;
        let expected = 20.0 / (distance_squared * distance_squared.sqrt());
        let seen = mean_along(&world, Point::new(x, 1.0, z), -Vector::Y);
        // the lamp is small: the cosine hardly changes over it
        assert!((seen / expected - 1.0).abs() < 0.02, "at ({x}, {z}): {seen}, expected {expected}");
    }
}

/// A long lamp beside the lit point, seen almost edge-on, was sampled by area, because its solid angle is
/// small. Nearly all samples missed the part that contributes most, and the point looked too dark. Oracle:
/// the light is proportional to the lamp's height over the surface while this is small.
#[test]
fn a_near_lamp_that_is_seen_edge_on_is_not_too_dark() {
    let seen = |height: f64| {
        let wall = Plane { point: Point::ORIGIN, normal: Vector::X };
        let (corner, a, b) = (Point::new(0.01, height, -50.0), Vector::X, 100.0 * Vector::Z);
        let mut scene = with_lamp(scene(vec![wall.into()]), Rectangle { corner, a, b });
        scene.image.samples = 256;
        let world = World::build(&scene).expect("valid");
        mean_along(&world, Point::new(0.005, 0.0, 0.0), -Vector::X)
    };
    let per_height = [1e-5, 1e-6, 1e-7].map(|height| seen(height) / height);
    for value in per_height {
        let off = value / per_height[0] - 1.0;
        assert!(off.abs() < 0.01, "light over height is {per_height:?}, expected to be constant");
    }
}

/// `d^k` underflows to 0 for a large k near a light, and a channel without light became 0/0.
#[test]
fn a_light_of_large_attenuation_sends_numbers() {
    let floor = Plane { point: Point::ORIGIN, normal: Vector::Y };
    let mut scene = scene(vec![floor.into()]);
    let (color, location) = (Rgb::new(1.0, 0.0, 0.0), Point::new(0.0, 0.05, 0.0));
    scene
        .lights
        .push(Light::new("l", lights::PointLight { ls: 1.0, color, location, attenuation: 300.0 }));
    let world = World::build(&scene).expect("valid");
    for x in [0.0, 0.3, 0.99] {
        let ray = Ray::new(Point::new(x, 1.0, 0.0), -Vector::Y);
        let seen = trace::radiance(&world, &ray, world.draws([0, 0], 0), &mut ());
        assert!(seen.to_array().iter().all(|c| c.is_finite()), "at {x}: {seen:?}");
    }
}

/// A lamp and its light could not both be switched off.
#[test]
fn a_lamp_and_its_light_can_both_be_off() {
    let ball = Sphere { center: Point::ORIGIN, radius: 1.0, inward: false };
    let mut scene = with_lamp(scene(Vec::new()), ball);
    scene.objects[0].enabled = false;
    assert!(World::build(&scene).is_err(), "a light that is on needs its lamp");
    scene.lights[0].enabled = false;
    assert!(World::build(&scene).is_ok_and(|world| world.lights.is_empty()));
}
