//! Small pictures of gallery scenes.

use std::path::Path;

use groundtruth::film::Film;
use groundtruth::render;
use groundtruth::samplers;
use groundtruth::scene::Scene;
use groundtruth::world::World;

/// A scene of the gallery with pictures of this size and so many samples.
pub fn scene(name: &str, size: [u32; 2], samples: u32) -> Scene {
    let mut scene = gallery::find(name).map(|entry| (entry.build)()).expect("listed");
    scene.image.resize(size[0], size[1]);
    scene.image.samples = samples;
    scene
}

/// The scene with another sampler.
pub fn with_sampler(mut scene: Scene, kind: samplers::Kind) -> Scene {
    scene.image.sampler = Some(kind);
    scene
}

pub fn world(scene: &Scene, seed: u64) -> World {
    World::build_seeded(scene, Path::new(""), seed).expect("gallery scenes are valid")
}

/// The picture of this seed.
pub fn film(scene: &Scene, seed: u64) -> Film {
    render::render(&world(scene, seed))
}

/// The pictures of these seeds.
pub fn films(world: &mut World, seeds: impl Iterator<Item = u64>) -> Vec<Film> {
    let film = |seed| {
        world.reseed(seed);
        render::render(world)
    };
    seeds.map(film).collect()
}
