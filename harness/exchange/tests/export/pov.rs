//! The three fixtures: coordinates, radiance and scaling; and each factor of a convention.

use std::f64::consts::PI;
use std::path::Path;

use groundtruth::cameras::{Pinhole, Viewpoint};
use groundtruth::kinds::Resources;
use groundtruth::lights::{Ambient, Directional, PointLight};
use groundtruth::materials::{Emissive, Matte, Reflective};
use groundtruth::math::{self, Normal, Point, Ray, Step, Transform, Vector};
use groundtruth::render;
use groundtruth::rgb::Rgb;
use groundtruth::scene::{Image, Light, Material, Object, Scene, Tracer, Whitted};
use groundtruth::shapes::{Instance, OpenCylinder, Plane, Rectangle, Sphere, Surface, Triangle};
use groundtruth::textures::{Checker3d, PlaneChecker, TexturePoint};
use groundtruth::world::World;

use super::parsed::{Parsed, Statement, said};

/// A few roundings of numbers of magnitude 1 to 100.
const ROUNDING: f64 = 1e-12;

pub(super) fn near(found: f64, expected: f64) {
    let error = (found - expected).abs();
    assert!(error <= ROUNDING * (1.0 + expected.abs()), "found {found}, expected {expected}");
}

pub(super) fn near_all(found: &[f64], expected: [f64; 3]) {
    assert_eq!(found.len(), 3);
    found.iter().zip(expected).for_each(|(found, expected)| near(*found, expected));
}

pub(super) fn vector(numbers: &[f64]) -> Vector {
    Vector::new(numbers[0], numbers[1], numbers[2])
}

pub(super) fn matte(name: &str, ka: f64, kd: f64, cd: [f64; 3]) -> Material {
    let [r, g, b] = cd;
    Material::new(name, Matte { ka: ka.into(), kd: kd.into(), cd: Rgb::new(r, g, b).into() })
}

/// A camera that is askew: no axis along those of the world, no side like another.
pub(super) fn askew(lens: impl Into<groundtruth::cameras::Kind>) -> Scene {
    let mut image = Image::new(9, 5);
    image.pixel_size = 0.25;
    let mut camera = Viewpoint::new(Point::new(3.0, 4.0, 7.0), Point::new(-1.0, 0.5, 0.25), lens);
    camera.roll = 20.0;
    let mut scene = Scene::new("which object is where", image, camera);
    scene.materials.push(matte("red", 0.0, 0.8, [0.9, 0.2, 0.1]));
    scene
}

/// Law: coordinates: a transformed object is where ours is. Oracle: our transform of a point, beside the row vector
/// `(x, y, z, 1)` times the matrix, as POV-Ray's documentation multiplies it.
#[test]
fn instances_are_where_ours_are() {
    let steps = vec![
        Step::Scale(Vector::new(1.0, 2.0, 3.0)),
        Step::RotateX(30.0),
        Step::Shear([0.0, 0.5, 0.0, 0.0, 0.25, 0.0]),
        Step::Translate(Vector::new(5.0, 6.0, 7.0)),
    ];
    let mut scene = askew(Pinhole { distance: 6.0, zoom: 1.0 });
    let sphere = Sphere { center: Point::new(0.5, 1.0, 1.5), radius: 2.0, inward: false };
    scene.objects.push(Object::new("ball", "red", Instance::new(sphere, steps.clone())));
    let parsed = said(&scene);
    let ball = parsed.one("sphere");
    near_all(&ball.values[0], [0.5, 1.0, 1.5]);
    near(ball.values[1][0], 2.0);
    let matrix = &ball.of("matrix")[0];
    let map = Transform::from_steps(&steps).expect("it has an inverse");
    for p in [[0.0, 0.0, 0.0], [1.0, 2.0, -3.0]] {
        let row = [p[0], p[1], p[2], 1.0];
        let theirs = [0, 1, 2].map(|column| (0..4).map(|i| row[i] * matrix[3 * i + column]).sum());
        near_all(&theirs, map.point(Point::new(p[0], p[1], p[2])).to_array());
    }
}

/// The radiance of a point of a matte plane under the light of a scene, by the formula of POV-Ray's source: pigment ·
/// (ambient · ambient_light + diffuse · colour · attenuation · cosθ).
fn their_radiance(parsed: &Parsed, distance: f64, cos: f64) -> [f64; 3] {
    let texture = &parsed.textures["front_0"];
    let ambient_light = parsed.one("global_settings").vector("rgb");
    let (mut light, mut fade) = (vec![0.0; 3], 1.0);
    if let [source] = parsed.all("light_source")[..] {
        light = source.vector("rgb");
        assert!(source.has("exposed"));
        if source.has("fade_power") {
            let (f, power) = (source.number("fade_distance"), source.number("fade_power"));
            assert!(f >= 1e-10, "POV-Ray takes it for none");
            fade = 2.0 / (1.0 + math::power(distance / f, power));
        }
    }
    let pigment = texture.vector("rgb");
    std::array::from_fn(|i| {
        let direct = texture.number("diffuse") * light[i] * fade * cos;
        parsed.exposure * pigment[i] * (texture.number("ambient") * ambient_light[i] + direct)
    })
}

/// A matte plane y = 0 that a camera 8 above it looks down on, near the origin.
fn plane_below(light: Light) -> Scene {
    let lens = Pinhole { distance: 100.0, zoom: 1.0 };
    let eye = Viewpoint::new(Point::new(0.0, 8.0, 0.0), Point::ORIGIN, lens);
    let mut scene = Scene::new("a plane", Image::new(1, 1), eye);
    scene.camera.exposure_time = 0.5;
    scene.materials.push(matte("floor", 0.25, 0.8, [0.9, 0.4, 0.1]));
    let plane = Plane { point: Point::ORIGIN, normal: Vector::new(0.0, 2.0, 0.0) };
    scene.objects.push(Object::new("floor", "floor", plane));
    scene.lights.push(light);
    scene
}

/// What they see of a plane is what we see.
fn radiances_agree(scene: &Scene, distance: f64, cos: f64) -> [f64; 3] {
    let ours = render::pixel(&World::build(scene).expect("it is valid"), [0, 0]).to_array();
    near_all(&their_radiance(&said(scene), distance, cos), ours);
    ours
}

/// Law: radiance: a matte plane of kd 0.8 under a directional light of radiance π at 60° from its normal, at exposure 1/2,
/// has 0.8 · cd · cos 60° / 2. Oracle: that number; and our picture.
#[test]
fn a_matte_plane_has_its_radiance() {
    let direction = Vector::new(3.0_f64.sqrt(), 1.0, 0.0);
    let sun = Directional { ls: PI, color: Rgb::WHITE, direction };
    let scene = plane_below(Light::new("sun", sun));
    let ours = radiances_agree(&scene, 1.0, 0.5);
    near_all(&ours, [0.9, 0.4, 0.1].map(|cd| 0.8 * cd * 0.5 * 0.5));
    let parsed = said(&scene);
    let light = parsed.one("light_source");
    let (from, to) = (vector(&light.values[0]), vector(&light.vector("point_at")));
    assert!(light.has("parallel"));
    near_all(
        &(from - to).unit().expect("apart").to_array(),
        direction.unit().expect("not zero").to_array(),
    );
}

/// Law: scaling: the light of a lamp 2 above the plane falls with the power of its distance that the scene says. Oracle:
/// ls · kd · cd / π / 2^k.
#[test]
fn a_lamp_fades_with_its_distance() {
    for attenuation in [0.0, 1.0, 2.0, 3.5] {
        let location = Point::new(0.0, 2.0, 0.0);
        let lamp = PointLight { ls: 3.0, color: Rgb::new(1.0, 0.5, 0.25), location, attenuation };
        let scene = plane_below(Light::new("lamp", lamp).without_shadows());
        let parsed = said(&scene);
        near_all(&parsed.one("light_source").values[0], [0.0, 2.0, 0.0]);
        assert!(parsed.one("light_source").has("shadowless"));
        // f^a = 1e-9 beside 2^a
        let ours =
            [0.9, 0.2, 0.025].map(|c| 0.5 * 3.0 * 0.8 * c / PI / math::power(2.0, attenuation));
        for (theirs, ours) in their_radiance(&parsed, 2.0, 1.0).into_iter().zip(ours) {
            assert!(
                (theirs / ours - 1.0).abs() < 1e-9,
                "{attenuation}: {theirs} instead of {ours}"
            );
        }
    }
}

/// Law: the lights that are everywhere add up, and reflect by ka. Oracle: our picture.
#[test]
fn ambient_lights_add_up() {
    let mut scene =
        plane_below(Light::new("a", Ambient { ls: 0.5, color: Rgb::new(1.0, 0.5, 0.25) }));
    scene.lights.push(Light::new("b", Ambient { ls: 0.25, color: Rgb::WHITE }));
    scene.lights.push(Light {
        enabled: false,
        ..Light::new("off", Ambient { ls: 9.0, color: Rgb::WHITE })
    });
    radiances_agree(&scene, 1.0, 1.0);
}

/// The first texture of a statement is that of the side its normal points to.
pub(super) fn outside_is_front(statement: &Statement) -> bool {
    let named = |word: &str| statement.words.iter().any(|(name, _)| name == word);
    assert!(named("front_0") && named("back_0"));
    let at = |word: &str| statement.words.iter().position(|(name, _)| name == word);
    let (texture, interior) = (at("texture"), at("interior_texture"));
    let front = at("front_0");
    assert!(texture < interior);
    front < interior
}

/// Law: the front is on the side of our normal: POV-Ray's normal of `triangle` is (v0 − v1) × (v2 − v1), computed from the
/// corners that are written, also of a mirrored one. Oracle: the normal of our built shape.
#[test]
fn triangles_have_their_front_where_our_normal_is() {
    let vertices =
        [Point::new(0.0, 0.0, 0.0), Point::new(2.0, 0.5, 0.0), Point::new(0.5, 1.5, 1.0)];
    let triangle = Triangle { vertices, normals: None };
    let mirrored = vec![Step::Scale(Vector::new(-1.0, 1.0, 2.0)), Step::RotateZ(40.0)];
    for steps in [vec![], mirrored] {
        let mut scene = askew(Pinhole { distance: 6.0, zoom: 1.0 });
        scene.objects.push(Object::new("t", "red", Instance::new(triangle.clone(), steps)));
        let world = World::build(&scene).expect("it is valid");
        let parsed = said(&scene);
        let corners: Vec<Vector> =
            parsed.one("triangle").values.iter().map(|corner| vector(corner)).collect();
        let theirs = (corners[0] - corners[1]).cross(corners[2] - corners[1]);
        let centre = Point::ORIGIN + (corners[0] + corners[1] + corners[2]) / 3.0;
        let along = theirs.unit().expect("not zero");
        let ray = Ray::new(centre + 3.0 * along, -along);
        let hit = world.hit(&ray, groundtruth::math::Span::AHEAD).expect("it is there");
        let is_same = hit.surface.normal.dot(theirs) > 0.0;
        assert_eq!(outside_is_front(parsed.one("triangle")), is_same);
    }
}

/// Law: an inward shape has its front inside; a rectangle has it where a × b points.
#[test]
fn inward_shapes_have_their_front_inside() {
    let mut scene = askew(Pinhole { distance: 6.0, zoom: 1.0 });
    let tube = |inward| OpenCylinder { y0: -1.0, y1: 2.5, radius: 0.5, inward };
    scene.objects.push(Object::new("outside", "red", tube(false)));
    scene.objects.push(Object::new("inside", "red", tube(true)));
    let (a, b) = (Vector::new(2.0, 0.0, 0.0), Vector::new(0.0, 3.0, 0.0));
    scene.objects.push(Object::new("wall", "red", Rectangle { corner: Point::ORIGIN, a, b }));
    let parsed = said(&scene);
    let [outside, inside] = parsed.all("cylinder")[..] else { panic!("two cylinders") };
    assert_eq!([outside_is_front(outside), outside_is_front(inside)], [true, false]);
    near_all(&outside.values[0], [0.0, -1.0, 0.0]);
    near_all(&outside.values[1], [0.0, 2.5, 0.0]);
    assert!(outside.has("open"));
    for half in parsed.all("triangle") {
        let corners: Vec<Vector> = half.values.iter().map(|corner| vector(corner)).collect();
        let theirs = (corners[0] - corners[1]).cross(corners[2] - corners[1]);
        assert_eq!(
            outside_is_front(half),
            theirs.dot(Normal::new(a.cross(b)).expect("not zero")) > 0.0
        );
    }
}

/// Law: the back of a one-sided surface keeps ambient light and its mirror, and nothing else; that of a two-sided one is
/// its front. Oracle: the formulas of `describe`.
#[test]
fn backs_are_dark_unless_two_sided() {
    let mut scene = askew(Pinhole { distance: 6.0, zoom: 1.0 });
    scene.tracer = Tracer::Whitted(Whitted { max_depth: 3 });
    let mirror = Reflective {
        phong: Default::default(),
        kr: 0.5.into(),
        cr: Rgb::new(1.0, 0.5, 0.25).into(),
    };
    let lamp = Emissive::new(4.0, Rgb::new(1.0, 0.5, 0.25));
    scene.materials.push(Material { two_sided: true, ..matte("both", 0.25, 0.5, [1.0; 3]) });
    scene.materials.push(Material::new("mirror", mirror));
    scene.materials.push(Material::new("lamp", lamp));
    for name in ["red", "both", "mirror", "lamp"] {
        let sphere = Sphere { center: Point::ORIGIN, radius: 1.0, inward: false };
        scene.objects.push(Object::new(name, name, sphere));
    }
    let parsed = said(&scene);
    near(parsed.textures["front_0"].number("diffuse"), 0.8 / PI);
    near(parsed.textures["back_0"].number("diffuse"), 0.0);
    assert_eq!(parsed.textures["front_1"], parsed.textures["back_1"]);
    for side in ["front_2", "back_2"] {
        // the second `rgb`: the first is the pigment
        let colors: Vec<_> =
            parsed.textures[side].words.iter().filter(|(word, _)| word == "rgb").collect();
        near_all(&colors[1].1[0], [0.5, 0.25, 0.125]);
    }
    near(parsed.textures["front_3"].number("emission"), 4.0);
    near_all(&parsed.textures["front_3"].vector("rgb"), [1.0, 0.5, 0.25]);
    assert!(parsed.textures["front_3"].has("exposed"));
    near_all(&parsed.textures["back_3"].vector("rgb"), [0.0; 3]);
    near(parsed.one("global_settings").number("max_trace_level"), 4.0);
    near(parsed.one("global_settings").number("adc_bailout"), 0.0);
    near(parsed.one("global_settings").number("assumed_gamma"), 1.0);
}

/// Law: what casts no shadow says so, by the object or by its material.
#[test]
fn shadowless_objects_say_so() {
    let mut scene = askew(Pinhole { distance: 6.0, zoom: 1.0 });
    scene.materials.push(Material { casts_shadows: false, ..matte("air", 0.0, 0.5, [1.0; 3]) });
    let sphere = || Sphere { center: Point::ORIGIN, radius: 1.0, inward: false };
    scene.objects.push(Object::new("a", "red", sphere()));
    scene.objects.push(Object { casts_shadows: false, ..Object::new("b", "red", sphere()) });
    scene.objects.push(Object::new("c", "air", sphere()));
    let parsed = said(&scene);
    let found: Vec<bool> = parsed.all("sphere").iter().map(|it| it.has("no_shadow")).collect();
    assert_eq!(found, [false, true, true]);
}

/// Law: the texture of an instance is looked up in its own coordinates, or where the instance stands still, in those
/// around it. Oracle: the matrix of the shape beside that of its texture.
#[test]
fn textures_move_with_instances_unless_still() {
    let mut scene = askew(Pinhole { distance: 6.0, zoom: 1.0 });
    let checker = Checker3d { size: 2.0, color1: Rgb::WHITE.into(), color2: Rgb::BLACK.into() };
    let floor = Matte { ka: 0.0.into(), kd: 0.5.into(), cd: checker.into() };
    scene.materials.push(Material::new("checked", floor));
    let moved = |by: f64| vec![Step::Translate(Vector::new(by, 0.0, 0.0))];
    let sphere = Sphere { center: Point::ORIGIN, radius: 1.0, inward: false };
    let still = Instance { transform_texture: false, ..Instance::new(sphere, moved(1.0)) };
    scene.objects.push(Object::new("ball", "checked", Instance::new(still, moved(10.0))));
    let parsed = said(&scene);
    let matrices: Vec<f64> = parsed
        .one("sphere")
        .words
        .iter()
        .filter(|(word, _)| word == "matrix")
        .map(|(_, values)| values[0][9])
        .collect();
    assert_eq!(matrices, [11.0, 10.0, 10.0], "of the shape, and of the textures of its sides");
}

/// Law: the functions of checkers are ours. Oracle: our texture, beside the written function computed here by the rules of
/// POV-Ray's functions (`floor`, `abs`, `mod` as the remainder of C, `select` for negative or not).
#[test]
fn checkers_are_our_functions() {
    let colors = [Rgb::new(1.0, 0.0, 0.0), Rgb::new(0.0, 1.0, 0.0), Rgb::new(0.0, 0.0, 1.0)];
    let [color1, color2, outline_color] = colors.map(Into::into);
    let solid = Checker3d { size: 0.75, color1, color2 };
    let [color1, color2] = [colors[0], colors[1]].map(Into::into);
    let lines = PlaneChecker { size: 0.5, color1, color2, outline_width: 0.0625, outline_color };
    let kinds: [groundtruth::textures::Kind; 2] = [solid.into(), lines.into()];
    for kind in kinds {
        let text = function_of(&kind);
        let built = kind.build(&mut Resources::new(Path::new(""))).expect("it is valid");
        for index in 0..200 {
            let at = [0.137, -0.219, 0.0913].map(|step| f64::from(index) * step - 3.0 * step);
            let surface = Surface::new(Point::new(at[0], at[1], at[2]), 0.0, Normal::Y);
            let value = super::function::value(&text, at);
            let color = colors[usize::from(value > 1.0 / 3.0) + usize::from(value > 2.0 / 3.0)];
            assert_eq!(built.color(&TexturePoint::new(&surface)), color, "{text} at {at:?}");
        }
    }
}

/// The function in the pigment of a material with this texture.
fn function_of(kind: &groundtruth::textures::Kind) -> String {
    let mut scene = askew(Pinhole { distance: 6.0, zoom: 1.0 });
    let cd = groundtruth::textures::Paint::Textured(Box::new(kind.clone()));
    scene.materials.push(Material::new("it", Matte { ka: 0.0.into(), kd: 0.5.into(), cd }));
    let sphere = Sphere { center: Point::ORIGIN, radius: 1.0, inward: false };
    scene.objects.push(Object::new("ball", "it", sphere));
    let text = exchange::export::pov::write("scene", &scene, "".as_ref()).expect("it can be said");
    let start = text.find("function { ").expect("a function") + "function { ".len();
    text[start..].split(" }").next().expect("its end").to_owned()
}
