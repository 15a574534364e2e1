//! Chapter 6: mapping samples to a disk, which chapter 10 uses for the lens.

use super::List;
use super::sets::city;
use groundtruth::cameras::{ThinLens, Viewpoint};
use groundtruth::scene::build::*;
use groundtruth::scene::{Image, Scene};

pub const SCENES: List = &[("ch06/city", opener)];

/// The picture that opens the chapter.
fn opener() -> Scene {
    let lens = ThinLens { distance: 390.0, focal_distance: 135.0, lens_radius: 5.0, zoom: 1.0 };
    let camera = Viewpoint::new(point(100.0, 100.0, 50.0), point(0.0, -10.0, 0.0), lens);
    let image = Image { samples: 100, ..Image::new(600, 400) };
    let about = "the chapter's opening picture: a city through a wide lens looks like a model";
    let mut scene = Scene::new(about, image, camera);
    scene.background = rgb(0.6, 0.75, 0.95).into();
    city(&mut scene, ambient(0.5));
    scene
}
