//! Changes of the fields of a scene: of its file as a tree of tables, in the field `scene` of a value.

use serde_json::{Map, Value, json};

/// The fields of a table.
pub type Fields = Map<String, Value>;

/// `Some` if anything was changed.
pub fn any(changed: impl Iterator<Item = ()>) -> Option<()> {
    (changed.count() > 0).then_some(())
}

/// Changes each item of a list of the scene.
pub fn items(
    data: &mut Value,
    list: &str,
    change: impl Fn(&mut Fields) -> Option<()>,
) -> Option<()> {
    let items = data.get_mut("scene")?.get_mut(list)?.as_array_mut()?;
    any(items.iter_mut().filter_map(|item| change(item.as_object_mut()?)))
}

/// Changes the data of the kind that each item of a list has in a field.
pub fn kinds(
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
pub fn lights(data: &mut Value, change: impl Fn(&str, &mut Fields) -> Option<()>) -> Option<()> {
    kinds(data, "lights", "source", change)
}

/// Changes the recipe of each material.
pub fn recipes(data: &mut Value, change: impl Fn(&str, &mut Fields) -> Option<()>) -> Option<()> {
    kinds(data, "materials", "recipe", change)
}

/// Changes what is matte or shiny of each material: all of it, or what is under a mirror.
pub fn bases(data: &mut Value, change: impl Fn(&mut Fields) -> Option<()>) -> Option<()> {
    recipes(data, |kind, fields| match kind {
        "matte" | "phong" => change(fields),
        "emissive" => change(fields.get_mut("matte")?.as_object_mut()?),
        _ => change(fields.get_mut("phong")?.as_object_mut()?),
    })
}

/// Changes every table of this name in a list of the scene, also inside others; not inside one that it changed.
pub fn tables(
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

/// Changes the recipe of each material of these kinds.
pub fn of_kinds(
    data: &mut Value,
    kinds: &[&str],
    change: impl Fn(&mut Fields) -> Option<()>,
) -> Option<()> {
    recipes(data, |kind, fields| if kinds.contains(&kind) { change(fields) } else { None })
}

/// Changes each step of each instance, but not of those inside others.
pub fn steps(data: &mut Value, change: fn(&mut Fields) -> Option<()>) -> Option<()> {
    tables(data, "objects", "instance", &|instance| {
        let steps = instance.get_mut("transform")?.as_array_mut()?;
        any(steps.iter_mut().filter_map(|step| change(step.as_object_mut()?)))
    })
}

/// Sets a field, if that changes it.
pub fn set(fields: &mut Fields, field: &str, value: Value) -> Option<()> {
    if fields.get(field) == Some(&value) {
        return None;
    }
    fields.insert(field.to_owned(), value);
    Some(())
}

/// Sets a field that is there.
pub fn instead(fields: &mut Fields, field: &str, value: Value) -> Option<()> {
    let _ = fields.get(field)?;
    set(fields, field, value)
}

/// Leaves a field out.
pub fn without(fields: &mut Fields, field: &str) -> Option<()> {
    fields.remove(field).map(|_| ())
}

/// Changes a number, or each number of a list.
pub fn number(fields: &mut Fields, field: &str, by: impl Fn(f64) -> f64) -> Option<()> {
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

/// Whether lights of this kind are ambient.
pub fn is_ambient(kind: &str) -> bool {
    ["ambient", "ambient_occluder"].contains(&kind)
}

/// Whether a light is on and not ambient.
pub fn is_lamp(light: &Value) -> bool {
    let is_ambient =
        light["source"].as_object().is_some_and(|it| it.keys().any(|it| is_ambient(it)));
    light["enabled"] != json!(false) && !is_ambient
}

/// Keeps some of the lamps, by index and number.
pub fn keep_lamps(data: &mut Value, keep: fn(usize, usize) -> bool) -> Option<()> {
    let lights = data.get_mut("scene")?.get_mut("lights")?.as_array_mut()?;
    let (before, count) = (lights.len(), lights.iter().filter(|it| is_lamp(it)).count());
    let mut index = 0;
    lights.retain(|light| {
        if !is_lamp(light) {
            return true;
        }
        index += 1;
        keep(index - 1, count)
    });
    (lights.len() < before).then_some(())
}
