//! The objects of a log as a world that rays can be asked of.

use std::path::Path;

use groundtruth::scene::{Object, Scene};
use groundtruth::shapes;
use groundtruth::world::World;
use serde_json::{Map, Value, json};

use crate::log::{Log, Named};

/// The world of the objects that a log names, each a shape in the words of scene files; `None` if it names none.
///
/// Meshes and images are looked for in `folder`.
///
/// # Errors
/// A sentence: which object cannot be read, and why.
pub fn world_of(log: &Log, folder: &Path) -> Result<Option<World>, String> {
    // an object may be a name alone
    let is_shaped = |named: &&Named| named.fields.values().any(Value::is_object);
    let shaped: Vec<Object> =
        log.objects.iter().filter(is_shaped).map(object).collect::<Result<_, _>>()?;
    if shaped.is_empty() {
        return Ok(None);
    }
    let mut scene = empty_scene();
    scene.objects = shaped;
    World::build_in(&scene, folder).map(Some).map_err(|e| e.to_string())
}

/// A world without objects, in which rays can be drawn.
pub fn empty_world() -> World {
    World::build(&empty_scene()).expect("an empty scene is valid")
}

fn empty_scene() -> Scene {
    let nothing = json!({
        "image": {"width": 1, "height": 1},
        "camera": {"eye": [0, 0, 1], "look_at": [0, 0, 0], "lens": {"pinhole": {"distance": 1}}},
        "materials": [{"name": MATERIAL, "recipe": {"matte": {"cd": 1}}}],
    });
    serde_json::from_value(nothing).expect("an empty scene can be read")
}

/// The world of a scene that the log's head has in the words of scene files.
///
/// # Errors
/// What is wrong with it.
pub fn inline_scene(scene: &Value, folder: &Path) -> Result<World, String> {
    let scene: Scene =
        serde_json::from_value(scene.clone()).map_err(|e| format!("the log's scene: {e}"))?;
    World::build_in(&scene, folder).map_err(|e| format!("the log's scene: {e}"))
}

/// What all objects are made of: only their shapes count.
const MATERIAL: &str = "any";

fn object(named: &Named) -> Result<Object, String> {
    let mut fields = named.fields.clone();
    let shape = fields.remove("shape").unwrap_or_else(|| {
        // the shape may stand in the line itself, under the name of its kind
        Value::Object(
            fields
                .iter()
                .filter(|(_, value)| value.is_object())
                .map(|(key, value)| (key.clone(), value.clone()))
                .collect::<Map<_, _>>(),
        )
    });
    let kind: shapes::Kind =
        serde_json::from_value(shape).map_err(|e| format!("object \"{}\": {e}", named.name))?;
    Ok(Object::new(&named.name, MATERIAL, kind))
}
