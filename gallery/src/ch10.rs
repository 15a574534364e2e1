//! Chapter 10: depth of field.

use super::List;
use super::sets::{LENS, add_checkered_box, boxes_in_depth, daylight};
use groundtruth::cameras::{ThinLens, Viewpoint};
use groundtruth::materials::Reflective;
use groundtruth::math::Point;
use groundtruth::rgb::Rgb;
use groundtruth::samplers::Regular;
use groundtruth::scene::build::*;
use groundtruth::scene::{Image, Scene, Tracer, Whitted};

pub const SCENES: List = &[
    ("ch10/near-focus", || boxes("figure 10.9b: the near box in focus", 50.0, 1.0)),
    ("ch10/middle-focus", || boxes("figure 10.9a: the middle box in focus", 74.0, 1.0)),
    ("ch10/far-focus", || boxes("figure 10.10: the far box in focus", 98.0, 1.0)),
    ("ch10/focus-at-infinity", || {
        boxes("figure 10.11: a small lens focused far behind all objects", 1e5, 0.25)
    }),
    ("ch10/mirror", mirror),
    ("ch10/regular-lens", || {
        let mut scene = boxes("figure 10.13: regular lens samples give visible copies", 50.0, 1.0);
        scene.image.sampler = Some(Regular {}.into());
        scene
    }),
];

fn camera(eye: Point, look_at: Point, focal_distance: f64, lens_radius: f64) -> Viewpoint {
    Viewpoint::new(eye, look_at, ThinLens { focal_distance, lens_radius, ..LENS })
}

/// Figures 10.9 to 10.11.
fn boxes(about: &str, focal_distance: f64, lens_radius: f64) -> Scene {
    let (eye, look_at) = (point(0.0, 6.0, 50.0), point(0.0, 6.0, 0.0));
    let view = camera(eye, look_at, focal_distance, lens_radius);
    let image = Image { pixel_size: 0.05, samples: 100, ..Image::new(400, 300) };
    let mut scene = Scene::new(about, image, view);
    boxes_in_depth(&mut scene);
    scene
}

/// Figure 10.12: a mirror block that reflects a box behind the camera. The path from the lens over
/// the mirror to the box has the length of the focal distance: the reflected box is sharp, the
/// edges of the mirror and the box beside it are not.
fn mirror() -> Scene {
    let view = camera(point(15.0, 25.0, 50.0), point(0.0, 8.0, 0.0), 100.0, 1.0);
    let image = Image { pixel_size: 0.05, samples: 100, ..Image::new(400, 300) };
    let about = "figure 10.12: a mirror block out of focus, its reflection in focus";
    let mut scene = Scene::new(about, image, view);
    daylight(&mut scene);
    scene.tracer = Tracer::Whitted(Whitted { max_depth: 2 });
    let silver = phong(0.0, 0.0, Rgb::BLACK, 0.0, 1.0);
    let recipe = Reflective { phong: silver, kr: 0.9.into(), cr: Rgb::WHITE.into() };
    let block = boxed(point(-8.0, 0.0, -2.0), point(9.0, 17.0, 0.0));
    add(&mut scene, "mirror block", block, recipe);
    let corners = [point(-16.0, 0.0, 44.0), point(-9.0, 10.0, 46.0)];
    add_checkered_box(&mut scene, "mirrored box", corners, rgb(1.0, 1.0, 0.33));
    let corners = [point(-15.0, 0.0, -1.0), point(-9.5, 12.0, 0.0)];
    add_checkered_box(&mut scene, "box beside", corners, rgb(1.0, 0.6, 0.15));
    scene
}
