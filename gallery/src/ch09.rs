//! Chapter 9: a practical viewing system.

use super::List;
use super::sets::{Canyon, basic_objects, canyon};
use groundtruth::cameras::{Pinhole, Viewpoint};
use groundtruth::math::{Point, Vector};
use groundtruth::rgb::Rgb;
use groundtruth::scene::build::*;
use groundtruth::scene::{Image, Scene};

pub const SCENES: List = &[
    ("ch09/from-above", from_above),
    ("ch09/canyon", rows_of_boxes),
    ("ch09/tilted-up", || {
        let eye = point(0.0, 0.0, 500.0);
        let about = "figure 9.11a: the up vector (1, 1, 0) rotates the picture by 45°";
        turned(about, camera(eye, Point::ORIGIN, 500.0, vector(1.0, 1.0, 0.0)))
    }),
    ("ch09/from-the-side", || {
        let eye = point(500.0, 0.0, 0.0);
        let about = "figure 9.11b: from the x axis, with the up vector (0, 1, −1)";
        turned(about, camera(eye, Point::ORIGIN, 400.0, vector(0.0, 1.0, -1.0)))
    }),
    ("ch09/rolled", || {
        let (eye, look_at) = (point(300.0, 400.0, 500.0), point(-20.0, -30.0, -50.0));
        let rolled = Viewpoint { roll: 145.0, ..camera(eye, look_at, 400.0, Vector::Y) };
        turned("figure 9.11c: rolled by 145°", rolled)
    }),
];

fn camera(eye: Point, look_at: Point, distance: f64, up: Vector) -> Viewpoint {
    Viewpoint { up, ..Viewpoint::new(eye, look_at, Pinhole { distance, zoom: 1.0 }) }
}

/// Figure 9.9.
fn from_above() -> Scene {
    let eye = point(-1000.0, 2000.0, -500.0);
    let image = Image { samples: 16, ..Image::new(400, 400) };
    let about = "figure 9.9: the objects of chapter 8 on a checkered plane, from far above";
    let view = camera(eye, point(0.0, -100.0, 0.0), 250.0, Vector::Y);
    let mut scene = Scene::new(about, image, view);
    basic_objects(&mut scene);
    let squares = checker3d(100.0, grey(0.5), Rgb::WHITE);
    add(&mut scene, "plane", ground(-101.0), matte(0.25, 0.35, squares));
    scene
}

/// Figure 9.10.
fn rows_of_boxes() -> Scene {
    let image = Image { samples: 16, ..Image::new(600, 400) };
    let about = "figure 9.10: along four rows of boxes, which meet at the vanishing point";
    let view = camera(point(-250.0, 350.0, 500.0), point(-250.0, 350.0, 0.0), 280.0, Vector::Y);
    let mut scene = Scene::new(about, image, view);
    canyon(&mut scene, &Canyon { right: 0.0, tallest: 600.0 });
    scene
}

/// Figures 9.11: one sample per pixel.
fn turned(about: &str, camera: Viewpoint) -> Scene {
    let mut scene = Scene::new(about, Image::new(300, 300), camera);
    basic_objects(&mut scene);
    scene
}
