//! A scene in plain words and numbers, from which a person can build it in another renderer.
//!
//! The settings are read from the scene's data, walked along the [`schema`](scenefile::schema()), and their
//! meaning from its doc comments, so that a new kind is described without a word here; the formulas of lights and
//! materials are in their own files. Written by hand, in `texts.txt`, are the conventions, the rays of the cameras, the
//! tracers, and what some kinds are exactly.

mod camera;
mod files;
mod page;
mod picture;
mod random;
mod tables;
mod texts;
mod tracer;
mod values;
mod words;

use std::error::Error;
use std::path::Path;

use serde_json::Value;

use groundtruth::kinds::Entry;
use groundtruth::printable;
use groundtruth::scene::{Intersect, Scene};
use groundtruth::world::World;
use groundtruth::{lights, materials};
use scenefile::vocabulary::Definition;

use tables::{field_of_scene, table};
use values::DescribedValues;

pub use texts::details;

/// The description of a scene and its world. File names in the scene are relative to `folder`.
///
/// # Errors
/// The scene has a kind of a user's own, or a file cannot be read any more.
pub fn describe(
    name: &str,
    scene: &Scene,
    world: &World,
    folder: &Path,
) -> Result<String, Box<dyn Error>> {
    let data = data_of(scene)?;
    let mut to = DescribedValues::default();
    to.page.line(0, &format!("Scene {}: {}", printable::text(name), printable::text(&scene.about)));
    picture::conventions(&mut to);
    picture::write(&mut to, scene, world, &data);
    camera::write(&mut to, scene, world, &data);
    tracer::write(&mut to, scene, &data);
    to.page.heading("Background");
    to.page.tell("background");
    to.page.blank();
    to.value(0, "background", &data["background"], field_of_scene("background"));
    lights(&mut to, &data);
    materials(&mut to, &data);
    objects(&mut to, scene, &data);
    let DescribedValues { mut page, words } = to;
    files::write(&mut page, &data, folder)?;
    random::write(&mut page, &data);
    page.heading("Words");
    words.write(&mut page);
    Ok(page.into_text())
}

/// The data of a scene, as its file says it.
fn data_of(scene: &Scene) -> Result<Value, Box<dyn Error>> {
    let mut data: Value = toml::from_str(&scenefile::to_toml(scene)?)?;
    // a file leaves out the box
    data["image"]["filter"] = serde_json::to_value(&scene.image.filter)?;
    Ok(data)
}

fn lights(to: &mut DescribedValues, data: &Value) {
    to.page.heading("Lights");
    if items(data, "lights").is_empty() {
        return to.page.say("There are none.");
    }
    for (number, light) in (1..).zip(items(data, "lights")) {
        entry(to, "Light", number, table("Light"), light);
    }
    formulas(to, "lights", "At a hit, a light of the kind", lights::Kind::ENTRIES);
}

fn materials(to: &mut DescribedValues, data: &Value) {
    to.page.heading("Materials");
    for (number, material) in (1..).zip(items(data, "materials")) {
        entry(to, "Material", number, table("Material"), material);
    }
    formulas(to, "materials", "A surface of the kind", materials::Kind::ENTRIES);
    if to.words.uses_any_of("textures") || to.words.uses_any_of("bumps") {
        to.page.tell("local point");
    }
}

fn objects(to: &mut DescribedValues, scene: &Scene, data: &Value) {
    to.page.heading("Objects");
    to.page.tell("first object");
    if scene.intersections() != Some(Intersect::Robust) {
        to.page.tell("textbook");
        to.page.blank();
        for name in ["intersect", "epsilon"] {
            if let Some(value) = data.get(name) {
                to.value(0, name, value, field_of_scene(name));
            }
        }
    }
    for (number, object) in (1..).zip(items(data, "objects")) {
        entry(to, "Object", number, table("Object"), object);
    }
}

/// One light, material or object.
fn entry(to: &mut DescribedValues, what: &str, number: usize, table: Definition, item: &Value) {
    to.page.blank();
    let is_on = item["enabled"] != Value::Bool(false);
    let off = if is_on { "" } else { ", which is switched off: it is not part of the picture" };
    to.page.line(0, &format!("{what} {number}{off}"));
    to.fields(2, table, item);
}

fn items<'a>(data: &'a Value, list: &str) -> &'a [Value] {
    data[list].as_array().map_or(&[], Vec::as_slice)
}

/// The formulas of the kinds of a list that the scene uses.
fn formulas<Kind>(to: &mut DescribedValues, list: &str, beginning: &str, entries: &[Entry<Kind>]) {
    let mut is_first = true;
    // their files are named as they are in scene files
    for Entry { module, formula, .. } in entries {
        if formula.is_empty() || !to.words.uses(list, module) {
            continue;
        }
        if std::mem::take(&mut is_first) {
            to.page.blank();
        }
        to.page.line(0, &format!("{beginning} `{module}`: {formula}"));
    }
}
