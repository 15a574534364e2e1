//! pbrt-v4: rays, transforms and radiances restored from the text by pbrt's own formulas; and each factor of a convention.

use std::f64::consts::PI;

use groundtruth::cameras::{Orthographic, Pinhole, Side, ThinLens, Viewpoint};
use groundtruth::lights::{Directional, PointLight};
use groundtruth::materials::{Emissive, Matte};
use groundtruth::math::{Point, Step, Transform, Vector};
use groundtruth::render;
use groundtruth::rgb::Rgb;
use groundtruth::scene::{Depth, Image, Light, Material, Object, Scene, Tracer, Whitted};
use groundtruth::shapes::{Instance, Plane, Sphere};
use groundtruth::world::World;

use super::pbrt_parsed::{Read, Statement, axes, moved, read, written};

/// A few roundings of numbers of magnitude 1 to 100.
const ROUNDING: f64 = 1e-12;

pub fn near(found: f64, expected: f64) {
    let error = (found - expected).abs();
    assert!(error <= ROUNDING * (1.0 + expected.abs()), "found {found}, expected {expected}");
}

pub fn near_all(found: [f64; 3], expected: [f64; 3]) {
    found.into_iter().zip(expected).for_each(|(found, expected)| near(found, expected));
}

pub fn matte(name: &str, kd: f64, cd: impl Into<Rgb>) -> Material {
    Material::new(name, Matte { ka: 0.0.into(), kd: kd.into(), cd: cd.into().into() })
}

/// A camera that is askew: no axis along those of the world, no side like another.
fn askew(lens: impl Into<groundtruth::cameras::Kind>) -> Scene {
    let mut image = Image::new(9, 5);
    image.pixel_size = 0.25;
    let mut camera = Viewpoint::new(Point::new(3.0, 4.0, 7.0), Point::new(-1.0, 0.5, 0.25), lens);
    camera.roll = 20.0;
    let mut scene = Scene::new("which object is where", image, camera);
    scene.materials.push(Material { two_sided: true, ..matte("grey", 0.8, Rgb::WHITE) });
    scene
}

pub fn pinhole() -> Scene {
    askew(Pinhole { distance: 6.0, zoom: 1.0 })
}

/// The point of the world for one of the camera: `p = R⁻¹ (q − t)`, by Cramer's rule.
pub fn to_world(camera: &Statement, q: Vector) -> Vector {
    let [a, b, c] = axes(&camera.transform);
    let q = q - moved(&camera.transform, Vector::ZERO);
    let determinant = a.dot(b.cross(c));
    Vector::new(q.dot(b.cross(c)), a.dot(q.cross(c)), a.dot(b.cross(q))) / determinant
}

/// pbrt's ray through the centre of a pixel and a point of the unit lens, by the formulas of its source (`cameras.cpp`).
fn their_ray(read: &Read, [column, row]: [u32; 2], lens: [f64; 2]) -> (Vector, Vector) {
    let (camera, film) = (&read.settings["Camera"], read.setting("Film"));
    let [x0, x1, y0, y1] = camera.parameters.all("screenwindow")[..] else {
        panic!("four numbers")
    };
    let across = (f64::from(column) + 0.5) / film.number("xresolution");
    let down = (f64::from(row) + 0.5) / film.number("yresolution");
    let (x, y) = (x0 + across * (x1 - x0), y1 + down * (y0 - y1));
    let (origin, direction) = match camera.kind.as_str() {
        "orthographic" => (Vector::new(x, y, 0.0), Vector::Z),
        _ => {
            near(camera.parameters.number("fov"), 90.0); // tan(fov/2) = 1
            let radius = camera.parameters.number_or("lensradius", 0.0);
            let origin = Vector::new(radius * lens[0], radius * lens[1], 0.0);
            let focus = camera.parameters.number_or("focaldistance", 1e6);
            (origin, focus * Vector::new(x, y, 1.0) - origin)
        }
    };
    let start = to_world(camera, origin);
    (start, to_world(camera, origin + direction) - start)
}

fn cameras_agree(scene: &Scene) {
    let (world, read) = (World::build(scene).expect("it is valid"), read(scene));
    for pixel in [[0, 0], [8, 0], [0, 4], [6, 1]] {
        let sample = render::camera_sample(&world, pixel, 0).expect("in the picture");
        for lens in [[0.0, 0.0], [0.5, -0.25]] {
            let ours = world.view.eye(Side::Left).ray(sample.film, lens).expect("in the picture");
            let (origin, direction) = their_ray(&read, pixel, lens);
            near_all(origin.to_array(), ours.origin.to_array());
            near_all(direction.unit().expect("not zero").to_array(), ours.direction.to_array());
        }
    }
}

/// Law: coordinates: the ray of each pixel is that of pbrt, by its own formulas. Oracle: `render::camera_sample` and
/// `Eye::ray`, which the writer does not use.
#[test]
fn rays_of_pixels_are_ours() {
    cameras_agree(&askew(Pinhole { distance: 6.0, zoom: 1.5 }));
    cameras_agree(&askew(Orthographic { zoom: 1.5 }));
    cameras_agree(&askew(ThinLens {
        distance: 6.0,
        focal_distance: 9.0,
        lens_radius: 0.5,
        zoom: 1.5,
    }));
}

/// Law: coordinates: a transformed object is where ours is. Oracle: our transform of a point.
#[test]
fn instances_are_where_ours_are() {
    let steps = vec![
        Step::Scale(Vector::new(1.0, 2.0, 3.0)),
        Step::RotateX(30.0),
        Step::Shear([0.0, 0.5, 0.0, 0.0, 0.25, 0.0]),
        Step::Translate(Vector::new(5.0, 6.0, 7.0)),
    ];
    let mut scene = pinhole();
    let sphere = Sphere { center: Point::new(0.5, 1.0, 1.5), radius: 2.0, inward: false };
    scene.objects.push(Object::new("ball", "grey", Instance::new(sphere, steps.clone())));
    let read = read(&scene);
    let ball = &read.shapes[0].shape;
    near(ball.parameters.number("radius"), 2.0);
    let map = Transform::from_steps(&steps).expect("it has an inverse");
    for p in [Vector::ZERO, Vector::new(1.0, 2.0, -3.0)] {
        let ours = map.point(Point::new(0.5, 1.0, 1.5) + p);
        near_all(moved(&ball.transform, p).to_array(), ours.to_array());
    }
}

/// A matte plane y = 0 that a camera 8 above it looks down on, near the origin.
fn plane_below(light: Light) -> Scene {
    let lens = Pinhole { distance: 100.0, zoom: 1.0 };
    let eye = Viewpoint::new(Point::new(0.0, 8.0, 0.0), Point::ORIGIN, lens);
    let mut scene = Scene::new("a plane", Image::new(1, 1), eye);
    scene.camera.exposure_time = 0.5;
    scene.materials.push(matte("floor", 0.8, Rgb::new(0.9, 0.4, 0.1)));
    let plane = Plane { point: Point::ORIGIN, normal: Vector::new(0.0, 2.0, 0.0) };
    scene.objects.push(Object::new("floor", "floor", plane));
    scene.lights.push(light);
    scene
}

/// The radiance of the origin of a matte plane with the normal y, by the formulas of pbrt's source: R/π · Li · cosθ, where a
/// distant light has Li = L from the direction `from − to` and a point light I/d²; times iso/100.
fn their_radiance(read: &Read) -> [f64; 3] {
    let [light] = &read.lights[..] else { panic!("one light") };
    let parameters = &light.parameters;
    let from = moved(&light.transform, parameters.vector("from"));
    let (arriving, cos) = match light.kind.as_str() {
        "distant" => {
            let to = moved(&light.transform, parameters.vector("to"));
            (parameters.vector("L"), (from - to).unit().expect("apart").y())
        }
        _ => {
            let distance = from.length();
            (parameters.vector("I") / (distance * distance), from.y() / distance)
        }
    };
    let reflectance = read.shapes[0].material.vector("reflectance").to_array();
    let exposure = read.setting("Film").number("iso") / 100.0;
    std::array::from_fn(|i| exposure * reflectance[i] / PI * arriving.to_array()[i] * cos)
}

/// Law: radiance: a matte plane of kd 0.8 under a directional light of radiance π at 60° from its normal, at exposure 1/2,
/// has 0.8 · cd · cos 60° / 2. Oracle: that number; and our picture.
#[test]
fn a_matte_plane_has_its_radiance() {
    let direction = Vector::new(3.0_f64.sqrt(), 1.0, 0.0);
    let scene =
        plane_below(Light::new("sun", Directional { ls: PI, color: Rgb::WHITE, direction }));
    let ours = render::pixel(&World::build(&scene).expect("it is valid"), [0, 0]).to_array();
    near_all(ours, [0.9, 0.4, 0.1].map(|cd| 0.8 * cd * 0.5 * 0.5));
    near_all(their_radiance(&read(&scene)), ours);
}

/// Law: scaling: the light of a lamp falls with the square of its distance. Oracle: ls · kd · cd / π / 2² under a lamp 2 above
/// the plane; and our picture.
#[test]
fn a_lamp_fades_with_its_distance() {
    let location = Point::new(0.0, 2.0, 0.0);
    let lamp = PointLight { ls: 3.0, color: Rgb::WHITE, location, attenuation: 2.0 };
    let scene = plane_below(Light::new("lamp", lamp.clone()));
    let ours = render::pixel(&World::build(&scene).expect("it is valid"), [0, 0]).to_array();
    near_all(ours, [0.9, 0.4, 0.1].map(|cd| 0.5 * 3.0 * 0.8 * cd / PI / 4.0));
    near_all(their_radiance(&read(&scene)), ours);
    for attenuation in [0.0, 1.0, 3.0] {
        let scene = plane_below(Light::new("lamp", PointLight { attenuation, ..lamp.clone() }));
        let why = written(&scene).expect_err("it cannot be said");
        assert_eq!(why[0].path, "lights[0] \"lamp\": source.point.attenuation");
    }
}

/// Law: a background that is a light, and a shining surface, have their radiance: `L` as it is. Oracle: our picture of them.
#[test]
fn sources_have_their_radiance() {
    let mut scene = pinhole();
    scene.background = groundtruth::background::Background::Color(Rgb::new(0.5, 0.25, 0.125));
    let lamp = Emissive::new(4.0, Rgb::new(1.0, 0.5, 0.25));
    scene.materials.push(Material::new("lamp", lamp.clone()));
    scene.materials.push(Material { two_sided: true, ..Material::new("both", lamp) });
    let sphere = |x: f64| Sphere { center: Point::new(x, 0.0, 0.0), radius: 0.01, inward: false };
    scene.objects.push(Object::new("one", "lamp", sphere(-40.0)));
    scene.objects.push(Object::new("two", "both", sphere(-50.0)));
    let found = read(&scene);
    let background = render::pixel(&World::build(&scene).expect("it is valid"), [0, 0]);
    assert_eq!(found.lights[0].kind, "infinite");
    near_all(found.lights[0].parameters.vector("L").to_array(), background.to_array());
    for (shape, sides) in found.shapes.iter().zip(["false", "true"]) {
        let light = shape.area_light.as_ref().expect("it shines");
        near_all(light.vector("L").to_array(), [4.0, 2.0, 1.0]);
        assert_eq!(light.word("twosided"), sides);
        near_all(shape.material.vector("reflectance").to_array(), [0.0; 3]);
    }
}

/// Law: pbrt reflects light as often as we do: once for `ray_cast`, and `max_depth` times on a path. Oracle: the definition of
/// `maxdepth`, and of `max_depth` in `scene::Depth`.
#[test]
fn depths_count_reflections() {
    let depth = Depth { max_depth: 7 };
    let tracers = [
        (Tracer::RayCast, 1.0),
        (Tracer::Whitted(Whitted { max_depth: 7 }), 1.0),
        (Tracer::Path(depth), 7.0),
        (Tracer::PathTrace(depth), 7.0),
    ];
    for (tracer, expected) in tracers {
        let mut scene = pinhole();
        scene.tracer = tracer;
        near(read(&scene).setting("Integrator").number("maxdepth"), expected);
    }
}

/// Law: `path_trace` never meets a light without a surface, which is left out; `path` has it. Oracle: our picture.
#[test]
fn path_trace_has_no_lights_without_a_surface() {
    let sun = Directional { ls: 2.0, color: Rgb::WHITE, direction: Vector::new(1.0, 1.0, 1.0) };
    let mut scene = pinhole();
    scene.lights.push(Light::new("sun", sun));
    let sphere = Sphere { center: Point::new(-1.0, 0.5, 0.25), radius: 1.0, inward: false };
    scene.objects.push(Object::new("ball", "grey", sphere));
    for (tracer, count) in
        [(Tracer::Path(Depth { max_depth: 2 }), 1), (Tracer::PathTrace(Depth { max_depth: 2 }), 0)]
    {
        scene.tracer = tracer;
        let pixel = render::pixel(&World::build(&scene).expect("it is valid"), [4, 2]);
        assert_eq!(read(&scene).lights.len(), count);
        assert_eq!(pixel.is_black(), count == 0);
    }
}

/// Law: one sample is through the centre, with wavelengths that are no random numbers; more are spread over the pixel, at
/// least as many as ours. The picture is not rounded to 16 bits.
#[test]
fn samples_are_as_ours() {
    let mut scene = pinhole();
    let centred = read(&scene);
    assert_eq!(centred.options["disablepixeljitter"], "true");
    assert_eq!(centred.setting("Sampler").word("jitter"), "false");
    assert_eq!(centred.setting("Film").word("savefp16"), "false");
    scene.image.samples = 100;
    let spread = read(&scene);
    assert!(!spread.options.contains_key("disablepixeljitter"));
    assert_eq!(spread.setting("Sampler").word("jitter"), "true");
    near(spread.setting("Sampler").number("xsamples"), 10.0);
    near(spread.setting("PixelFilter").number("xradius"), 0.5);
}
