//! Numbers of light: those that no picture can hold are refused, those that create light are noted.

use std::collections::BTreeMap;

use groundtruth::film::{self, Tone};

use super::with;
use crate::prelude::*;

/// The scene with this recipe in place of the matte one.
fn with_recipe(recipe: &str) -> String {
    let matte = "[materials.recipe.matte]\nka = 0.1\ncd = [1, 0, 0]\n";
    with(matte, &format!("[materials.recipe]\n{recipe}\n"))
}

/// Law: every picture of numbers at the ends of their ranges is finite. Oracle: the definition.
#[test]
fn the_largest_numbers_make_finite_pictures() {
    let shadows = "background = 1e30\ntransparency.shadows = \"attenuated\"";
    for recipe in [
        "dielectric = { inside = { eta = 1e10 }, outside = { eta = 1e-10 } }",
        "dielectric = { inside = { eta = 1e-10 }, outside = { eta = 1e10 } }",
        "transparent = { kt = 1, eta = 1e-10 }",
        "emissive = { ls = 1e30, ce = 1e30 }",
        "phong = { ka = 1e30, kd = 1e30, cd = 1e30, ks = 1e30, exponent = 1e15 }",
    ] {
        let text = with_recipe(recipe).replace("background = 0.5", shadows);
        let text = text.replace("[1, 2, 3]", "[1, 2, 3], ls = 1e30, color = 1e30");
        let (_, world) = scenefile::from_toml(&text, Path::new("scene.toml")).expect(recipe);
        let film = render::render(&world);
        assert!(film.to_f32().flatten().all(f32::is_finite), "{recipe}: {:?}", film.pixels());
    }
}

/// Law: a channel beyond the largest `f32` is stored as that number. Oracle: the EXR and the PFM file, read again.
#[test]
fn files_have_no_infinities() {
    let mut film = Film::new(1, 1);
    film.set([0, 0], Rgb::new(1e300, f64::INFINITY, 0.5));
    let stored = [f32::MAX, f32::MAX, 0.5];
    assert_eq!(film.to_f32().collect::<Vec<_>>(), [stored], "the film's numbers");
    let folder = tempfile::tempdir().expect("a folder");
    let [exr, pfm] = ["bright.exr", "bright.pfm"].map(|name| folder.path().join(name));
    for path in [&exr, &pfm] {
        film::write(&film, &Tone::PLAIN, path).expect("it can be written");
    }
    let read = film::read_exr(&exr).expect("it can be read");
    assert_eq!(read.to_f32().collect::<Vec<_>>(), [stored], "the EXR file's numbers");
    let bytes = std::fs::read(&pfm).expect("it can be read");
    let numbers = &bytes[bytes.len() - 12..];
    assert_eq!(numbers, stored.map(f32::to_le_bytes).concat(), "the PFM file's numbers");
}

/// Law: a constant share of light above 1 is noted with material and fields, wherever it stands; shares up to
/// 1, emission and the strengths of lights are not. Oracle: the products, by hand, in `noted.toml`.
#[test]
fn materials_that_create_light_are_noted() {
    let table: BTreeMap<String, String> =
        toml::from_str(include_str!("noted.toml")).expect("a table");
    for (recipe, noted) in &table {
        let text = with_recipe(recipe).replace("[1, 2, 3]", "[1, 2, 3], ls = 9");
        let (scene, world) = scenefile::from_toml(&text, Path::new("scene.toml")).expect(recipe);
        let mut notes = explain::notes(&scene, &world);
        notes.retain(|note| note.starts_with("material")); // without what the tracer leaves out
        assert_eq!(notes.len(), usize::from(!noted.is_empty()), "{recipe}: {notes:?}");
        let is_right = |note: &String| note.starts_with(&format!("material \"red\": {noted}"));
        assert!(notes.iter().all(is_right), "{recipe}: {notes:?}, expected {noted}");
    }
}
