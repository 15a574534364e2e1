//! The command line: what cases cannot say.

mod explain;
mod pictures;
mod words;

use groundtruth::render;
use groundtruth::scene::Scene;
use groundtruth::world::World;
use rayon::prelude::*;

use crate::kit::Folder;

/// Law: the exported file of every gallery scene renders the same picture, bit for bit. Oracle: the picture of the gallery.
#[test]
fn an_exported_scene_renders_the_same_bits() {
    let scenes: Vec<gallery::Entry> = gallery::scenes().collect();
    scenes.into_par_iter().for_each(|entry| {
        let exported = Folder::new().good(&format!("groundtruth export {}", entry.name));
        let exported: Scene = toml::from_str(&exported).expect("it is a scene");
        let [original, read] = [(entry.build)(), exported].map(|mut scene| {
            scene.image.resize(12, 8);
            render::render(&World::build(&scene).expect("gallery scenes are valid"))
        });
        assert!(original == read, "{}", entry.name);
    });
}

/// The words of the first text between two others.
fn between<'a>(text: &'a str, before: &str, after: &str) -> &'a str {
    let (_, rest) = text.split_once(before).expect(before);
    rest.split_once(after).expect(after).0
}

/// Law: what the class gets does not name the mistake, the printed command makes the same files again, and the key's
/// first command finds the mistake. Oracle: the bytes of the files, and `verify`.
#[test]
fn a_class_gets_pictures_and_its_teacher_the_key() {
    let folder = Folder::new();
    for to in ["ex", "again"] {
        let options = "--count 2 --seed 5 --level hard --width 40";
        folder.good(&format!("groundtruth exercise ch14 -o {to} {options}"));
    }
    folder.good("diff -r ex/class again/class");
    let key = folder.text("ex/teacher/key.html");
    let name = between(&key, "<h2>1: ", "</h2>");
    let words = between(&key, "</h2>\n<p>", "</p>");
    for file in ["sheet.html", "1.png", "2.png", "scenes/1.toml", "scenes/2.toml"] {
        let text = String::from_utf8_lossy(&folder.bytes(&format!("ex/class/{file}"))).into_owned();
        assert!(!text.contains(name) && !text.contains(words), "{file} tells: {name}");
    }
    let judged = folder.run("cd ex/class; groundtruth verify scenes/1.toml 1.png");
    judged.expect(1, &[words]);
}
