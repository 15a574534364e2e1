//! Chapter 24: mirror reflection: the reflective set and the hall of mirrors.

use super::List;
use groundtruth::cameras::{Pinhole, Viewpoint};
use groundtruth::materials::Phong;
use groundtruth::math::{Point, Vector};
use groundtruth::rgb::Rgb;
use groundtruth::scene::build::*;
use groundtruth::scene::{Image, Material, Object, Scene, Tracer, Whitted};
use groundtruth::shapes::{Disk, OpenCylinder, Rectangle};
use groundtruth::textures::{Paint, PlaneChecker};

pub const SCENES: List = &[
    ("ch24/reflective-set-depth-0", || {
        reflective_set("as figure 24.6 at depth 0: direct light alone, mirrors are dark", 0)
    }),
    ("ch24/reflective-set-depth-1", || {
        reflective_set("as figure 24.6 at depth 1: mirrors in mirrors are dark", 1)
    }),
    ("ch24/reflective-set-depth-2", || {
        reflective_set("as figure 24.6 at depth 2: reflections of reflections", 2)
    }),
    ("ch24/reflective-set", || {
        let about = "figure 24.6: mirrors and matte objects, with up to ten reflections";
        reflective_set(about, 10)
    }),
    ("ch24/hall-of-mirrors-depth-2", || {
        let mut scene = hall_of_mirrors();
        scene.about = "as figure 24.17 at depth 2: the third mirror in a row is black".to_owned();
        scene.tracer = Tracer::Whitted(Whitted { max_depth: 2 });
        scene
    }),
    ("ch24/hall-of-mirrors", hall_of_mirrors),
    ("ch24/floor-mirror", || {
        let mut scene = hall_of_mirrors();
        scene.about = "figure 24.18b: the floor mirror of the hall in close-up".to_owned();
        scene.camera.look_at = point(0.0, -5.0, 0.0);
        scene.camera.lens = Pinhole { distance: 2000.0, zoom: 1.0 }.into();
        scene
    }),
];

/// Figure 24.6 at this depth.
fn reflective_set(about: &str, max_depth: u32) -> Scene {
    let lens = Pinhole { distance: 360.0, zoom: 1.0 };
    let camera = Viewpoint::new(point(75.0, 40.0, 100.0), point(-10.0, 39.0, 0.0), lens);
    let image = Image { samples: 16, ..Image::new(600, 400) };
    let mut scene = Scene::new(about, image, camera);
    scene.tracer = Tracer::Whitted(Whitted { max_depth });
    scene.background = grey(0.15).into();
    scene.lights.push(ambient(0.5));
    scene.lights.push(point_light("lamp", point(150.0, 150.0, 0.0), 3.0));

    let mut add = |(object, material): (Object, Material)| {
        scene.objects.push(object);
        scene.materials.push(material);
    };
    let yellow = mirror(phong(0.25, 0.5, rgb(0.75, 0.75, 0.0), 0.15, 100.0), 0.75, Rgb::WHITE);
    add(object("yellow mirror sphere", sphere(point(38.0, 23.0, -25.0), 23.0), yellow));
    let orange = matte(0.45, 0.75, rgb(0.75, 0.25, 0.0));
    add(object("orange sphere", sphere(point(-7.0, 10.0, 42.0), 20.0), orange));
    let black = mirror(phong(0.0, 0.0, Rgb::BLACK, 0.15, 100.0), 0.75, Rgb::WHITE);
    add(object("black mirror sphere", sphere(point(-30.0, 59.0, 35.0), 20.0), black));
    let wall = OpenCylinder { y0: 0.0, y1: 85.0, radius: 22.0, inward: false };
    let chrome = mirror(phong(0.2, 0.3, rgb(0.0, 0.5, 0.75), 0.2, 100.0), 0.5, Rgb::WHITE);
    add(object("mirror cylinder", wall, chrome));
    let slab = boxed(point(-35.0, 0.0, -110.0), point(-25.0, 60.0, 65.0));
    add(object("box", slab, matte(0.15, 0.5, rgb(0.75, 1.0, 0.75))));
    let checker = PlaneChecker {
        size: 20.0,
        color1: Rgb::WHITE.into(),
        color2: grey(0.75).into(),
        outline_width: 2.0,
        outline_color: Rgb::BLACK.into(),
    };
    add(object("ground", ground(0.0), matte(0.3, 0.9, Paint::from(checker))));
    for (name, y, normal) in
        [("cylinder top", 85.0, Vector::Y), ("cylinder bottom", 0.0, -Vector::Y)]
    {
        let disk = Disk { center: point(0.0, y, 0.0), normal, radius: 22.0 };
        scene.objects.push(Object::new(name, "mirror cylinder", disk));
    }
    scene
}

/// Figures 24.17 and 24.18: half the size of the room.
const ROOM: f64 = 11.0;
/// Half the size of the mirrors.
const MIRROR: f64 = 8.0;
/// The distance of a mirror from its wall.
const GAP: f64 = 1.0;

pub(super) fn hall_of_mirrors() -> Scene {
    let lens = Pinhole { distance: 300.0, zoom: 1.0 };
    let camera = Viewpoint::new(point(7.5, 3.0, 9.5), Point::ORIGIN, lens);
    let image = Image { samples: 16, ..Image::new(600, 400) };
    let about = "figure 24.17: a sphere in a room with mirrors on three walls and on the floor";
    let mut scene = Scene::new(about, image, camera);
    scene.tracer = Tracer::Whitted(Whitted { max_depth: 19 });
    scene.lights.push(ambient(1.0));
    let lamps = [(10.0, 0.0), (-10.0, 0.0), (0.0, 10.0), (0.0, -10.0)];
    for (i, (x, z)) in lamps.into_iter().enumerate() {
        let name = format!("lamp {}", i + 1);
        scene.lights.push(point_light(&name, point(x, 10.0, z), 2.0).without_shadows());
    }

    let mut add = |(object, material): (Object, Material)| {
        scene.objects.push(object);
        scene.materials.push(material);
    };
    let chrome = mirror(phong(0.0, 0.2, grey(0.5), 0.0, 1.0), 0.85, rgb(0.75, 0.75, 1.0));
    add(object("sphere", sphere(point(0.0, 0.5, 0.0), 4.0), chrome));

    let rectangle = |corner: Point, a: Vector, b: Vector| Rectangle { corner, a, b };
    let (x, y, z) = (2.0 * ROOM * Vector::X, 2.0 * ROOM * Vector::Y, 2.0 * ROOM * Vector::Z);
    let r = ROOM;
    let floor = rectangle(point(-r, -r, -r), z, x);
    add(object("floor", floor, matte(0.1, 0.5, grey(0.25))));
    let ceiling = rectangle(point(-r, r, -r), x, z);
    add(object("ceiling", ceiling, matte(0.35, 0.5, Rgb::WHITE)));
    let back = rectangle(point(-r, -r, -r), x, y);
    add(object("back wall", back, matte(0.15, 0.6, rgb(0.5, 0.75, 0.75))));
    let front = rectangle(point(r, -r, r), -x, y);
    add(object("front wall", front, matte(0.15, 0.6, rgb(0.5, 0.75, 0.75))));
    let left = rectangle(point(-r, -r, r), -z, y);
    add(object("left wall", left, matte(0.15, 0.6, rgb(0.71, 0.4, 0.2))));
    let right = rectangle(point(r, -r, -r), z, y);
    add(object("right wall", right, matte(0.15, 0.6, rgb(0.71, 0.4, 0.2))));

    let m = MIRROR;
    let d = ROOM - GAP;
    let (mx, my, mz) = (2.0 * m * Vector::X, 2.0 * m * Vector::Y, 2.0 * m * Vector::Z);
    let tinted = mirror(Phong::default(), 0.9, rgb(0.9, 1.0, 0.9));
    let yellowish = mirror(Phong::default(), 1.0, rgb(1.0, 1.0, 0.5));
    add(object("floor mirror", rectangle(point(-m, -4.0, -m), mz, mx), yellowish));
    add(object("back mirror", rectangle(point(-m, -m, -d), mx, my), tinted));
    for (name, corner, a) in
        [("front mirror", point(m, -m, d), -mx), ("left mirror", point(-d, -m, m), -mz)]
    {
        scene.objects.push(Object::new(name, "back mirror", rectangle(corner, a, my)));
    }
    scene
}
