//! The command line: what cases cannot say.

mod explain;
mod pictures;
mod words;

use groundtruth::render;
use groundtruth::scene::Scene;
use groundtruth::world::World;
use rayon::prelude::*;

/// Law: the text of every gallery scene, which `export` prints, renders the same picture, bit for bit. Oracle: the picture of the
/// gallery.
#[test]
fn an_exported_scene_renders_the_same_bits() {
    let scenes: Vec<gallery::Entry> = gallery::scenes().collect();
    scenes.into_par_iter().for_each(|entry| {
        let exported = scenefile::to_toml(&(entry.build)()).expect("plain data");
        let exported: Scene = toml::from_str(&exported).expect("it is a scene");
        let [original, read] = [(entry.build)(), exported].map(|mut scene| {
            scene.image.resize(12, 8);
            render::render(&World::build(&scene).expect("gallery scenes are valid"))
        });
        assert!(original == read, "{}", entry.name);
    });
}
