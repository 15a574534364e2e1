//! The objects of a log as a world that rays can be asked of.

use std::collections::{HashMap, HashSet};
use std::f64::consts::TAU;
use std::path::Path;

use groundtruth::math::cos;
use groundtruth::scene::{Material, Object, Scene};
use groundtruth::shapes;
use groundtruth::world::World;
use serde_json::{Value, json};

use crate::log::{Log, Named, Purpose};

/// The world that a log is of: the scene that its head names, which `named` finds, or has in the words of scene files; else
/// the objects that it names, each a shape; `None` if it names none. Meshes and images are looked for in `folder`.
///
/// # Errors
/// A sentence: which object cannot be read, and why; what is wrong with the scene.
pub fn world_of(
    log: &Log,
    folder: &Path,
    named: impl FnOnce(&str) -> Result<(Scene, World), String>,
) -> Result<Option<(Scene, World)>, String> {
    let wrong = |problem: String| format!("the log's scene: {problem}");
    match &log.head.scene {
        Some(Value::String(name)) => return named(name).map(Some).map_err(wrong),
        Some(scene) => {
            let scene = inline_scene(scene)?;
            let world = World::build_in(&scene, folder).map_err(|e| wrong(e.to_string()))?;
            return Ok(Some((scene, world)));
        }
        None => {}
    }
    // an object may be a name alone
    let is_shaped = |named: &&Named| named.fields.values().any(Value::is_object);
    let shaped = log.objects.iter().filter(is_shaped).enumerate();
    let shaped: Vec<Object> =
        shaped.map(|(place, named)| object(place, named)).collect::<Result<_, _>>()?;
    if shaped.is_empty() {
        return Ok(None);
    }
    let (mut scene, clear) = (empty_scene(), let_through(log));
    let names = shaped.iter().map(|object| object.name.as_str());
    let look = |(place, name): (usize, &str)| looks(place, clear.contains(name));
    scene.materials = names.enumerate().map(look).collect();
    scene.objects = shaped;
    let world = World::build_in(&scene, folder).map_err(|e| e.to_string())?;
    Ok(Some((scene, world)))
}

/// A scene that the log's head has in the words of scene files.
///
/// # Errors
/// What is wrong with it.
pub fn inline_scene(scene: &Value) -> Result<Scene, String> {
    serde_json::from_value(scene.clone()).map_err(|e| format!("the log's scene: {e}"))
}

/// A world without objects, in which rays can be drawn.
pub fn empty_world() -> World {
    World::build(&empty_scene()).expect("an empty scene is valid")
}

/// A scene of nothing, of one pixel.
pub fn empty_scene() -> Scene {
    let nothing = json!({
        "image": {"width": 1, "height": 1},
        "camera": {"eye": [0, 0, 1], "look_at": [0, 0, 0], "lens": {"pinhole": {"distance": 1}}},
    });
    serde_json::from_value(nothing).expect("an empty scene can be read")
}

/// The objects that rays go through, as the log tells it.
fn let_through(log: &Log) -> HashSet<&str> {
    let names: HashMap<_, _> =
        log.rays.iter().map(|ray| ((ray.pixel, ray.sample, &ray.id), ray)).collect();
    let through = log.rays.iter().filter(|ray| ray.is(&Purpose::Transmitted));
    let from = through.filter_map(|ray| names.get(&(ray.pixel, ray.sample, &ray.parent)));
    from.filter_map(|ray| ray.object.as_deref()).collect()
}

/// What an object is drawn with: glass, or one of many colours. Laws ask for nothing but its shape.
fn looks(place: usize, is_clear: bool) -> Material {
    // far apart on the circle of hues, however many there are
    let hue = 0.618 * place as f64;
    let channel = |third: f64| 0.6 + 0.3 * cos(TAU * (hue + third / 3.0));
    let colour = [0.0, 1.0, 2.0].map(channel);
    let recipe = match is_clear {
        true => json!({"dielectric": {"inside": {"eta": 1.5}}}),
        false => json!({"matte": {"kd": 1, "cd": colour}}),
    };
    let material = json!({"name": place.to_string(), "recipe": recipe});
    serde_json::from_value(material).expect("a material can be read")
}

fn object(place: usize, named: &Named) -> Result<Object, String> {
    let mut fields = named.fields.clone();
    let shape = match fields.remove("shape") {
        Some(shape) => shape,
        // it may stand in the line itself, under the name of its kind
        None => Value::Object(fields.into_iter().filter(|(_, it)| it.is_object()).collect()),
    };
    let kind: shapes::Kind =
        serde_json::from_value(shape).map_err(|e| format!("object \"{}\": {e}", named.name))?;
    Ok(Object::new(&named.name, &place.to_string(), kind))
}
