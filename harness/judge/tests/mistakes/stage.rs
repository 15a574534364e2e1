//! A plane seen from one direction: its picture is one pixel, whose value is known in closed form.

use std::path::Path;

use groundtruth::cameras::{Orthographic, Viewpoint};
use groundtruth::film::Film;
use groundtruth::math::{Point, Vector, cos_degrees, sin_degrees};
use groundtruth::render;
use groundtruth::scene::build::*;
use groundtruth::scene::{Image, Light, Scene};
use groundtruth::world::{DEFAULT_SEED, World};
use groundtruth::{lights, materials};
use judge::mistakes;

/// The unit vector at this angle to the y axis, towards +x for positive angles.
pub fn at_angle(degrees: f64) -> Vector {
    vector(sin_degrees(degrees), cos_degrees(degrees), 0.0)
}

/// The plane y = 0 of this material, facing up, seen from this angle at the origin.
pub fn plane(material: impl Into<materials::Kind>, angle: f64) -> Scene {
    let eye = Point::ORIGIN + 10.0 * at_angle(angle);
    let mut camera = Viewpoint::new(eye, Point::ORIGIN, Orthographic { zoom: 1.0 });
    camera.up = Vector::Z;
    let image = Image { pixel_size: 1e-6, ..Image::new(1, 1) };
    let mut scene = Scene::new("a plane", image, camera);
    add(&mut scene, "plane", ground(0.0), material);
    scene
}

/// The same with a light of this radiance, without shadows, from this angle.
pub fn lit_plane(material: impl Into<materials::Kind>, viewer: f64, light: f64) -> Scene {
    let mut scene = plane(material, viewer);
    scene.lights.push(directional("sun", at_angle(light), 1.0).without_shadows());
    scene
}

/// Adds a light.
pub fn light(scene: &mut Scene, source: impl Into<lights::Kind>) {
    scene.lights.push(Light::new("light", source));
}

/// Our picture.
pub fn ours(scene: &Scene) -> Film {
    render::render(&World::build(scene).expect("the scene is valid"))
}

/// The picture of a mistake, which must apply and change something.
pub fn with(name: &str, scene: &Scene) -> Film {
    let mistake = mistakes::find(name).unwrap_or_else(|| panic!("no mistake {name}"));
    let film = mistakes::replica(mistake, scene, Path::new(""), DEFAULT_SEED);
    film.expect("the scene is valid").unwrap_or_else(|| panic!("{name} changes nothing"))
}

/// The picture of another form of a mistake; ours if it changes nothing.
pub fn with_form(name: &str, form: &str, scene: &Scene) -> Film {
    let is_it = |it: &&mistakes::Mistake| it.name == name && it.form == Some(form);
    let mistake = mistakes::forms().into_iter().find(is_it);
    let mistake = mistake.unwrap_or_else(|| panic!("no form {form} of {name}"));
    let film = mistakes::replica(mistake, scene, Path::new(""), DEFAULT_SEED);
    film.expect("the scene is valid").unwrap_or_else(|| ours(scene))
}

/// As [`expect`], of another form of a mistake.
pub fn expect_form(name: &str, form: &str, scene: &Scene, expected: f64, tolerance: f64) {
    let found = value(&with_form(name, form, scene));
    let close = (found - expected).abs() <= tolerance * expected.abs();
    assert!(close, "{name}, {form}: found {found}, expected {expected}");
}

/// The value of the only pixel.
pub fn value(film: &Film) -> f64 {
    assert_eq!([film.width(), film.height()], [1, 1]);
    film.get([0, 0]).r
}

/// Fails unless the only pixel of the mistake's picture has this value, up to a relative error.
pub fn expect(name: &str, scene: &Scene, expected: f64, tolerance: f64) {
    let found = value(&with(name, scene));
    let close = (found - expected).abs() <= tolerance * expected.abs();
    assert!(close, "{name}: found {found}, expected {expected}");
}

/// Sums of a few roundings, relative.
pub const ROUNDING: f64 = 1e-12;

/// A scene of the gallery, in a small size with few samples.
pub fn small(name: &str, width: u32, samples: u32) -> Scene {
    let mut scene = (gallery::find(name).unwrap_or_else(|| panic!("no scene {name}")).build)();
    let height = (scene.image.height * width).div_ceil(scene.image.width).max(1);
    scene.image.resize(width, height);
    scene.image.samples = scene.image.samples.min(samples);
    scene
}

pub fn bits(film: &Film) -> Vec<[u64; 3]> {
    film.pixels().iter().map(|pixel| pixel.to_array().map(f64::to_bits)).collect()
}

/// The share of pixels in which two pictures differ by more than rounding.
pub fn share_of_differences(a: &Film, b: &Film) -> f64 {
    assert_eq!([a.width(), a.height()], [b.width(), b.height()]);
    let differs = |(a, b): (&_, &_)| {
        let (a, b): (groundtruth::rgb::Rgb, groundtruth::rgb::Rgb) = (*a, *b);
        let pairs = a.to_array().into_iter().zip(b.to_array());
        pairs.into_iter().any(|(a, b)| (a - b).abs() > 1e-9 * (a.abs() + b.abs()))
    };
    let count = a.pixels().iter().zip(b.pixels()).filter(|pair| differs(*pair)).count();
    count as f64 / a.pixels().len() as f64
}
