//! pbrt-v4: rays, transforms and radiances restored from the text by pbrt's own formulas; and each factor of a convention.

use std::f64::consts::PI;
use std::path::Path;

use groundtruth::cameras::{Orthographic, Pinhole, Side, ThinLens, Viewpoint};
use groundtruth::kinds::Resources;
use groundtruth::lights::{Area, Directional, Environment, PointLight};
use groundtruth::materials::{Dielectric, Emissive, Matte, Medium};
use groundtruth::math::{self, Normal, Point, Span, Step, Transform, Vector};
use groundtruth::render;
use groundtruth::rgb::Rgb;
use groundtruth::scene::{Depth, Image, Light, Material, Object, Scene, Tracer, Whitted};
use groundtruth::shapes::{
    self, Annulus, Compound, Cuboid, Disk, Instance, Lattice, OpenCylinder, PartAnnulus,
    PartCylinder, PartSphere, Plane, RandomSpheres, Rectangle, Sphere, Surface, TessellatedSphere,
    Triangle,
};
use groundtruth::textures::{self, Checker3d, PlaneChecker, RandomColors, TexturePoint};
use groundtruth::world::World;

use super::pbrt_parsed::{self as parsed, Read, Statement, axes, moved, read, written};

/// A few roundings of numbers of magnitude 1 to 100.
const ROUNDING: f64 = 1e-12;

fn near(found: f64, expected: f64) {
    let error = (found - expected).abs();
    assert!(error <= ROUNDING * (1.0 + expected.abs()), "found {found}, expected {expected}");
}

fn near_all(found: [f64; 3], expected: [f64; 3]) {
    found.into_iter().zip(expected).for_each(|(found, expected)| near(found, expected));
}

fn matte(name: &str, kd: f64, cd: impl Into<Rgb>) -> Material {
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

fn pinhole() -> Scene {
    askew(Pinhole { distance: 6.0, zoom: 1.0 })
}

/// The point of the world for one of the camera: `p = R⁻¹ (q − t)`, by Cramer's rule.
fn to_world(camera: &Statement, q: Vector) -> Vector {
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

/// A point of pbrt's shape at the parameters `(u, v)` of its parameterisation, and its normal `dp/du × dp/dv`, in its own
/// coordinates, by the formulas of its source (`shapes.h`). A parameter outside 0 to 1 is beyond its edge.
fn their_point(shape: &Statement, [u, v]: [f64; 2]) -> (Vector, Vector) {
    let of = |name: &str, default: f64| shape.parameters.number_or(name, default);
    let radius = of("radius", 1.0);
    let phi = (u * of("phimax", 360.0)).to_radians();
    let (sin, cos) = (math::sin(phi), math::cos(phi));
    match shape.kind.as_str() {
        "sphere" => {
            let (bottom, top) = (of("zmin", -radius), of("zmax", radius));
            let [from, to] = [bottom, top].map(|z| math::acos((z / radius).clamp(-1.0, 1.0)));
            let theta = from + v * (to - from);
            let (s, c) = (math::sin(theta), math::cos(theta));
            let p = radius * Vector::new(s * cos, s * sin, c);
            (p, p)
        }
        "cylinder" => {
            let (bottom, top) = (of("zmin", -1.0), of("zmax", 1.0));
            let out = Vector::new(cos, sin, 0.0);
            (radius * out + (bottom + v * (top - bottom)) * Vector::Z, out)
        }
        "disk" => {
            let rho = radius + v * (of("innerradius", 0.0) - radius);
            (Vector::new(rho * cos, rho * sin, of("height", 0.0)), Vector::Z)
        }
        other => panic!("no quadric {other}"),
    }
}

/// The same in the world: normals turn as covectors, and ReverseOrientation and a mirrored transformation reverse them, of
/// which the second is reversed already by the cross product of mirrored tangents.
fn in_world(shape: &parsed::Shape, (p, n): (Vector, Vector)) -> (Point, Vector) {
    let [a, b, c] = axes(&shape.shape.transform);
    // the rows of the inverse, times the determinant
    let normal = n.x() * b.cross(c) + n.y() * c.cross(a) + n.z() * a.cross(b);
    let determinant = a.dot(b.cross(c));
    let normal = (normal / determinant).unit().expect("not zero");
    let normal = if shape.is_reversed { -normal } else { normal };
    (Point::ORIGIN + moved(&shape.shape.transform, p), normal)
}

/// The points of the triangles of a mesh at barycentric coordinates, and their normals (v0 − v2) × (v1 − v2).
fn their_triangles(shape: &parsed::Shape) -> Vec<(Vector, Vector)> {
    let parameters = &shape.shape.parameters;
    let points: Vec<Vector> =
        parameters.all("P").chunks(3).map(|p| Vector::new(p[0], p[1], p[2])).collect();
    let triangle = |corners: &[f64]| {
        let [a, b, c] = [0, 1, 2].map(|i| points[corners[i] as usize]);
        (0.5 * a + 0.3 * b + 0.2 * c, (a - c).cross(b - c))
    };
    parameters.all("indices").chunks(3).map(triangle).collect()
}

/// Casts a ray onto our object, at a point and against a normal: whether it is hit there, on its front.
fn is_front_at(world: &World, (point, normal): (Point, Vector)) -> Option<bool> {
    let distance = 0.001;
    let ray = math::Ray::new(point + distance * normal, -normal);
    let hit = world.hit(&ray, Span::AHEAD)?;
    ((hit.t - distance).abs() < 1e-9).then_some(hit.front)
}

/// Shapes whose every kind of side counts, as their front shines.
fn kinds_of_shapes() -> Vec<shapes::Kind> {
    let (center, normal) = (Point::new(0.5, 0.25, -0.75), Vector::new(1.0, 2.0, -3.0));
    let [v0, v1, v2] =
        [Point::new(0.0, 0.0, 0.0), Point::new(2.0, 0.5, 0.0), Point::new(0.5, 1.5, 1.0)];
    let sphere = |inward| Sphere { center, radius: 1.5, inward };
    let tube = |inward| OpenCylinder { y0: -0.5, y1: 1.0, radius: 0.75, inward };
    let part = |inward| PartSphere {
        center,
        radius: 1.5,
        phi: [300.0, 80.0],
        theta: [30.0, 100.0],
        inward,
    };
    let arc = |inward| PartCylinder { y0: -0.5, y1: 1.0, radius: 0.75, phi: [30.0, 250.0], inward };
    let ring = |normal| PartAnnulus {
        center,
        normal,
        inner_radius: 0.5,
        outer_radius: 1.0,
        phi: [30.0, 100.0],
    };
    let (inner_radius, outer_radius) = (0.5, 1.25);
    vec![
        sphere(false).into(),
        sphere(true).into(),
        part(false).into(),
        part(true).into(),
        tube(false).into(),
        tube(true).into(),
        arc(false).into(),
        arc(true).into(),
        Disk { center, normal, radius: 1.25 }.into(),
        Annulus { center, normal, inner_radius, outer_radius }.into(),
        ring(Vector::Y).into(),
        ring(-Vector::Y).into(),
        Cuboid { min: Point::new(-1.0, 0.0, 0.5), max: Point::new(0.5, 1.0, 3.0) }.into(),
        Triangle { vertices: [v0, v1, v2], normals: None }.into(),
        Rectangle { corner: v0, a: Vector::new(1.0, 0.5, 0.0), b: Vector::new(-0.5, 1.0, 0.0) }
            .into(),
        TessellatedSphere::new(5, 4, false).into(),
    ]
}

/// Law: each shape is where ours is, within the same edges, and has its front where ours has it, also mirrored. Oracle: points
/// of pbrt's parameterisations, which our built shape has on its front; those beyond an edge it does not have.
#[test]
fn shapes_are_ours_with_their_front() {
    let mirrored = vec![Step::Scale(Vector::new(-1.0, 1.0, 2.0)), Step::RotateZ(40.0)];
    for kind in kinds_of_shapes() {
        for steps in [vec![], mirrored.clone()] {
            let mut scene = pinhole();
            scene.objects.push(Object::new("it", "grey", Instance::new(kind.clone(), steps)));
            let (world, read) = (World::build(&scene).expect("it is valid"), read(&scene));
            let [shape] = &read.shapes[..] else { panic!("one shape") };
            let front = |at| is_front_at(&world, in_world(shape, at));
            if shape.shape.kind == "trianglemesh" {
                for at in their_triangles(shape) {
                    assert_eq!(front(at), Some(true), "{kind:?} at {at:?}");
                }
                continue;
            }
            let at = |u, v| their_point(&shape.shape, [u, v]);
            for (u, v) in [(0.01, 0.3), (0.26, 0.02), (0.55, 0.98), (0.99, 0.6)] {
                assert_eq!(front(at(u, v)), Some(true), "{kind:?} at {u}, {v}");
            }
            let has = |name: &str| shape.shape.parameters.has(name);
            if has("phimax") {
                assert_eq!([front(at(-0.02, 0.5)), front(at(1.02, 0.5))], [None, None], "{kind:?}");
            }
            if has("zmin") || has("innerradius") {
                assert_eq!([front(at(0.5, -0.03)), front(at(0.5, 1.03))], [None, None], "{kind:?}");
            }
        }
    }
}

/// Law: solids and lattices are their parts, each of its own material. Oracle: the number of parts, and rays onto points of
/// each.
#[test]
fn solids_are_their_parts() {
    let ball = Sphere { center: Point::ORIGIN, radius: 0.25, inward: false };
    let spacing = Vector::new(1.0, 2.0, 0.0);
    let lattice = Lattice { of: Box::new(ball.into()), counts: [3, 2, 1], spacing, accel: None };
    let mut can =
        shapes::SolidCylinder { y0: 0.0, y1: 2.0, radius: 0.5, materials: Default::default() };
    can.materials.insert("top".to_owned(), "white".to_owned());
    let kinds: [(shapes::Kind, usize); 2] = [(lattice.into(), 6), (can.into(), 3)];
    for (kind, count) in kinds {
        let mut scene = pinhole();
        scene.materials.push(matte("white", 1.0, Rgb::WHITE));
        scene.objects.push(Object::new("it", "grey", kind));
        let (world, read) = (World::build(&scene).expect("it is valid"), read(&scene));
        assert_eq!(read.shapes.len(), count);
        for shape in &read.shapes {
            let at = in_world(shape, their_point(&shape.shape, [0.3, 0.4]));
            assert_eq!(is_front_at(&world, at), Some(true), "{shape:?}");
        }
        let white = read.shapes.iter().filter(|it| it.material.vector("reflectance").x() == 1.0);
        assert_eq!(white.count(), count / 3 % 2);
    }
}

/// Law: checkers are ours, in the coordinates of the object. Oracle: our texture, beside the formula of pbrt's source
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
    let steps = vec![Step::RotateX(30.0), Step::Translate(Vector::new(0.5, -0.25, 0.125))];
    let map = Transform::from_steps(&steps).expect("it has an inverse");
    for kind in kinds {
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

/// Law: the disk in place of a plane shows the camera all that the plane does. Oracle: our picture of the scene with that disk
/// of ours.
#[test]
fn planes_are_disks_of_the_same_picture() {
    let direction = Vector::new(1.0, 1.5, 0.5);
    let sun = Light::new("sun", Directional { ls: 3.0, color: Rgb::WHITE, direction });
    let mut scene = pinhole();
    scene.lights.push(sun);
    let ball = Sphere { center: Point::new(-1.0, 0.5, 0.0), radius: 1.0, inward: false };
    scene.objects.push(Object::new("ball", "grey", ball));
    let (point, normal) = (Point::new(0.0, -0.5, 0.0), Vector::new(0.125, 1.0, 0.25));
    scene.objects.push(Object::new("floor", "grey", Plane { point, normal }));
    let disk = read(&scene).shapes[1].clone();
    let (center, normal) = in_world(&disk, (Vector::ZERO, Vector::Z));
    let radius = disk.shape.parameters.number("radius");
    let picture = |scene: &Scene| render::render(&World::build(scene).expect("it is valid"));
    let ours = picture(&scene);
    scene.objects[1].shape = Disk { center, normal, radius }.into();
    for (ours, theirs) in ours.pixels().iter().zip(picture(&scene).pixels()) {
        let [ours, theirs] = [ours, theirs].map(|color| color.to_array());
        ours.into_iter().zip(theirs).for_each(|(a, b)| assert!((a - b).abs() < 1e-9, "{a}, {b}"));
    }
    scene.objects[1].shape = Disk { center, normal, radius: 0.05 * radius }.into();
    assert!(picture(&scene).pixels() != ours.pixels(), "it must be so large");
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

/// Law: under a sky, the edge of the disk in place of a plane is at the horizon of all that stands there, but for 2⁻²³.
/// Oracle: the angle height / radius.
#[test]
fn disks_under_a_sky_reach_the_horizon() {
    let mut scene = pinhole();
    scene.background = groundtruth::background::Background::Color(Rgb::grey(0.5));
    scene.lights.push(Light::new("sky", Environment {}));
    let tower = Cuboid { min: Point::new(-4.0, -0.5, -4.0), max: Point::new(-3.0, 9.0, -3.0) };
    scene.objects.push(Object::new("tower", "grey", tower));
    let floor = Plane { point: Point::new(0.0, -0.5, 0.0), normal: Vector::Y };
    scene.objects.push(Object::new("floor", "grey", floor));
    for tracer in [Tracer::RayCast, Tracer::Path(Depth { max_depth: 3 })] {
        scene.tracer = tracer;
        let radius = read(&scene).shapes[1].shape.parameters.number("radius");
        assert!(9.5 / (radius - 20.0) < 1.0 / 8_388_608.0, "{radius}");
    }
    // seen through glass
    let glass = Dielectric { inside: Medium::clear(1.5), ..Dielectric::default() };
    scene.materials[0] = Material::new("grey", glass);
    scene.lights.clear();
    scene.tracer = Tracer::Whitted(Whitted { max_depth: 3 });
    let radius = read(&scene).shapes[1].shape.parameters.number("radius");
    assert!(9.5 / (radius - 20.0) < 1.0 / 8_388_608.0, "{radius}");
}
