//! A world with one object of a scene.

use std::path::Path;

use groundtruth::background::Background;
use groundtruth::invalid::Invalid;
use groundtruth::materials::Matte;
use groundtruth::rgb::Rgb;
use groundtruth::scene::{Material, Object, Scene};
use groundtruth::textures::Amount;
use groundtruth::world::World;

/// A world with this object alone, switched on. Its materials are matte, as they do not decide where it is hit, and
/// no image needs to be read.
pub fn world(scene: &Scene, folder: &Path, object: u32) -> Result<World, Invalid> {
    let mut object: Object = scene.objects[object as usize].clone();
    object.enabled = true;
    let matte = |material: &Material| {
        let black = Matte { ka: Amount::default(), kd: Amount::default(), cd: Rgb::BLACK.into() };
        Material { recipe: black.into(), bump: None, ..material.clone() }
    };
    let mut alone = Scene {
        background: Background::Color(Rgb::BLACK),
        lights: Vec::new(),
        materials: scene.materials.iter().map(matte).collect(),
        objects: vec![object],
        ..scene.clone()
    };
    (alone.image.samples, alone.image.sampler) = (1, None);
    if !alone.uses_textbook() {
        alone.epsilon = None; // of other objects: refused where nothing uses it
    }
    World::build_in(&alone, folder)
}
