//! Mitsuba, the fixtures of radiance and scaling, and each factor of a convention.

use std::f64::consts::PI;

use exchange::export::{Term, mitsuba};
use groundtruth::cameras::{Pinhole, Viewpoint};
use groundtruth::lights::{Area, Directional, PointLight};
use groundtruth::materials::{Dielectric, Emissive, Matte, Medium, Reflective};
use groundtruth::math::{Point, Step, Transform, Vector};
use groundtruth::render;
use groundtruth::rgb::Rgb;
use groundtruth::scene::{Depth, Image, Light, Material, Object, Scene, Tracer, Whitted};
use groundtruth::shapes::{Cuboid, Disk, Instance, OpenCylinder, Plane, Rectangle, Sphere};
use groundtruth::world::World;

use super::xml::{self, Element, image, scenes};

/// A few roundings of numbers of magnitude 1 to 100.
const ROUNDING: f64 = 1e-12;

pub fn near_all(found: [f64; 3], expected: [f64; 3]) {
    for (found, expected) in found.into_iter().zip(expected) {
        let error = (found - expected).abs();
        assert!(error <= ROUNDING * (1.0 + expected.abs()), "found {found}, expected {expected}");
    }
}

fn near(found: f64, expected: f64) {
    near_all([found, 0.0, 0.0], [expected, 0.0, 0.0]);
}

pub fn unit(vector: [f64; 3]) -> [f64; 3] {
    let [x, y, z] = vector;
    Vector::new(x, y, z).unit().expect("not zero").to_array()
}

fn matte(name: &str, kd: f64, cd: [f64; 3]) -> Material {
    let [r, g, b] = cd;
    Material::new(name, Matte { ka: 0.0.into(), kd: kd.into(), cd: Rgb::new(r, g, b).into() })
}

fn sun() -> Light {
    let direction = Vector::new(3.0_f64.sqrt(), 1.0, 0.0);
    Light::new("sun", Directional { ls: PI, color: Rgb::new(1.0, 0.5, 0.25), direction })
}

/// A camera that is askew over a lit matte ball.
pub fn askew(lens: impl Into<groundtruth::cameras::Kind>) -> Scene {
    let mut image = Image::new(9, 5);
    image.pixel_size = 0.25;
    let mut camera = Viewpoint::new(Point::new(3.0, 4.0, 7.0), Point::new(-1.0, 0.5, 0.25), lens);
    camera.roll = 20.0;
    let mut scene = Scene::new("which object -- is <where>", image, camera);
    scene.materials.push(matte("red", 0.8, [0.9, 0.2, 0.1]));
    let sphere = Sphere { center: Point::ORIGIN, radius: 1.0, inward: false };
    scene.objects.push(Object::new("ball", "red", sphere));
    scene.lights.push(sun());
    scene
}

/// A matte plane y = 0 that a camera 8 above it looks down on, near the origin, at half the exposure.
fn plane_below(light: Light) -> Scene {
    let lens = Pinhole { distance: 100.0, zoom: 1.0 };
    let eye = Viewpoint::new(Point::new(0.0, 8.0, 0.0), Point::ORIGIN, lens);
    let mut scene = Scene::new("a plane", Image::new(1, 1), eye);
    scene.camera.exposure_time = 0.5;
    scene.materials.push(matte("floor", 0.8, [0.9, 0.4, 0.1]));
    let plane = Plane { point: Point::ORIGIN, normal: Vector::new(0.0, 2.0, 0.0) };
    scene.objects.push(Object::new("floor", "floor", plane));
    scene.lights.push(light);
    scene
}

fn ours(scene: &Scene) -> [f64; 3] {
    render::pixel(&World::build(scene).expect("it is valid"), [0, 0]).to_array()
}

/// Law: radiance: a matte plane of kd 0.8 under a directional light at 60° from its normal, at exposure 1/2. Oracle:
/// reflectance / π · irradiance · cosθ of what is written, kd · cd / π · ls · color · cosθ / 2 by hand, and our picture.
#[test]
fn a_matte_plane_has_its_radiance() {
    let scene = plane_below(sun());
    let parsed = xml::scene(&scene);
    let light = parsed.one("emitter", "directional");
    let reflectance = parsed.one("bsdf", "diffuse").color("reflectance");
    let irradiance = light.color("irradiance");
    let [x, y, z] = unit(light.coordinates("direction"));
    // the light goes down; the normal is up
    let theirs = [0, 1, 2].map(|i| reflectance[i] / PI * irradiance[i] * -y);
    near_all(theirs, ours(&scene));
    near_all(theirs, [0.9, 0.2, 0.025].map(|c| 0.8 * c * 0.5 * 0.5));
    near_all([-x, -y, -z], unit([3.0_f64.sqrt(), 1.0, 0.0]));
}

/// Law: scaling: the light of a lamp falls with the square of its distance. Oracle: reflectance / π · I / d² of what is
/// written, beside our picture; other powers are refused.
#[test]
fn a_lamp_fades_with_the_square_of_its_distance() {
    let location = Point::new(0.0, 2.0, 0.0);
    let lamp = PointLight { ls: 3.0, color: Rgb::new(1.0, 0.5, 0.25), location, attenuation: 2.0 };
    let scene = plane_below(Light::new("lamp", lamp.clone()));
    let parsed = xml::scene(&scene);
    let light = parsed.one("emitter", "point");
    near_all(light.coordinates("position"), [0.0, 2.0, 0.0]);
    let (reflectance, intensity) =
        (parsed.one("bsdf", "diffuse").color("reflectance"), light.color("intensity"));
    near_all([0, 1, 2].map(|i| reflectance[i] / PI * intensity[i] / 4.0), ours(&scene));
    for attenuation in [0.0, 1.0, 3.0] {
        let lamp = PointLight { attenuation, ..lamp.clone() };
        let scene = plane_below(Light::new("lamp", lamp));
        let all = mitsuba::write("", "", &scene, "".as_ref()).expect_err("it cannot be said");
        assert_eq!(all[0].path, "lights[0] \"lamp\": source.point.attenuation");
    }
}

/// A lamp that is a rectangle 2 × 3, with its light.
fn lamp(steps: Vec<Step>) -> Scene {
    let mut scene =
        plane_below(Light::new("light", Area { object: "lamp".into(), sampling: None }));
    scene.materials.push(Material::new("lamp", Emissive::new(4.0, Rgb::new(1.0, 0.5, 0.25))));
    let (a, b) = (Vector::new(2.0, 0.0, 0.0), Vector::new(0.0, 0.0, 3.0));
    let shape = Rectangle { corner: Point::new(0.0, 5.0, 0.0), a, b };
    scene.objects.push(Object::new("lamp", "lamp", Instance::new(shape, steps)));
    scene
}

/// Law: an area light has the radiance ls · ce, at the scene's exposure, on the side of our normal, which a reflection keeps.
/// Oracle: the normal of our built shape, hit by a ray.
#[test]
fn an_area_light_shines_on_its_front() {
    let mirrored = vec![Step::Scale(Vector::new(-1.0, 1.0, 1.0)), Step::RotateZ(40.0)];
    for steps in [vec![], mirrored] {
        let scene = lamp(steps);
        let parsed = xml::scene(&scene);
        let [theirs] = parsed
            .all("shape", "rectangle")
            .into_iter()
            .filter(|it| !it.all("emitter", "area").is_empty())
            .collect::<Vec<_>>()[..]
        else {
            panic!("one lamp")
        };
        near_all(theirs.one("emitter", "area").color("radiance"), [2.0, 1.0, 0.5]);
        assert!(theirs.named("flip_normals").is_none());
        let map = theirs.matrix("to_world");
        let [n, middle] = [[0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0]].map(|it| image(&map, it));
        let [n, middle] = [n, middle].map(|[x, y, z]| Vector::new(x, y, z));
        let world = World::build(&scene).expect("it is valid");
        let ray = groundtruth::math::Ray::new(Point::ORIGIN + middle + n, -n);
        let hit = world.hit(&ray, groundtruth::math::Span::AHEAD).expect("it is there");
        near_all(hit.surface.normal.to_array(), n.to_array());
        // the corners, by the images of the corners of the square from −1 to 1
        let corner = image(&map, [-1.0, -1.0, 0.0, 1.0]);
        let back = Transform::from_steps(&match &scene.objects[1].shape {
            groundtruth::shapes::Kind::Instance(it) => it.transform.clone(),
            _ => vec![],
        })
        .expect("it has an inverse")
        .inverse();
        let [x, y, z] = corner;
        near_all(back.point(Point::new(x, y, z)).to_array(), [0.0, 5.0, 0.0]);
    }
}

/// Law: an object that is a lamp is dark where its light is off.
#[test]
fn a_lamp_whose_light_is_off_is_dark() {
    let mut scene = lamp(vec![]);
    scene.lights[0].enabled = false;
    scene.lights.push(sun());
    for pass in scenes(&scene) {
        assert!(pass.all("shape", "").iter().all(|it| it.all("emitter", "").is_empty()));
    }
}

/// Law: paths have one edge more than ours, which do not count the camera's ray; direct light has two. Only path tracers
/// end long paths at random.
#[test]
fn depths_count_edges() {
    let depth = |tracer| {
        let mut scene = askew(Pinhole { distance: 6.0, zoom: 1.0 });
        scene.tracer = tracer;
        let parsed = xml::scene(&scene);
        let path = parsed.one("integrator", "path");
        (path.number("max_depth"), path.named("rr_depth").is_some())
    };
    assert_eq!(depth(Tracer::RayCast), (2.0, true));
    assert_eq!(depth(Tracer::Whitted(Whitted { max_depth: 7 })), (2.0, true));
    assert_eq!(depth(Tracer::Path(Depth { max_depth: 7 })), (8.0, false));
}

/// Law: a background that lights nothing, and each light, are pictures of their own; only a sky lights. Oracle: what is
/// in each scene.
#[test]
fn light_that_is_only_seen_is_a_picture_of_its_own() {
    let mut scene = askew(Pinhole { distance: 6.0, zoom: 1.0 });
    scene.background = Rgb::new(0.5, 0.25, 0.125).into();
    scene.camera.exposure_time = 2.0;
    scene.lights.push(Light { name: "second".into(), ..sun() });
    let [seen, first, second] = &scenes(&scene)[..] else { panic!("three scenes") };
    near_all(seen.one("emitter", "constant").color("radiance"), [1.0, 0.5, 0.25]);
    // and the black lamp that takes its samples
    near_all(seen.one("emitter", "point").color("intensity"), [0.0; 3]);
    assert_eq!(seen.one("integrator", "path").number("max_depth"), 1.0);
    near_all(seen.one("bsdf", "diffuse").color("reflectance"), [0.0; 3]);
    for lit in [first, second] {
        assert_eq!(lit.all("emitter", "").len(), 1);
        near_all(lit.one("bsdf", "diffuse").color("reflectance"), [0.72, 0.16, 0.08]);
    }
    // paths meet the background: one scene
    scene.tracer = Tracer::Path(Depth { max_depth: 3 });
    assert_eq!(xml::scene(&scene).all("emitter", "").len(), 3);
}

/// Law: a mirror over a matte base is a blend of both that adds up to kr · cr and kd · cd; the back of a one-sided surface
/// has the mirror only. Oracle: weight · specular reflectance and (1 − weight) · reflectance.
#[test]
fn a_mirror_over_a_matte_base_is_a_blend() {
    let mut scene = askew(Pinhole { distance: 6.0, zoom: 1.0 });
    scene.tracer = Tracer::Path(Depth { max_depth: 3 });
    let phong = groundtruth::materials::Phong {
        kd: 0.5.into(),
        cd: Rgb::new(0.8, 0.4, 0.2).into(),
        ..Default::default()
    };
    let cr = Rgb::new(1.0, 0.5, 0.25).into();
    let mirror = |phong| Reflective { phong, kr: 0.25.into(), cr };
    scene.materials[0].recipe = mirror(phong).into();
    let parsed = xml::scene(&scene);
    let [front, back] = parsed.one("bsdf", "twosided").all("bsdf", "blendbsdf")[..] else {
        panic!("two sides")
    };
    for (side, kd) in [(front, 0.5), (back, 0.0)] {
        let weight = side.number("weight");
        let [base, mirror] = side.all("bsdf", "")[..] else { panic!("two parts") };
        let reflectance = base.color("reflectance").map(|it| (1.0 - weight) * it);
        near_all(reflectance, [0.8, 0.4, 0.2].map(|cd| kd * cd));
        assert_eq!((mirror.kind(), mirror.value("material")), ("conductor", "none"));
        let specular = mirror.color("specular_reflectance").map(|it| weight * it);
        near_all(specular, [0.25, 0.125, 0.0625]);
    }
    // without a base: the mirror alone, on both sides
    let cr = Rgb::new(1.0, 0.5, 0.25).into();
    scene.materials[0].recipe =
        Reflective { phong: Default::default(), kr: 0.25.into(), cr }.into();
    let parsed = xml::scene(&scene);
    let mirror = parsed.one("bsdf", "twosided").one("bsdf", "conductor");
    near_all(mirror.color("specular_reflectance"), [0.25, 0.125, 0.0625]);
}

/// Law: glass has the indices of its inner and outer side, the normal outward.
#[test]
fn glass_has_its_indices() {
    let mut scene = askew(Pinhole { distance: 6.0, zoom: 1.0 });
    scene.tracer = Tracer::Path(Depth { max_depth: 3 });
    let glass = Dielectric {
        inside: Medium::clear(1.5),
        outside: Medium::clear(1.25),
        ..Default::default()
    };
    scene.materials[0].recipe = glass.into();
    let parsed = xml::scene(&scene);
    let bsdf = parsed.one("bsdf", "dielectric");
    assert_eq!((bsdf.number("int_ior"), bsdf.number("ext_ior")), (1.5, 1.25));
}

/// Law: among clear glass no path ends at random. Oracle: such a path loses no light, so ours never ends one.
#[test]
fn paths_through_clear_glass_have_no_roulette() {
    let mut scene = askew(Pinhole { distance: 6.0, zoom: 1.0 });
    scene.tracer = Tracer::Path(Depth { max_depth: 7 });
    scene.background = Rgb::WHITE.into();
    scene.materials[0].recipe =
        Dielectric { inside: Medium::clear(1.5), ..Default::default() }.into();
    let path = xml::scene(&scene);
    let path = path.one("integrator", "path");
    assert!(path.number("rr_depth") > path.number("max_depth"));
}

/// Law: backs are dark unless the material is two-sided; an inward shape has its front inside.
#[test]
fn sides_are_ours() {
    let mut scene = askew(Pinhole { distance: 6.0, zoom: 1.0 });
    let tube = |inward| OpenCylinder { y0: -1.0, y1: 2.5, radius: 0.5, inward };
    scene.materials.push(Material { two_sided: true, ..matte("both", 0.5, [1.0; 3]) });
    scene.objects.push(Object::new("outside", "red", tube(false)));
    scene.objects.push(Object::new("inside", "both", tube(true)));
    let parsed = xml::scene(&scene);
    let [outside, inside] = parsed.all("shape", "cylinder")[..] else { panic!("two cylinders") };
    assert!(outside.named("flip_normals").is_none());
    assert_eq!(inside.value("flip_normals"), "true");
    near_all(outside.coordinates("p0"), [0.0, -1.0, 0.0]);
    near_all(outside.coordinates("p1"), [0.0, 2.5, 0.0]);
    let of = |shape: &Element| {
        let id = shape.one("ref", "").attribute("id").to_owned();
        let bsdf = parsed.all("bsdf", "").into_iter().find(|it| it.attribute("id") == id);
        bsdf.expect("it is written").kind().to_owned()
    };
    assert_eq!([of(outside), of(inside)], ["diffuse", "twosided"]);
}

/// Law: coordinates: a transformed object is where ours is. Oracle: our transform of points of the shape, beside their
/// matrix; of a similarity, the centre and a length.
#[test]
fn instances_are_where_ours_are() {
    let turned = vec![
        Step::Scale(Vector::new(-2.0, 2.0, 2.0)),
        Step::RotateX(30.0),
        Step::Translate(Vector::new(5.0, 6.0, 7.0)),
    ];
    let mut sheared = turned.clone();
    sheared.insert(1, Step::Shear([0.0, 0.5, 0.0, 0.0, 0.25, 0.0]));
    let [similar, general] =
        [&turned, &sheared].map(|it| Transform::from_steps(it).expect("valid"));
    let sphere = Sphere { center: Point::new(0.5, 1.0, 1.5), radius: 2.0, inward: false };
    let cube = Cuboid { min: Point::new(0.0, 1.0, 2.0), max: Point::new(2.0, 4.0, 8.0) };
    let normal = Vector::new(0.0, 3.0, 4.0);
    let disk = Disk { center: Point::new(1.0, 2.0, 3.0), normal, radius: 2.0 };
    let mut scene = askew(Pinhole { distance: 6.0, zoom: 1.0 });
    scene.objects.clear();
    let add = |scene: &mut Scene, name: &str, shape: Instance| {
        scene.objects.push(Object::new(name, "red", shape));
    };
    add(&mut scene, "ball", Instance::new(sphere.clone(), turned.clone()));
    add(&mut scene, "egg", Instance::new(sphere.clone(), sheared.clone()));
    add(&mut scene, "box", Instance::new(cube, sheared.clone()));
    add(&mut scene, "disk", Instance::new(disk, sheared));
    let parsed = xml::scene(&scene);
    let ball = parsed.one("shape", "sphere");
    near_all(ball.coordinates("center"), similar.point(sphere.center).to_array());
    near(ball.number("radius"), 4.0);
    let egg = parsed.one("shape", "shapegroup").one("shape", "sphere");
    near_all(egg.coordinates("center"), [0.5, 1.0, 1.5]);
    near(egg.number("radius"), 2.0);
    let map = parsed.one("shape", "instance").matrix("to_world");
    let at = |p: [f64; 3]| general.point(Point::new(p[0], p[1], p[2])).to_array();
    for p in [[0.0, 0.0, 0.0], [1.0, 2.0, -3.0]] {
        near_all(image(&map, [p[0], p[1], p[2], 1.0]), at(p));
    }
    let map = parsed.one("shape", "cube").matrix("to_world");
    // x is turned round, because the map is a reflection: the same box
    near_all(image(&map, [1.0, -1.0, -1.0, 1.0]), at([0.0, 1.0, 2.0]));
    near_all(image(&map, [-1.0, 1.0, 1.0, 1.0]), at([2.0, 4.0, 8.0]));
    let columns = [0, 1, 2].map(|j| Vector::new(map[0][j], map[1][j], map[2][j]));
    assert!(columns[0].cross(columns[1]).dot(columns[2]) > 0.0, "triangles keep their side");
    let map = parsed.one("shape", "disk").matrix("to_world");
    near_all(image(&map, [0.0, 0.0, 0.0, 1.0]), at([1.0, 2.0, 3.0]));
    // the images of its rim are on our disk: two units from its centre, across its normal
    for [x, y] in [[1.0, 0.0], [0.6, 0.8], [0.0, -1.0]] {
        let [x, y, z] = image(&map, [x, y, 0.0, 1.0]);
        let back = general.inverse().point(Point::new(x, y, z)) - disk_center();
        near(back.length(), 2.0);
        near(back.dot(normal), 0.0);
    }
    let n = unit(image(&map, [0.0, 0.0, 1.0, 0.0]));
    let front = groundtruth::math::Normal::new(normal).expect("not zero");
    near_all(n, unit(general.covector(front).to_array()));
}

fn disk_center() -> Point {
    Point::new(1.0, 2.0, 3.0)
}

/// Law: `--without unshadowed` makes everything block all light; before, what does not is refused with its place.
#[test]
fn light_that_nothing_blocks_is_refused() {
    let mut scene = askew(Pinhole { distance: 6.0, zoom: 1.0 });
    scene.lights[0].shadows = false;
    scene.objects[0].casts_shadows = false;
    scene.materials[0].casts_shadows = false;
    let all = mitsuba::write("", "", &scene, "".as_ref()).expect_err("it cannot be said");
    let paths: Vec<&str> = all.iter().map(|it| it.path.as_str()).collect();
    let expected = [
        "lights[0] \"sun\": shadows",
        "objects[0] \"ball\": casts_shadows",
        "materials[0] \"red\": casts_shadows",
    ];
    assert_eq!(paths, expected);
    Term::Unshadowed.remove(&mut scene);
    assert!(mitsuba::write("", "", &scene, "".as_ref()).is_ok());
}

/// Law: the sky is sampled by the material where ours is drawn from by the cosine: its weight is 0, and a black lamp takes
/// the samples, which Mitsuba must draw; the recommended path tracer samples it, if it is a light.
#[test]
fn the_sky_is_sampled_as_ours() {
    let mut scene = askew(Pinhole { distance: 6.0, zoom: 1.0 });
    scene.background = Rgb::WHITE.into();
    scene.lights = vec![Light::new("sky", groundtruth::lights::Environment {})];
    let parsed = xml::scene(&scene);
    assert_eq!(parsed.one("emitter", "constant").number("sampling_weight"), 0.0);
    near_all(parsed.one("emitter", "point").color("intensity"), [0.0; 3]);
    scene.tracer = Tracer::Path(Depth { max_depth: 3 });
    let parsed = xml::scene(&scene);
    assert_eq!(parsed.one("emitter", "").number("sampling_weight"), 1.0);
    scene.lights = vec![sun()];
    let parsed = xml::scene(&scene);
    assert_eq!(parsed.one("emitter", "constant").number("sampling_weight"), 0.0);
}
