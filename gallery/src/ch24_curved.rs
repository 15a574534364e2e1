//! Chapter 24: mirror reflection: spheres, a cone and a cylinder.

use super::List;
use groundtruth::cameras::{Orthographic, Stereo, Viewing, Viewpoint};
use groundtruth::materials::{Emissive, Phong, Reflective};
use groundtruth::math::{Point, Step, Vector};
use groundtruth::rgb::Rgb;
use groundtruth::scene::build::*;
use groundtruth::scene::{Image, Scene, Tracer, Whitted};
use groundtruth::shapes::{
    BeveledBox, Cone, Disk, Materials, OpenCylinder, Sphere, TessellatedSphere,
};
use groundtruth::textures::{Paint, PlaneChecker};

pub const SCENES: List = &[
    ("ch24/seven-spheres", seven_spheres),
    ("ch24/stereo", stereo),
    ("ch24/four-spheres", || {
        let about = "figure 24.20a: four mirror spheres in contact; three lamps shine between them";
        four_spheres(about, [point(0.0, 3.7, -9.4), point(0.0, 0.35, 0.0)], 1000.0)
    }),
    ("ch24/inside-four-spheres", || {
        let about = "figure 24.20b: the view upward from between four mirror spheres";
        four_spheres(about, [point(0.0, 0.05, 0.0), point(0.0, 1.0, 0.0)], 300.0)
    }),
    ("ch24/gold-box", gold_box),
    ("ch24/mirror-meshes", mirror_meshes),
    ("ch24/mirror-cone", mirror_cone),
    ("ch24/mirror-cylinder", mirror_cylinder),
    ("ch24/three-spheres", three_spheres),
    ("ch24/sphere-over-checker", sphere_over_checker),
];

/// An empty scene with the Whitted tracer of this depth.
fn mirrored(about: &str, size: [u32; 2], view: [Point; 2], distance: f64, depth: u32) -> Scene {
    let mut scene = pinhole(about, size, view, distance);
    scene.tracer = Tracer::Whitted(Whitted { max_depth: depth });
    scene
}

/// A mirror of this colour and nothing else.
fn pure(kr: f64, cr: Rgb) -> Reflective {
    mirror(Phong::default(), kr, cr)
}

/// A checker in the xz plane with lines between the squares.
fn squares(size: f64, color1: Rgb, color2: Rgb) -> Paint {
    let outline_width = 0.1 * size;
    let outline_color = Rgb::BLACK;
    Paint::from(PlaneChecker {
        size,
        color1: color1.into(),
        color2: color2.into(),
        outline_width,
        outline_color: outline_color.into(),
    })
}

/// The spheres are the book's; the view, the sky and the ground are ours (the book has an
/// environment map of a hall).
fn seven_spheres() -> Scene {
    let about = "figure 24.10 under a plain sky: six mirror spheres that touch a seventh";
    let view = [point(0.0, 300.0, 2000.0), Point::ORIGIN];
    let mut scene = mirrored(about, [400, 400], view, 1150.0, 10);
    scene.background = rgb(0.75, 0.85, 1.0).into();
    scene.lights.push(ambient(1.0));
    let turn = [Step::RotateX(40.0), Step::RotateZ(-40.0)];
    let spheres = [
        ("centre", Vector::ZERO, rgb(0.65, 0.75, 1.0)),
        ("+x", Vector::X, rgb(0.5, 1.0, 0.5)),
        ("-x", -Vector::X, rgb(0.4, 1.0, 1.0)),
        ("+y", Vector::Y, rgb(1.0, 1.0, 0.4)),
        ("-y", -Vector::Y, rgb(1.0, 0.5, 1.0)),
        ("+z", Vector::Z, rgb(1.0, 0.75, 0.25)),
        ("-z", -Vector::Z, rgb(0.5, 0.5, 1.0)),
    ];
    for (name, direction, color) in spheres {
        let ball = sphere(Point::ORIGIN + 200.0 * direction, 100.0);
        add(&mut scene, name, transformed(ball, turn.to_vec()), pure(0.9, color));
    }
    let floor = matte(0.8, 0.0, squares(150.0, Rgb::WHITE, grey(0.4)));
    add(&mut scene, "ground", ground(-320.0), floor);
    scene
}

/// The spheres and the eyes are the book's; the colours and the view are ours.
fn stereo() -> Scene {
    let about = "figure 24.16: a mirror sphere in an emissive checkered sphere, for two eyes";
    let view = [point(0.0, 6.0, 20.0), Point::ORIGIN];
    let mut scene = mirrored(about, [300, 300], view, 700.0, 1);
    scene.camera.stereo = Some(Stereo { viewing: Viewing::Parallel, gap: 5, separation: 1.5 });
    add(&mut scene, "mirror sphere", sphere(Point::ORIGIN, 3.0), pure(0.9, Rgb::WHITE));
    let checks = checker3d(8.0, rgb(1.0, 0.9, 0.6), rgb(0.15, 0.3, 0.5));
    let around = Sphere { inward: true, ..sphere(Point::ORIGIN, 30.0) };
    add(&mut scene, "surroundings", around, Emissive::new(1.0, checks));
    scene
}

/// The spheres are the book's; the lamps in front of three of the four openings between them are
/// ours.
fn four_spheres(about: &str, view: [Point; 2], distance: f64) -> Scene {
    let mut scene = mirrored(about, [400, 400], view, distance, 12);
    scene.camera.up = Vector::Z;
    scene.background = grey(0.8).into();
    let centers = [(0.0, 1.414, 0.0), (0.0, 0.0, 1.0), (0.866, 0.0, -0.5), (-0.866, 0.0, -0.5)];
    for (i, (x, y, z)) in (1..).zip(centers) {
        let ball = sphere(point(x, y, z), 0.866);
        add(&mut scene, &format!("sphere {i}"), ball, pure(1.0, Rgb::WHITE));
    }
    for (name, direction, color) in [
        ("red lamp", vector(0.8165, 0.3333, 0.4714), rgb(1.0, 0.15, 0.1)),
        ("green lamp", vector(-0.8165, 0.3333, 0.4714), rgb(0.2, 0.8, 0.2)),
        ("blue lamp", vector(0.0, -1.0, 0.0), rgb(0.15, 0.3, 1.0)),
    ] {
        let center = point(0.0, 0.35, 0.0) + 6.0 * direction;
        let disk = Disk { center, normal: -direction, radius: 5.0 };
        add(&mut scene, name, disk, Emissive::new(1.0, color));
    }
    scene
}

/// The gold is the book's; the sizes and the surroundings are ours.
fn gold_box() -> Scene {
    let about =
        "as figure 24.29c under a plain sky: a golden box whose round edges reflect all directions";
    let view = [point(5.0, 5.0, 9.0), point(0.0, 0.9, 0.0)];
    let mut scene = mirrored(about, [400, 400], view, 1000.0, 5);
    scene.background = rgb(0.75, 0.85, 1.0).into();
    scene.lights.push(ambient(1.0));
    let (min, max) = (point(-1.5, 0.0, -1.0), point(1.5, 2.0, 1.0));
    let shape = BeveledBox { min, max, bevel: 0.3, materials: Materials::new() };
    add(&mut scene, "box", shape, pure(0.9, rgb(1.0, 0.75, 0.25)));
    let floor = matte(0.8, 0.0, squares(1.0, Rgb::WHITE, grey(0.4)));
    add(&mut scene, "ground", ground(0.0), floor);
    scene
}

/// The numbers are ours.
fn mirror_meshes() -> Scene {
    let about =
        "as figure 24.30: a mirror sphere of flat triangles, of smooth ones, and an exact sphere";
    let view = [point(0.0, 3.0, 12.0), point(0.0, 1.0, 0.0)];
    let mut scene = mirrored(about, [600, 250], view, 950.0, 5);
    scene.background = rgb(0.75, 0.85, 1.0).into();
    scene.lights.push(ambient(1.0));
    for (name, smooth, x) in [("flat mesh", false, -2.3), ("smooth mesh", true, 0.0)] {
        let mesh = TessellatedSphere::new(24, 12, smooth);
        let mesh = moved(mesh, vector(x, 1.0, 0.0));
        add(&mut scene, name, mesh, pure(0.9, Rgb::WHITE));
    }
    add(&mut scene, "sphere", sphere(point(2.3, 1.0, 0.0), 1.0), pure(0.9, Rgb::WHITE));
    let floor = matte(0.8, 0.0, squares(1.0, Rgb::WHITE, rgb(0.3, 0.5, 0.3)));
    add(&mut scene, "ground", ground(0.0), floor);
    scene
}

/// The numbers are ours.
fn mirror_cone() -> Scene {
    let about = "as figure 24.36: a mirror cone from above reflects the ground inside out";
    let view = [point(0.0, 10.0, 0.0), Point::ORIGIN];
    let mut scene = mirrored(about, [400, 400], view, 700.0, 2);
    scene.camera.up = -Vector::Z;
    scene.lights.push(ambient(1.0));
    let cone = Cone { height: 2.0, radius: 1.5, inward: false };
    add(&mut scene, "cone", cone, pure(0.9, Rgb::WHITE));
    let floor = matte(0.9, 0.0, squares(1.0, rgb(1.0, 0.9, 0.6), rgb(0.2, 0.4, 0.6)));
    add(&mut scene, "ground", ground(0.0), floor);
    scene
}

/// Radius and lamp are the book's; the rest of the numbers is ours.
fn mirror_cylinder() -> Scene {
    let about = "as figure 24.39: a lamp in a mirror cylinder, from its axis: a pair of arcs per reflection";
    let view = [point(0.0, 60.0, 0.0), Point::ORIGIN];
    let mut scene = mirrored(about, [400, 400], view, 220.0, 10);
    scene.camera.up = -Vector::Z;
    let wall = OpenCylinder { y0: 0.0, y1: 60.0, radius: 10.0, inward: true };
    add(&mut scene, "wall", wall, pure(0.9, Rgb::WHITE));
    let lamp = sphere(point(2.0, 3.0, 0.0), 1.5);
    add(&mut scene, "lamp", lamp, Emissive::new(0.85, rgb(1.0, 1.0, 0.5)));
    scene
}

/// The pixels are the book's; the colours and the light are ours.
fn three_spheres() -> Scene {
    let about = "figure 24.40: three mirror spheres in contact, with an orthographic camera";
    let camera = Viewpoint::new(point(0.0, 0.0, 100.0), Point::ORIGIN, Orthographic { zoom: 1.0 });
    let image = Image { samples: 16, pixel_size: 0.0073, ..Image::new(600, 600) };
    let mut scene = Scene::new(about, image, camera);
    scene.tracer = Tracer::Whitted(Whitted { max_depth: 10 });
    scene.background = Rgb::WHITE.into();
    let height = 3.0_f64.sqrt();
    for (name, x, y, color) in [
        ("red sphere", -1.0, -height / 3.0, rgb(1.0, 0.6, 0.6)),
        ("green sphere", 1.0, -height / 3.0, rgb(0.6, 1.0, 0.6)),
        ("blue sphere", 0.0, 2.0 * height / 3.0, rgb(0.6, 0.6, 1.0)),
    ] {
        add(&mut scene, name, sphere(point(x, y, 0.0), 1.0), pure(0.9, color));
    }
    scene
}

/// The squares are the book's; the rest of the numbers is ours.
fn sphere_over_checker() -> Scene {
    let about = "figure 24.41: a mirror sphere reflects a whole checkered plane and the sky";
    let view = [point(0.0, 4.0, 20.0), point(0.0, 2.8, 0.0)];
    let mut scene = mirrored(about, [400, 400], view, 1100.0, 2);
    scene.background = rgb(0.6, 0.75, 0.95).into();
    scene.lights.push(ambient(1.0));
    add(&mut scene, "sphere", sphere(point(0.0, 3.0, 0.0), 2.5), pure(0.9, Rgb::WHITE));
    let floor = matte(0.9, 0.0, squares(2.0, Rgb::WHITE, rgb(0.5, 0.2, 0.1)));
    add(&mut scene, "ground", ground(0.0), floor);
    scene
}
