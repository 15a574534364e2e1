//! Mistakes of cameras.

use std::path::Path;

use groundtruth::cameras::{Fisheye, Kind, ThinLens};
use groundtruth::film::Film;
use groundtruth::materials::Emissive;
use groundtruth::math::{cos_degrees, sin_degrees};
use groundtruth::render;
use groundtruth::rgb::Rgb;
use groundtruth::scene::Scene;
use groundtruth::scene::build::*;
use groundtruth::world::{DEFAULT_SEED, World};
use judge::mistakes;

use super::stage::*;

const WIDTH: u32 = 32;

/// The camera's frame and the rays of the world with this mistake.
fn changed_world(name: &str, scene: &Scene) -> World {
    let mistake = mistakes::find(name).expect("it is known");
    let built = mistakes::built(mistake, scene, Path::new(""), DEFAULT_SEED);
    built.expect("it is valid").expect("it applies").1
}

/// Law: a camera that looks through the corners of pixels is one that stands half a pixel to the left and lower; of 16 samples in
/// cells of a quarter of the pixel, those at the corners are samples of one that stands an eighth of a pixel so. Oracle: that
/// camera, orthographic; edges may fall on a pixel's centre.
#[test]
fn corners_of_pixels_and_of_cells() {
    for (name, samples, part) in [("pixel-corner", 1, 0.5), ("sub-cell-corner", 16, 0.125)] {
        let mut scene = small("ch03/three-objects", WIDTH, 1);
        scene.image.samples = samples;
        let film = with(name, &scene);
        let world = World::build(&scene).expect("it is valid");
        let frame = world.view.frame();
        let shift = -part * scene.image.pixel_size * (frame.u + frame.v);
        scene.camera.eye = scene.camera.eye + shift;
        scene.camera.look_at = scene.camera.look_at + shift;
        assert!(share_of_differences(&film, &ours(&scene)) < 0.01, "{name}");
    }
}

/// Law: with both sides of the same field of view, a picture three times as wide as high shows a square, each column of
/// which is three columns wide. Oracle: the square picture.
#[test]
fn a_picture_without_its_aspect() {
    let mut scene = small("ch03/three-objects", 48, 1);
    scene.image.height = 16;
    let film = with("no-aspect", &scene);
    scene.image.resize(16, 16);
    let square = ours(&scene);
    let mut middle = Film::new(16, 16);
    for at @ [x, y] in (0..16).flat_map(|x| (0..16).map(move |y| [x, y])) {
        middle.set(at, film.get([3 * x + 1, y]));
    }
    assert!(share_of_differences(&middle, &square) < 0.01);
}

/// Law: a camera rolled to the other side has an up vector that is rolled back twice. Oracle: an up vector by hand.
#[test]
fn roll_to_the_other_side() {
    let mut scene = small("ch09/rolled", WIDTH, 1);
    let film = with("roll-reversed", &scene);
    let world = World::build(&scene).expect("it is valid");
    let frame = world.view.frame();
    let twice = 2.0 * scene.camera.roll;
    let (sin, cos) = (sin_degrees(twice), cos_degrees(twice));
    scene.camera.up = sin * frame.u + cos * frame.v;
    scene.camera.roll = 0.0;
    assert!(share_of_differences(&film, &ours(&scene)) < 0.05);
}

/// Law: exchanged eyes are exchanged images. Oracle: the columns of our picture.
#[test]
fn exchanged_eyes() {
    let scene = small("ch12/three-spheres", WIDTH, 1);
    let world = World::build(&scene).expect("it is valid");
    let right = render::render(&world);
    let wrong = with("eyes-exchanged", &scene);
    let [a, b] = render::eye_images(&world, &right).expect("it is a pair");
    let [c, d] = render::eye_images(&world, &wrong).expect("it is a pair");
    assert_eq!([bits(&a), bits(&b)], [bits(&d), bits(&c)]);
    assert_ne!(bits(&a), bits(&b));
}

/// Law: the rays of two points of the lens meet on the view plane, at distance `d`. Oracle: where they cross that plane.
#[test]
fn a_lens_that_is_not_focused() {
    let mut scene = plane(matte(0.0, 1.0, Rgb::WHITE), 30.0);
    scene.image.pixel_size = 1.0;
    let distance = 5.0;
    scene.camera.lens =
        Kind::from(ThinLens { distance, focal_distance: 40.0, lens_radius: 0.5, zoom: 1.0 });
    let world = changed_world("not-focused", &scene);
    let (eye, w) = (&world.view.eyes()[0], world.view.frame().w);
    let crossing = |lens: [f64; 2]| {
        let ray = eye.ray([0.25, -0.125], lens).expect("it sees something");
        ray.at(distance / -w.dot(ray.direction))
    };
    let gap = crossing([0.9, 0.1]).distance(crossing([-0.3, -0.7]));
    assert!(gap < 1e-12, "they miss each other by {gap}");
}

/// Law: the ray to the edge of a fisheye's picture is at a quarter of the field of view to its axis, not at half. Oracle:
/// the cosine of that angle.
#[test]
fn half_a_field_of_view() {
    let mut scene = plane(matte(0.0, 1.0, Rgb::WHITE), 30.0);
    scene.image.pixel_size = 2.0;
    scene.camera.lens = Kind::from(Fisheye { fov: 120.0, rectangular: false });
    let world = changed_world("half-field-of-view", &scene);
    let ray = world.view.eyes()[0].ray([1.0, 0.0], [0.0; 2]).expect("the edge is in the picture");
    let cosine = -world.view.frame().w.dot(ray.direction);
    assert!((cosine - cos_degrees(30.0)).abs() < ROUNDING);
}

/// Law: without its exposure time a picture has the radiance itself. Oracle: the lamp's radiance.
#[test]
fn no_exposure_time() {
    let mut scene = plane(Emissive::new(4.0, Rgb::WHITE), 20.0);
    scene.camera.exposure_time = 0.25;
    assert_eq!(value(&ours(&scene)), 1.0);
    expect("no-exposure-time", &scene, 4.0, 0.0);
}
