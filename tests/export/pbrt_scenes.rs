//! The scenes of the gallery that can be said to pbrt.

use std::fs;

use groundtruth::gallery;
use groundtruth::scene::Scene;
use harness::export::Term;

use super::pbrt_parsed::{parsed, written};

/// The fewest with a light that are worth the name of an export.
const LEAST: usize = 25;

/// A scene without these terms, with 96 columns of pixels and a ray through the centre of each.
fn reduced(mut scene: Scene, without: &[Term]) -> Scene {
    without.iter().for_each(|term| term.remove(&mut scene));
    let image = &mut scene.image;
    image.samples = 1;
    let rows = (96.0 * f64::from(image.height) / f64::from(image.width)).round() as u32;
    image.resize(96, rows.max(1));
    scene
}

/// The names of scenes in a paragraph of the page.
fn names(paragraph: &str) -> Vec<&str> {
    paragraph.split('`').skip(1).step_by(2).filter(|name| name.starts_with("ch")).collect()
}

/// Law: docs/renderers.md lists the scenes of the gallery that can be said without ambient light and highlights, then those
/// that can be without all terms; at least 25 have a light; and the text of each can be read.
#[test]
fn the_page_lists_the_scenes() {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../docs/renderers.md");
    let page = fs::read_to_string(file).expect("the page is there");
    let section = page.split("## Scenes of pbrt\n").nth(1).expect("it has the section");
    let listed = section.split("\n## ").next().map(names).unwrap_or_default();
    let few = [Term::Phong, Term::Ambient];
    // pbrt has the 1/η² of radiance
    let all: Vec<Term> =
        Term::ALL.map(|(_, term)| term).into_iter().filter(|it| *it != Term::Scaling).collect();
    let (mut lit, mut found, mut more) = (0, Vec::new(), Vec::new());
    for entry in gallery::scenes() {
        let said = |without: &[Term]| written(&reduced((entry.build)(), without)).ok();
        let text = match said(&few) {
            Some(text) => {
                found.push(entry.name);
                text
            }
            None => {
                let Some(text) = said(&all) else { continue };
                more.push(entry.name);
                text
            }
        };
        let read = parsed(&text);
        let shines = read.shapes.iter().any(|shape| shape.area_light.is_some());
        lit += usize::from(shines || !read.lights.is_empty());
    }
    let expected = [found, more].concat();
    assert_eq!(listed, expected, "write the list as it is:\n`{}`", expected.join("`, `"));
    assert!(lit >= LEAST, "{lit} have a light");
}
