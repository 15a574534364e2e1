//! What once went wrong: the name says the symptom.

use groundtruth::cameras::{Pinhole, Viewpoint};
use groundtruth::lights;
use groundtruth::materials::{Matte, Medium, Transparent};
use groundtruth::math::{Point, Ray, Step, Vector, exp};
use groundtruth::rgb::Rgb;
use groundtruth::scene::{Image, Light, Material, Object, Scene, Tracer, Whitted};
use groundtruth::shapes::{self, Disk, Instance, Plane, Sphere};
use groundtruth::trace;
use groundtruth::world::World;

/// A camera at z = 5 that looks along −z, with these objects of one matte material.
fn scene(objects: Vec<shapes::Kind>) -> Scene {
    let lens = Pinhole { distance: 40.0, zoom: 1.0 };
    let camera = Viewpoint::new(Point::new(0.0, 0.0, 5.0), Point::ORIGIN, lens);
    let mut scene = Scene::new("", Image::new(24, 24), camera);
    let matte = Matte { ka: 0.0, kd: 1.0, cd: Rgb::WHITE.into() };
    scene.materials.push(Material::new("white", matte));
    for (i, shape) in objects.into_iter().enumerate() {
        scene.objects.push(Object::new(&format!("object {i}"), "white", shape));
    }
    scene
}

/// The box of an instance whose translations cancel was rounded more finely than its hits, which
/// were then thrown away.
#[test]
fn a_disk_moved_far_and_back_does_not_vanish() {
    for k in 0..14 {
        let far = 3.3 * groundtruth::math::power(5.0, f64::from(k));
        let disk = Disk { center: Point::new(0.0, 0.0, far), normal: Vector::Z, radius: 1.0 };
        let shape = Instance::new(disk, vec![Step::Translate(Vector::new(0.0, 0.0, -far))]);
        let world = World::build(&scene(vec![shape.into()])).expect("valid");
        let ray = Ray::new(Point::new(0.3, 0.2, 3.3), -Vector::Z);
        let hit = world.hit(&ray, groundtruth::math::Span::AHEAD);
        assert!(hit.is_some(), "gone when moved by {far}");
    }
}

/// The end of a shadow segment was exactly the light, so the surface it lies on was now in front of
/// it and now behind.
#[test]
fn a_lamp_on_a_surface_is_not_in_that_surfaces_shadow() {
    let floor = Plane { point: Point::new(0.0, -1.0, 0.0), normal: Vector::Y };
    let ball = Sphere { center: Point::new(0.1, 0.7, 0.3), radius: 0.3, inward: false };
    let mut scene = scene(vec![floor.into(), ball.into()]);
    // the lowest point of the ball, as near as numbers come
    let lamp = lights::Point {
        ls: 3.0,
        color: Rgb::WHITE,
        location: Point::new(0.1, 0.7 - 0.3, 0.3),
        attenuation: 0.0,
    };
    scene.lights.push(Light::new("lamp", lamp));
    let world = World::build(&scene).expect("valid");
    for i in 0..400 {
        let angle = f64::from(i) * 0.1;
        let (x, z) = (groundtruth::math::cos(angle), groundtruth::math::sin(angle));
        let ray = Ray::new(Point::new(3.0 * x, 2.0, 3.0 * z), Vector::ZERO);
        let target = Point::new(0.5 * x, -1.0, 0.5 * z);
        let direction = (target - ray.origin).unit().expect("apart");
        let seen =
            trace::radiance(&world, &Ray { direction, ..ray }, world.draws([0, 0], 0), &mut ());
        assert!(seen.r > 0.0, "a black speck near {target:?}");
    }
}

/// A simple transparent surface says nothing of media, and yet it cleared the fog behind it.
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
        kr: 0.0,
        cr: Rgb::WHITE.into(),
        kt: 1.0,
        eta: 1.0,
    };
    scene.materials[0].recipe = invisible.into();
    scene.camera.medium = Medium { eta: 1.0, absorption: Rgb::grey(0.125) };
    let world = World::build(&scene).expect("valid");
    let ray = Ray::new(Point::new(0.0, 0.0, 5.0), -Vector::Z);
    let seen = trace::radiance(&world, &ray, world.draws([0, 0], 0), &mut ()).r;
    // ten units of fog, all the way; a few roundings of each of three factors
    assert!((seen - exp(-1.25)).abs() < 1e-14, "{seen}");
}
