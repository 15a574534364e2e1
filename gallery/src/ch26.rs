//! Chapter 26: global illumination.

use super::List;
use super::ch18::{Part, plain, solids};
use groundtruth::cameras::{Pinhole, Viewpoint};
use groundtruth::lights::Area;
use groundtruth::materials::{Emissive, Phong};
use groundtruth::math::{Point, Vector};
use groundtruth::rgb::Rgb;
use groundtruth::scene::build::*;
use groundtruth::scene::{Depth, Image, Light, Material, Object, Scene, Tracer};
use groundtruth::shapes::{Kind, PartCylinder, Rectangle};

pub const SCENES: List = &[
    ("ch26/dome-direct", || {
        let about = "as figure 26.5: solids under an emissive dome, direct light only";
        under_a_dome(about, Tracer::RayCast)
    }),
    ("ch26/dome-depth-1", || {
        let about =
            "as figure 26.5 by path_trace of depth 1: the same light without light sampling";
        under_a_dome(about, Tracer::PathTrace(Depth { max_depth: 1 }))
    }),
    ("ch26/dome", || {
        let about = "as figure 26.6: light reflected between the solids makes shadows brighter and coloured";
        under_a_dome(about, Tracer::PathTrace(Depth { max_depth: 5 }))
    }),
    ("ch26/cornell-box-one-sample", || {
        let about = "as figure 26.7a: path_trace with one path per pixel; few hit the lamp";
        let mut scene = cornell_box(about, Tracer::PathTrace(DEPTH));
        scene.image.samples = 1;
        scene
    }),
    ("ch26/cornell-box-path-trace", || {
        let about = "figure 26.10a: path_trace with 100 paths per pixel is still noisy";
        cornell_box(about, Tracer::PathTrace(DEPTH))
    }),
    ("ch26/cornell-box-direct", || {
        let about = "figure 26.10b: direct light only: a black ceiling and black shadows";
        cornell_box(about, Tracer::RayCast)
    }),
    ("ch26/mirror-caustic", mirror_caustic),
    ("ch26/half-cylinder-caustic", half_cylinder_caustic),
    ("ch26/cornell-box-global-trace", || {
        let about = "figure 26.12a: global_trace, direct light sampled at the first hit";
        cornell_box(about, Tracer::GlobalTrace(DEPTH))
    }),
    ("ch26/cornell-box", || {
        let about =
            "figure 26.12: the Cornell box, with colour bleeding from the red and green walls";
        cornell_box(about, Tracer::Path(DEPTH))
    }),
];

/// The depth of the Cornell box's paths.
const DEPTH: Depth = Depth { max_depth: 10 };

/// Colours and the dome's radiance are the book's, solids and view those of figure 18.7.
fn under_a_dome(about: &str, tracer: Tracer) -> Scene {
    let mut scene = solids(about, Rgb::WHITE, &[Part::Sky], plain);
    scene.tracer = tracer;
    scene.image.samples = 100;
    scene.background = grey(1.5).into();
    for (name, kd, cd) in [
        ("large sphere", 0.6, Rgb::WHITE),
        ("small sphere", 0.85, Rgb::WHITE),
        ("middle sphere", 0.6, rgb(0.73, 0.22, 0.0)),
        ("cylinder", 0.6, Rgb::WHITE),
        ("box", 0.95, Rgb::WHITE),
        ("ground", 0.95, rgb(0.37, 0.43, 0.08)),
    ] {
        let material = scene.materials.iter_mut().find(|material| material.name == name);
        material.expect("one of the solids").recipe = matte(0.0, kd, cd).into();
    }
    scene
}

/// The lamp and the mirror's colour are the book's; the rest of the numbers is ours.
fn mirror_caustic() -> Scene {
    let about = "as figure 26.8: a mirror reflects the light of a sphere to the ground: a caustic";
    let view = [point(9.0, 10.0, 16.0), point(-1.5, 2.5, 2.5)];
    let mut scene = pinhole(about, [400, 400], view, 680.0);
    scene.image.samples = 256;
    scene.tracer = Tracer::Path(Depth { max_depth: 5 });
    add_lamp(&mut scene, sphere(point(-2.0, 7.0, 6.0), 1.0), 20.0, rgb(0.75, 1.0, 0.75));
    let shape = Rectangle { corner: point(-4.0, 0.0, 0.0), a: 4.0 * Vector::X, b: 3.0 * Vector::Y };
    add(&mut scene, "mirror", shape, mirror(Phong::default(), 0.95, rgb(1.0, 0.5, 0.25)));
    add(&mut scene, "ground", ground(0.0), matte(0.0, 0.95, Rgb::WHITE));
    scene
}

/// The cylinder and the lamp's radiance are the book's; the rest of the numbers is ours.
fn half_cylinder_caustic() -> Scene {
    let about = "figure 26.9: the caustic of a half cylinder with a mirror inside: a cardioid";
    let view = [point(0.0, 16.0, 1.0), point(0.0, -1.0, 0.2)];
    let mut scene = pinhole(about, [400, 400], view, 750.0);
    scene.image.samples = 256;
    scene.tracer = Tracer::Path(Depth { max_depth: 5 });
    add_lamp(&mut scene, sphere(point(0.0, 3.0, 3.0), 0.5), 30.0, Rgb::WHITE);
    let wall = PartCylinder { y0: -1.0, y1: 3.0, radius: 3.0, phi: [90.0, 270.0], inward: true };
    add(&mut scene, "half cylinder", wall, mirror(Phong::default(), 0.95, rgb(1.0, 0.75, 0.5)));
    add(&mut scene, "ground", ground(-1.0), matte(0.0, 0.9, Rgb::WHITE));
    scene
}

/// Adds an emissive shape and its light.
fn add_lamp(scene: &mut Scene, shape: impl Into<Kind>, ls: f64, color: Rgb) {
    scene.lights.push(Light::new("lamp", Area { object: "lamp".to_owned(), sampling: None }));
    add(scene, "lamp", shape, Emissive::new(ls, color));
}

/// The box of figures 26.7 to 26.12, in units of 10 cm: rectangles as a corner and two sides.
const WHITE: [([f64; 3], [f64; 3], [f64; 3]); 13] = [
    // back wall, floor, ceiling
    ([0.0, 0.0, 55.92], [0.0, 54.88, 0.0], [55.28, 0.0, 0.0]),
    ([0.0, 0.0, 0.0], [0.0, 0.0, 55.92], [55.28, 0.0, 0.0]),
    ([0.0, 54.88, 0.0], [55.28, 0.0, 0.0], [0.0, 0.0, 55.92]),
    // short block: top and sides
    ([13.0, 16.5, 6.5], [-4.8, 0.0, 16.0], [16.0, 0.0, 4.9]),
    ([13.0, 0.0, 6.5], [-4.8, 0.0, 16.0], [0.0, 16.5, 0.0]),
    ([8.2, 0.0, 22.5], [15.8, 0.0, 4.7], [0.0, 16.5, 0.0]),
    ([24.2, 0.0, 27.4], [4.8, 0.0, -16.0], [0.0, 16.5, 0.0]),
    ([29.0, 0.0, 11.4], [-16.0, 0.0, -4.9], [0.0, 16.5, 0.0]),
    // tall block
    ([42.3, 33.0, 24.7], [-15.8, 0.0, 4.9], [4.9, 0.0, 15.9]),
    ([42.3, 0.0, 24.7], [-15.8, 0.0, 4.9], [0.0, 33.0, 0.0]),
    ([26.5, 0.0, 29.6], [4.9, 0.0, 15.9], [0.0, 33.0, 0.0]),
    ([31.4, 0.0, 45.5], [15.8, 0.0, -4.9], [0.0, 33.0, 0.0]),
    ([47.2, 0.0, 40.6], [-4.9, 0.0, -15.9], [0.0, 33.0, 0.0]),
];

/// The published sides are not exactly perpendicular: the second side is made perpendicular to the
/// first.
fn rectangle(corner: [f64; 3], a: [f64; 3], b: [f64; 3]) -> Rectangle {
    let (a, b) = (Vector::from(a), Vector::from(b));
    let b = b - (a.dot(b) / a.length_squared()) * a;
    Rectangle { corner: Point::from(corner), a, b }
}

fn cornell_box(about: &str, tracer: Tracer) -> Scene {
    let lens = Pinhole { distance: 400.0, zoom: 1.0 };
    let camera = Viewpoint::new(point(27.6, 27.4, -80.0), point(27.6, 27.4, 0.0), lens);
    let image = Image { samples: 100, ..Image::new(300, 300) };
    let mut scene = Scene::new(about, image, camera);
    scene.tracer = tracer;
    let lamp = rectangle([21.3, 54.879, 22.7], [0.0, 0.0, 10.5], [13.0, 0.0, 0.0]);
    // its normal points down
    let lamp = Rectangle { corner: lamp.corner + lamp.b, b: -lamp.b, ..lamp };
    add_lamp(&mut scene, lamp, 100.0, rgb(1.0, 0.73, 0.4));
    let left = rectangle([55.28, 0.0, 0.0], [0.0, 0.0, 55.92], [0.0, 54.88, 0.0]);
    add(&mut scene, "left wall", left, matte(0.0, 0.6, rgb(0.57, 0.025, 0.025)));
    let right = rectangle([0.0, 0.0, 0.0], [0.0, 54.88, 0.0], [0.0, 0.0, 55.92]);
    add(&mut scene, "right wall", right, matte(0.0, 0.6, rgb(0.37, 0.59, 0.2)));
    let mut white = Material::new("white", matte(0.0, 0.6, Rgb::WHITE));
    white.two_sided = true;
    scene.materials.push(white);
    let names = ["back wall", "floor", "ceiling"].map(str::to_owned);
    let blocks = ["short", "tall"]
        .into_iter()
        .flat_map(|block| (1..6).map(move |i| format!("{block} block {i}")));
    for (name, (corner, a, b)) in names.into_iter().chain(blocks).zip(WHITE) {
        scene.objects.push(Object::new(&name, "white", rectangle(corner, a, b)));
    }
    scene
        .materials
        .iter_mut()
        .filter(|m| m.name.ends_with("wall"))
        .for_each(|m| m.two_sided = true);
    scene
}
