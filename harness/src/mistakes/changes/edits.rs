//! Mistakes inside nested data: meshes within compounds, textures within textures. They edit the scene as the tree of
//! tables that its file would be.

use groundtruth::scene::Scene;
use serde_json::{Map, Value, json};

use crate::mistakes::Mistake;

pub(super) const ALL: &[Mistake] = &[
    Mistake::scene(
        23,
        "flat-shading",
        "smooth meshes are shaded by the normals of their faces",
        |scene, _| edited(scene, "objects", &flat),
    ),
    Mistake::scene(
        29,
        "texture-upside-down",
        "rows of texture images are counted from the other end",
        |scene, _| edited(scene, "materials", &upside_down),
    ),
    Mistake::scene(
        31,
        "one-octave-less",
        "sums of several octaves of noise lack the last one",
        |scene, _| edited(scene, "materials", &one_octave_less),
    ),
];

/// The scene with this change of each table in its list of this name; `None` if it changes none, or if the scene cannot
/// be written to a file.
fn edited(
    scene: &Scene,
    list: &str,
    edit: &dyn Fn(&mut Map<String, Value>) -> bool,
) -> Option<Scene> {
    let mut whole = serde_json::to_value(scene).ok()?;
    let is_changed = edit_each(whole.get_mut(list)?, edit);
    if !is_changed {
        return None;
    }
    serde_json::from_value(whole).ok()
}

/// Applies the change to a table and all tables inside it, from the outside in; not inside a table that it changed.
fn edit_each(value: &mut Value, edit: &dyn Fn(&mut Map<String, Value>) -> bool) -> bool {
    let mut is_changed = false;
    match value {
        Value::Object(table) => {
            if edit(table) {
                return true;
            }
            table.values_mut().for_each(|inner| is_changed |= edit_each(inner, edit));
        }
        Value::Array(items) => {
            items.iter_mut().for_each(|inner| is_changed |= edit_each(inner, edit));
        }
        _ => {}
    }
    is_changed
}

fn flat(table: &mut Map<String, Value>) -> bool {
    let is_smooth = table.get("smooth") == Some(&Value::Bool(true));
    if is_smooth {
        table.insert("smooth".to_owned(), Value::Bool(false));
    }
    is_smooth
}

/// Reflects an image on its object so that v becomes 1 − v.
fn upside_down(table: &mut Map<String, Value>) -> bool {
    let Some(image) = table.get("image").filter(|_| table.len() == 1).cloned() else {
        return false;
    };
    let axis = match image.get("mapping").and_then(Value::as_str) {
        Some("square") => "x",
        Some("cylindrical" | "spherical" | "light_probe" | "panoramic") => "y",
        // v is not symmetric about the origin
        _ => return false,
    };
    table.remove("image");
    let reflected = json!({ "of": { "image": image }, "transform": [{ "reflect": axis }] });
    table.insert("texture_instance".to_owned(), reflected);
    true
}

fn one_octave_less(table: &mut Map<String, Value>) -> bool {
    let octaves = table.get("octaves").and_then(Value::as_u64).filter(|octaves| *octaves > 1);
    if let Some(octaves) = octaves {
        table.insert("octaves".to_owned(), (octaves - 1).into());
    }
    octaves.is_some()
}
