//! Scenes for these laws.

use groundtruth::math::Pcg32;
use groundtruth::render::{Canvas, Crop};
use groundtruth::scene::Scene;
use groundtruth::world::World;
use layers::LayerFilms;

/// A scene of the gallery with this many columns, and at most this many samples.
pub fn small(scene: &Scene, width: u32, samples: u32) -> (Scene, World) {
    let mut scene = scene.clone();
    let height = (scene.image.height * width).div_ceil(scene.image.width).max(1);
    scene.image.resize(width, height);
    scene.image.samples = scene.image.samples.min(samples);
    let world = World::build(&scene).expect("gallery scenes are valid");
    (scene, world)
}

/// The scene of the gallery of this name.
pub fn named(name: &str, width: u32, samples: u32) -> (Scene, World) {
    let entry = gallery::find(name).unwrap_or_else(|| panic!("no scene {name}"));
    small(&(entry.build)(), width, samples)
}

/// The whole picture of a world.
pub fn whole(world: &World) -> Crop {
    let [width, height] = world.picture_size();
    Crop { x: 0, y: 0, width, height }
}

/// All layers of a part of a world's picture.
pub fn films(world: &World, crop: Crop) -> (LayerFilms, Canvas) {
    let (films, canvas) = (LayerFilms::new(crop), Canvas::cropped(crop));
    films.render(world, &canvas);
    (films, canvas)
}

/// Some pixels of a world's picture, by a fixed seed.
pub fn random_pixels(world: &World, count: u32) -> Vec<[u32; 2]> {
    let mut random = Pcg32::new(world.seed, u64::from(count));
    let [width, height] = world.picture_size();
    (0..count).map(|_| [random.below(width), random.below(height)]).collect()
}
