//! Mistakes that are another scene, or another pixel: what our tracer answers to it is what they would.

mod lights;
mod surfaces;
mod views;

use serde_json::{Map, Value};

use super::super::mistakes::Mistake;

/// A mistake, and what it makes of the data of a `radiance`.
#[derive(Debug)]
pub struct SceneMistake {
    /// The mistake.
    pub mistake: &'static Mistake,
    /// `None` if there is nothing to change.
    pub apply: fn(&mut Value) -> Option<()>,
}

/// All of them.
pub fn all() -> impl Iterator<Item = &'static SceneMistake> {
    [lights::KNOWN, lights::ALL, surfaces::ALL, surfaces::KNOWN, views::ALL, views::KNOWN]
        .into_iter()
        .flatten()
}

/// A list of changes: words, place in the book, change.
macro_rules! changes {
    ($($words:literal, $place:literal => $apply:expr;)*) => {
        &[$(SceneMistake {
            mistake: &Mistake::of_answers($words, $place, None),
            apply: $apply,
        }),*]
    };
}
use changes;

/// The fields of a table.
type Fields = Map<String, Value>;

/// `Some` if anything was changed.
fn any(changed: impl Iterator<Item = ()>) -> Option<()> {
    (changed.count() > 0).then_some(())
}

/// Changes each item of a list of the scene.
fn items(data: &mut Value, list: &str, change: impl Fn(&mut Fields) -> Option<()>) -> Option<()> {
    let items = data.get_mut("scene")?.get_mut(list)?.as_array_mut()?;
    any(items.iter_mut().filter_map(|item| change(item.as_object_mut()?)))
}

/// Changes the data of the kind that each item of a list has in a field.
fn kinds(
    data: &mut Value,
    list: &str,
    field: &str,
    change: impl Fn(&str, &mut Fields) -> Option<()>,
) -> Option<()> {
    items(data, list, |item| {
        let (kind, fields) = item.get_mut(field)?.as_object_mut()?.iter_mut().next()?;
        change(kind, fields.as_object_mut()?)
    })
}

/// Changes the source of each light.
fn lights(data: &mut Value, change: impl Fn(&str, &mut Fields) -> Option<()>) -> Option<()> {
    kinds(data, "lights", "source", change)
}

/// Changes the recipe of each material.
fn recipes(data: &mut Value, change: impl Fn(&str, &mut Fields) -> Option<()>) -> Option<()> {
    kinds(data, "materials", "recipe", change)
}

/// Changes what is matte or shiny of each material: all of it, or what is under a mirror.
fn bases(data: &mut Value, change: impl Fn(&mut Fields) -> Option<()>) -> Option<()> {
    recipes(data, |kind, fields| match kind {
        "matte" | "phong" => change(fields),
        "emissive" => change(fields.get_mut("matte")?.as_object_mut()?),
        _ => change(fields.get_mut("phong")?.as_object_mut()?),
    })
}

/// Changes every table of this name in a list of the scene, also inside others; not inside one that it changed.
fn tables(
    data: &mut Value,
    list: &str,
    name: &str,
    change: &dyn Fn(&mut Fields) -> Option<()>,
) -> Option<()> {
    fn inside(
        value: &mut Value,
        name: &str,
        change: &dyn Fn(&mut Fields) -> Option<()>,
    ) -> Option<()> {
        match value {
            Value::Object(fields) => any(fields.iter_mut().filter_map(|(key, value)| match value
                .as_object_mut()
                .filter(|_| key == name)
            {
                Some(table) => change(table).or_else(|| inside(value, name, change)),
                None => inside(value, name, change),
            })),
            Value::Array(items) => {
                any(items.iter_mut().filter_map(|item| inside(item, name, change)))
            }
            _ => None,
        }
    }
    inside(data.get_mut("scene")?.get_mut(list)?, name, change)
}

/// Sets a field, if that changes it.
fn set(fields: &mut Fields, field: &str, value: Value) -> Option<()> {
    if fields.get(field) == Some(&value) {
        return None;
    }
    fields.insert(field.to_owned(), value);
    Some(())
}

/// Sets a field that is there.
fn instead(fields: &mut Fields, field: &str, value: Value) -> Option<()> {
    let _ = fields.get(field)?;
    set(fields, field, value)
}

/// Leaves a field out.
fn without(fields: &mut Fields, field: &str) -> Option<()> {
    fields.remove(field).map(|_| ())
}

/// Changes a number, or each number of a list.
fn number(fields: &mut Fields, field: &str, by: impl Fn(f64) -> f64) -> Option<()> {
    let slot = fields.get_mut(field)?;
    let other = match slot.as_array() {
        None => Value::from(by(slot.as_f64()?)),
        Some(items) => {
            items.iter().map(|x| x.as_f64().map(&by)).collect::<Option<Vec<f64>>>()?.into()
        }
    };
    *slot = other;
    Some(())
}
