//! Mitsuba, the fixtures of radiance, scaling and coordinates, and each factor of a convention.

use std::f64::consts::PI;

use groundtruth::lights::{Area, Directional, PointLight};
use groundtruth::materials::Emissive;
use groundtruth::math::{Normal, Point, Ray, Span, Step, Transform, Vector};
use groundtruth::scene::build::{add, point, rgb, sphere, vector};
use groundtruth::scene::{Light, Scene};
use groundtruth::shapes::{Cuboid, Disk, Instance, Kind, OpenCylinder, Rectangle};
use groundtruth::world::World;

use super::fixtures::{askew, narrow, near, near_all, ours, plane_below, unit};
use super::texts::{Parts, image, three, values};

/// Law: radiance: a matte plane of kd 0.8 under a directional light at 60° from its normal, at exposure 1/2. Oracle:
/// reflectance / π · irradiance · cosθ of what is written, kd · cd / π · ls · color · cosθ / 2 by hand, and our picture.
#[test]
fn a_matte_plane_has_its_radiance() {
    let (color, direction) = (rgb(1.0, 0.5, 0.25), vector(3.0_f64.sqrt(), 1.0, 0.0));
    let scene = plane_below(Light::new("sun", Directional { ls: PI, color, direction }));
    let parts = Parts::mitsuba(&scene);
    let light = parts.one("<emitter type=\"directional\"");
    let (reflectance, irradiance) =
        (values(parts.one("<bsdf"), "reflectance"), values(light, "irradiance"));
    let [x, y, z] = unit(three(values(light, "direction")));
    // the light goes down; the normal is up
    let theirs = [0, 1, 2].map(|i| reflectance[i] / PI * irradiance[i] * -y);
    near_all(&theirs, ours(&scene));
    near_all(&theirs, [0.9, 0.2, 0.025].map(|c| 0.8 * c * 0.5 * 0.5));
    near_all(&[-x, -y, -z], unit(direction.to_array()));
}

/// Law: scaling: the light of a lamp falls with the square of its distance. Oracle: reflectance / π · I / d² of what is
/// written, beside our picture.
#[test]
fn a_lamp_fades_with_the_square_of_its_distance() {
    let location = point(0.0, 2.0, 0.0);
    let lamp = PointLight { ls: 3.0, color: rgb(1.0, 0.5, 0.25), location, attenuation: 2.0 };
    let scene = plane_below(Light::new("lamp", lamp));
    let parts = Parts::mitsuba(&scene);
    let light = parts.one("<emitter type=\"point\"");
    near_all(&values(light, "position"), [0.0, 2.0, 0.0]);
    let (reflectance, intensity) =
        (values(parts.one("<bsdf"), "reflectance"), values(light, "intensity"));
    near_all(&[0, 1, 2].map(|i| reflectance[i] / PI * intensity[i] / 4.0), ours(&scene));
}

/// A lamp that is a rectangle 2 × 3, with its light.
fn lamp(steps: Vec<Step>) -> Scene {
    let mut scene =
        plane_below(Light::new("light", Area { object: "lamp".into(), sampling: None }));
    let (a, b) = (2.0 * Vector::X, 3.0 * Vector::Z);
    let shape = Rectangle { corner: point(0.0, 5.0, 0.0), a, b };
    let recipe = Emissive::new(4.0, rgb(1.0, 0.5, 0.25));
    add(&mut scene, "lamp", Instance::new(shape, steps), recipe);
    scene
}

/// Law: an area light has the radiance ls · ce, at the scene's exposure, on the side of our normal, which a reflection keeps.
/// Oracle: the normal of our built shape, hit by a ray.
#[test]
fn an_area_light_shines_on_its_front() {
    let mirrored = vec![Step::Scale(vector(-1.0, 1.0, 1.0)), Step::RotateZ(40.0)];
    for steps in [vec![], mirrored] {
        let scene = lamp(steps.clone());
        let parts = Parts::mitsuba(&scene);
        let lamp = *parts.all("<shape type=\"rectangle\"").last().expect("it is written last");
        near_all(&values(lamp, "radiance"), [2.0, 1.0, 0.5]);
        let map = values(lamp, "to_world");
        let [n, middle, corner] =
            [[0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0], [-1.0, -1.0, 0.0, 1.0]]
                .map(|it| image(&map, it));
        let (normal, middle) = (Vector::from(n), Point::from(middle));
        let world = World::build(&scene).expect("it is valid");
        let hit = world.hit(&Ray::new(middle + normal, -normal), Span::AHEAD);
        near_all(&hit.expect("it is there").surface.normal.to_array(), n);
        // the corner, by the image of the corner of the square from −1 to 1
        let back = Transform::from_steps(&steps).expect("it has an inverse").inverse();
        near_all(&back.point(Point::from(corner)).to_array(), [0.0, 5.0, 0.0]);
    }
}

/// The numbers of this name of the written shapes of an instance.
fn written(shape: impl Into<Kind>, steps: &[Step], name: &str) -> Vec<f64> {
    let parts = Parts::mitsuba(&askew(narrow(), Instance::new(shape.into(), steps.to_vec())));
    values(&parts.all("<shape").concat(), name)
}

/// Law: coordinates: a transformed object is where ours is. Oracle: our transform of points of the shape, beside their
/// matrix; of a similarity, the centre and a length.
#[test]
fn instances_are_where_ours_are() {
    let turned = [
        Step::Scale(vector(-2.0, 2.0, 2.0)),
        Step::RotateX(30.0),
        Step::Translate(vector(5.0, 6.0, 7.0)),
    ];
    let mut sheared = turned.to_vec();
    sheared.insert(1, Step::Shear([0.0, 0.5, 0.0, 0.0, 0.25, 0.0]));
    let [similar, general] =
        [&turned[..], &sheared].map(|it| Transform::from_steps(it).expect("valid"));
    let (center, normal) = (point(1.0, 2.0, 3.0), vector(0.0, 3.0, 4.0));
    let ball = sphere(center, 2.0);
    near_all(&written(ball.clone(), &turned, "center"), similar.point(center).to_array());
    near(written(ball.clone(), &turned, "radius")[0], 4.0);
    let at = |p: [f64; 3]| general.point(Point::from(p)).to_array();
    near_all(&written(ball.clone(), &sheared, "center"), center.to_array());
    near(written(ball.clone(), &sheared, "radius")[0], 2.0);
    let map = written(ball, &sheared, "to_world");
    for p in [[0.0, 0.0, 0.0], [1.0, 2.0, -3.0]] {
        near_all(&image(&map, [p[0], p[1], p[2], 1.0]), at(p));
    }
    let cube = Cuboid { min: point(0.0, 1.0, 2.0), max: point(2.0, 4.0, 8.0) };
    let map = written(cube, &sheared, "to_world");
    // x is turned round, because the map is a reflection: the same box
    near_all(&image(&map, [1.0, -1.0, -1.0, 1.0]), at([0.0, 1.0, 2.0]));
    near_all(&image(&map, [-1.0, 1.0, 1.0, 1.0]), at([2.0, 4.0, 8.0]));
    let columns = [0, 1, 2].map(|j| vector(map[j], map[4 + j], map[8 + j]));
    assert!(columns[0].cross(columns[1]).dot(columns[2]) > 0.0, "triangles keep their side");
    let wall = OpenCylinder { y0: -1.0, y1: 3.0, radius: 2.0, inward: false };
    for (name, y) in [("p0", -1.0), ("p1", 3.0)] {
        let end = point(0.0, y, 0.0);
        near_all(&written(wall.clone(), &turned, name), similar.point(end).to_array());
        near_all(&written(wall.clone(), &sheared, name), end.to_array());
    }
    near(written(wall.clone(), &turned, "radius")[0], 4.0);
    near(written(wall.clone(), &sheared, "radius")[0], 2.0);
    let map = written(wall, &sheared, "to_world");
    near_all(&image(&map, [2.0, 3.0, 0.0, 1.0]), at([2.0, 3.0, 0.0]));
    let disk = Disk { center, normal, radius: 2.0 };
    let map = written(disk, &sheared, "to_world");
    near_all(&image(&map, [0.0, 0.0, 0.0, 1.0]), at(center.to_array()));
    // the images of its rim are on our disk: two units from its centre, across its normal
    for [x, y] in [[1.0, 0.0], [0.6, 0.8], [0.0, -1.0]] {
        let rim = Point::from(image(&map, [x, y, 0.0, 1.0]));
        let back = general.inverse().point(rim) - center;
        near(back.length(), 2.0);
        near(back.dot(normal), 0.0);
    }
    let front = general.covector(Normal::new(normal).expect("not zero"));
    near_all(&unit(image(&map, [0.0, 0.0, 1.0, 0.0])), unit(front.to_array()));
}
