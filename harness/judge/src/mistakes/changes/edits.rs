//! Mistakes inside nested data: meshes within compounds, the shares of materials. They edit the scene as the tree of
//! tables that its file would be.

use groundtruth::scene::Scene;
use serde_json::{Map, Value};

use crate::mistakes::{How, Mistake, known};

const AMBIENT_OF_KD: Mistake =
    Mistake::scene(&known::AMBIENT_OF_KD, |scene, _| with_ambient(scene, |_, kd| kd));

pub(super) const ALL: &[Mistake] = &[
    Mistake::scene(&known::AMBIENT_WITHOUT_KA, |scene, _| with_ambient(scene, |_, _| 1.0)),
    AMBIENT_OF_KD,
    AMBIENT_OF_KD
        .in_form("times k_a", How::Scene(|scene, _| with_ambient(scene, |ka, kd| ka * kd))),
    Mistake::scene(&known::HIGHLIGHT_OF_SURFACE_COLOUR, |scene, _| {
        edited(scene, "materials", &highlight_of_surface_color)
    }),
    Mistake::scene(&known::FLAT_SHADING, |scene, _| edited(scene, "objects", &flat)),
    Mistake::scene(&known::KR_KT_EXCHANGED, |scene, _| {
        edited(scene, "materials", &kr_kt_exchanged)
    }),
    Mistake::scene(&known::MEDIA_EXCHANGED, |scene, _| {
        edited(scene, "materials", &media_exchanged)
    }),
];

/// The scene with this change of each table in its list of this name; `None` if it changes none, or if the scene cannot
/// be written to a file.
pub(super) fn edited(
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
pub(in crate::mistakes) fn edit_each(
    value: &mut Value,
    edit: &dyn Fn(&mut Map<String, Value>) -> bool,
) -> bool {
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

/// The scene with another `k_a`, of `k_a` and `k_d`, where both are numbers.
fn with_ambient(scene: &Scene, ambient: fn(f64, f64) -> f64) -> Option<Scene> {
    edited(scene, "materials", &|table| {
        let number = |key: &str| table.get(key).and_then(Value::as_f64);
        let (Some(ka), Some(kd)) = (number("ka"), number("kd")) else { return false };
        let changed = ambient(ka, kd);
        table.insert("ka".to_owned(), changed.into());
        changed != ka
    })
}

fn highlight_of_surface_color(table: &mut Map<String, Value>) -> bool {
    let (Some(cd), Some(cs)) = (table.get("cd"), table.get("cs")) else { return false };
    let (cd, is_changed) = (cd.clone(), cd != cs);
    table.insert("cs".to_owned(), cd);
    is_changed
}

fn exchanged(table: &mut Map<String, Value>, [a, b]: [&str; 2]) -> bool {
    let (Some(first), Some(second)) = (table.get(a), table.get(b)) else { return false };
    let (first, second) = (first.clone(), second.clone());
    let is_changed = first != second;
    table.insert(a.to_owned(), second);
    table.insert(b.to_owned(), first);
    is_changed
}

fn kr_kt_exchanged(table: &mut Map<String, Value>) -> bool {
    exchanged(table, ["kr", "kt"])
}

fn media_exchanged(table: &mut Map<String, Value>) -> bool {
    exchanged(table, ["inside", "outside"])
}

fn flat(table: &mut Map<String, Value>) -> bool {
    let is_smooth = table.get("smooth") == Some(&Value::Bool(true));
    if is_smooth {
        table.insert("smooth".to_owned(), Value::Bool(false));
    }
    is_smooth
}
