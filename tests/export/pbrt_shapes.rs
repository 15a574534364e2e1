//! pbrt-v4: shapes are where ours are, with their front, and planes are disks.

use groundtruth::lights::{Directional, Environment};
use groundtruth::materials::{Dielectric, Medium};
use groundtruth::math::{self, Point, Span, Step, Vector};
use groundtruth::render;
use groundtruth::rgb::Rgb;
use groundtruth::scene::{Depth, Light, Material, Object, Scene, Tracer, Whitted};
use groundtruth::shapes::{
    self, Annulus, Cuboid, Disk, Instance, Lattice, OpenCylinder, PartAnnulus, PartCylinder,
    PartSphere, Plane, Rectangle, Sphere, TessellatedSphere, Triangle,
};
use groundtruth::world::World;

use super::pbrt::{matte, pinhole};
use super::pbrt_parsed::{self as parsed, Statement, axes, moved, read};

/// A point of pbrt's shape at the parameters `(u, v)` of its parameterisation, and its normal `dp/du × dp/dv`, in its own
/// coordinates, by the formulas of its source (`shapes.h`). A parameter outside 0 to 1 is beyond its edge.
pub fn their_point(shape: &Statement, [u, v]: [f64; 2]) -> (Vector, Vector) {
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
pub fn in_world(shape: &parsed::Shape, (p, n): (Vector, Vector)) -> (Point, Vector) {
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
