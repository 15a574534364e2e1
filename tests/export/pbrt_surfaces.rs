//! pbrt-v4: textures, glass and lamps are ours.

use std::path::Path;

use groundtruth::kinds::Resources;
use groundtruth::lights::{Area, Environment};
use groundtruth::materials::{Dielectric, Emissive, Matte, Medium};
use groundtruth::math::{self, Normal, Point, Span, Step, Transform, Vector};
use groundtruth::rgb::Rgb;
use groundtruth::scene::{Depth, Light, Material, Object, Scene, Tracer, Whitted};
use groundtruth::shapes::{
    self, Compound, Disk, Instance, Lattice, RandomSpheres, Sphere, Surface,
};
use groundtruth::textures::{
    self, Checker3d, PlaneChecker, RandomColors, TextureInstance, TexturePoint,
};
use groundtruth::world::World;

use super::pbrt::{near, near_all, pinhole, to_world};
use super::pbrt_parsed::{Statement, read, written};
use super::pbrt_shapes::{in_world, their_point};

/// Law: checkers are ours, in the coordinates of the object, also instances of them. Oracle: our texture, beside the formula of pbrt's source
/// (`textures.cpp`) without filtering: `tex1` where the sum of the whole parts of the coordinates is even.
#[test]
fn checkers_are_ours() {
    let colors = [Rgb::grey(0.25), Rgb::grey(0.75)];
    let [color1, color2] = colors.map(Into::into);
    let solid = Checker3d { size: 0.75, color1, color2 };
    let [color1, color2] = colors.map(Into::into);
    let outline_color = Rgb::BLACK.into();
    let level = PlaneChecker { size: 0.5, color1, color2, outline_width: 0.0, outline_color };
    let kinds: [textures::Kind; 2] = [solid.into(), level.into()];
    let stretch = vec![
        Step::Scale(Vector::new(0.5, 1.0, 3.0)),
        Step::RotateY(20.0),
        Step::Translate(Vector::Z),
    ];
    let instance = |of: &textures::Kind| {
        let of = textures::Paint::Textured(Box::new(of.clone()));
        TextureInstance::new(of, stretch.clone()).into()
    };
    let instances = kinds.each_ref().map(instance);
    let steps = vec![Step::RotateX(30.0), Step::Translate(Vector::new(0.5, -0.25, 0.125))];
    let map = Transform::from_steps(&steps).expect("it has an inverse");
    for kind in kinds.into_iter().chain(instances) {
        let built = kind.build(&mut Resources::new(Path::new(""))).expect("it is valid");
        let mut scene = pinhole();
        let cd = textures::Paint::Textured(Box::new(kind));
        let recipe = Matte { ka: 0.0.into(), kd: 0.5.into(), cd };
        scene.materials.push(Material { two_sided: true, ..Material::new("it", recipe) });
        let sphere = Sphere { center: Point::ORIGIN, radius: 1.0, inward: false };
        scene.objects.push(Object::new("ball", "it", Instance::new(sphere, steps.clone())));
        let read = read(&scene);
        assert_eq!(read.options["disabletexturefiltering"], "true");
        let texture = &read.textures[read.shapes[0].material.word("reflectance")];
        for index in 0..200 {
            let at = [0.137, -0.219, 0.0913].map(|step| f64::from(index) * step - 3.0 * step);
            let local = Point::new(at[0], at[1], at[2]);
            let surface = Surface::new(local, 0.0, Normal::Y);
            let ours = 0.5 * built.color(&TexturePoint::new(&surface));
            near_all(their_color(texture, map.point(local).to_vector()), ours.to_array());
        }
    }
}

/// The colour of pbrt's checkerboard at a point of the world.
fn their_color(texture: &Statement, point: Vector) -> [f64; 3] {
    let p = to_world(texture, point); // the inverse of the transformation at the statement
    let parameters = &texture.parameters;
    let coordinates = match parameters.number("dimension") {
        2.0 => vec![p.dot(parameters.vector("v1")), p.dot(parameters.vector("v2"))],
        _ => p.to_array().to_vec(),
    };
    let sum: f64 = coordinates.into_iter().map(math::floor).sum();
    let name = if sum.rem_euclid(2.0) == 0.0 { "tex1" } else { "tex2" };
    parameters.vector(name).to_array()
}

/// Law: a lamp of an area light shines, one whose light is off is dark. Oracle: the meaning of `Area`.
#[test]
fn lamps_shine_while_they_are_on() {
    let mut scene = pinhole();
    scene.materials.push(Material::new("lamp", Emissive::new(4.0, Rgb::WHITE)));
    let disk = Disk { center: Point::new(0.0, 4.0, 0.0), normal: -Vector::Y, radius: 1.0 };
    scene.objects.push(Object::new("lamp", "lamp", disk));
    let ball = Sphere { center: Point::ORIGIN, radius: 1.0, inward: false };
    scene.objects.push(Object::new("ball", "grey", ball));
    let area = Area { object: "lamp".to_owned(), sampling: None };
    scene.lights.push(Light::new("area", area));
    let shines = |scene: &Scene| read(scene).shapes[0].area_light.is_some();
    assert!(shines(&scene));
    scene.lights[0].enabled = false;
    assert!(!shines(&scene));
    scene.lights[0] = Light::new("sky", Environment {});
    let why = written(&scene).expect_err("it lights the ball there, not here");
    assert_eq!(why[0].path, "objects[0] \"lamp\": shape.disk");
}

/// Law: `random_colors` gives each shape of an object its own material, of our colour. Oracle: our texture at a hit of it.
#[test]
fn random_colours_are_ours() {
    let ball = |x: f64| Sphere { center: Point::new(x, 0.0, 0.0), radius: 0.25, inward: false };
    let many = RandomSpheres { count: 3, radius: 0.1, half_side: 1.0, seed: 1, accel: None };
    let spacing = Vector::new(2.0, 3.0, 0.0);
    let pair = Compound::of([ball(7.0), ball(8.0)]);
    let row = Lattice { of: Box::new(pair.into()), counts: [1, 2, 1], spacing, accel: None };
    let parts = [many.into(), row.into(), ball(20.0).into()];
    let mut scene = pinhole();
    let random = textures::Kind::from(RandomColors { seed: 7 });
    let cd = textures::Paint::Textured(Box::new(random.clone()));
    let recipe = Matte { ka: 0.0.into(), kd: 0.5.into(), cd };
    scene.materials.push(Material { two_sided: true, ..Material::new("it", recipe) });
    scene.objects.push(Object::new("all", "it", Compound::of::<shapes::Kind>(parts)));
    let built = random.build(&mut Resources::new(Path::new(""))).expect("it is valid");
    let (world, read) = (World::build(&scene).expect("it is valid"), read(&scene));
    assert_eq!(read.shapes.len(), 3 + 4 + 1);
    for shape in &read.shapes {
        let (point, normal) = in_world(shape, their_point(&shape.shape, [0.3, 0.4]));
        let ray = math::Ray::new(point + 0.001 * normal, -normal);
        let hit = world.hit(&ray, Span::AHEAD).expect("it is there");
        let ours = 0.5 * built.color(&hit.texture_point());
        near_all(shape.material.vector("reflectance").to_array(), ours.to_array());
    }
}

/// Law: glass has the index inside over that outside, and pbrt follows its rays as far as we do. Oracle: the definitions of
/// `eta`, `maxdepth` and `max_depth`.
#[test]
fn glass_is_ours() {
    let (inside, outside) = (Medium::clear(1.5), Medium::clear(1.25));
    let glass = Dielectric { inside, outside, ..Dielectric::default() };
    let mut scene = pinhole();
    scene.background = groundtruth::background::Background::Color(Rgb::grey(0.5));
    scene.materials.push(Material::new("glass", glass));
    let sphere = Sphere { center: Point::ORIGIN, radius: 1.0, inward: true };
    scene.objects.push(Object::new("ball", "glass", sphere));
    let depth = Depth { max_depth: 7 };
    for tracer in [Tracer::Whitted(Whitted { max_depth: 7 }), Tracer::Path(depth)] {
        scene.tracer = tracer;
        let read = read(&scene);
        assert_eq!(read.shapes[0].material.word("type"), "dielectric");
        near(read.shapes[0].material.number("eta"), 1.2);
        assert!(read.shapes[0].is_reversed, "its inner side is outside");
        near(read.setting("Integrator").number("maxdepth"), 7.0);
    }
    let (ball, at) = (sphere_at(5.0), "materials[1] \"glass\": recipe.dielectric");
    scene.objects.push(Object::new("wall", "grey", ball));
    assert!(written(&scene).is_ok(), "on paths");
    scene.tracer = Tracer::Whitted(Whitted { max_depth: 7 });
    let why = written(&scene).expect_err("pbrt follows the rays of the wall too");
    assert!(why.iter().any(|it| it.path == at), "{why:?}");
}

fn sphere_at(x: f64) -> Sphere {
    Sphere { center: Point::new(x, 0.0, 0.0), radius: 0.5, inward: false }
}
