//! Mistakes of cameras.

use groundtruth::film::Film;
use groundtruth::world::World;

use super::stage::*;

/// Law: a camera that looks through the corners of pixels is one that stands half a pixel to the left and lower; of 16 samples in
/// cells of a quarter of the pixel, those at the corners are samples of one that stands an eighth of a pixel so. Oracle: that
/// camera, orthographic; edges may fall on a pixel's centre.
#[test]
fn corners_of_pixels_and_of_cells() {
    for (name, samples, part) in [("pixel-corner", 1, 0.5), ("sub-cell-corner", 16, 0.125)] {
        let mut scene = small("ch03/three-objects", 32, 1);
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
