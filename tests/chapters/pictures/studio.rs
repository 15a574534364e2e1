//! Shared by the laws on pictures: small scenes, and the comparison of pictures bit for bit.

use crate::prelude::*;
pub use crate::support::stage::built;

pub const RED: Rgb = Rgb::new(1.0, 0.0, 0.0);

/// An empty scene, seen from z = 100 by parallel rays along −z.
pub fn from_front(width: u32, height: u32, pixel_size: f64) -> Scene {
    let lens = Orthographic { zoom: 1.0 };
    let camera = Viewpoint::new(Point::new(0.0, 0.0, 100.0), Point::ORIGIN, lens);
    Scene::new("", Image { pixel_size, ..Image::new(width, height) }, camera)
}

/// Adds an object that emits one colour on both sides, as in chapter 3.
pub fn add_flat(scene: &mut Scene, name: &str, shape: impl Into<shapes::Kind>, color: Rgb) {
    let mut material = Material::new(name, Emissive::new(1.0, color));
    material.two_sided = true;
    scene.materials.push(material);
    scene.objects.push(Object::new(name, name, shape));
}

/// A scene of the gallery as a small picture of the same view.
pub fn small(name: &str, width: u32, height: u32, samples: u32) -> Scene {
    let mut scene = (gallery::find(name).expect("a scene of the gallery").build)();
    scene.image.resize(width, height);
    scene.image.samples = samples;
    scene
}

/// Every scene of the gallery as a small picture.
pub fn gallery_in_small(samples: u32) -> impl Iterator<Item = (&'static str, Scene)> {
    gallery::scenes().map(move |entry| (entry.name, small(entry.name, 24, 24, samples)))
}

pub fn pixels(width: u32, height: u32) -> impl Iterator<Item = [u32; 2]> {
    (0..height).flat_map(move |y| (0..width).map(move |x| [x, y]))
}

pub fn bits(color: Rgb) -> [u64; 3] {
    color.to_array().map(f64::to_bits)
}

/// Fails at the first pixel that differs in any bit.
pub fn assert_same_bits(what: &str, a: &Film, b: &Film) {
    assert_eq!((a.width(), a.height()), (b.width(), b.height()), "{what}: the sizes differ");
    for at in pixels(a.width(), a.height()) {
        let (a, b) = (a.get(at), b.get(at));
        assert!(bits(a) == bits(b), "{what}: pixel {at:?} is {a:?} and {b:?}");
    }
}
