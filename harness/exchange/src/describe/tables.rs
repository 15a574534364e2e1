//! Look-ups in the schema of scene files and in the data of a scene.

use serde_json::Value;

use scenefile::vocabulary::Definition;

/// A table of the schema.
///
/// # Panics
/// If there is none of this name; the description of every gallery scene shows that there is.
pub fn table(name: &str) -> Definition {
    Definition::all().find(|it| it.name == name).expect("it is in the schema")
}

/// The table or list of kinds of a field of the scene.
pub fn field_of_scene(name: &str) -> Option<Definition> {
    Definition::scene().fields().find(|field| field.name == name)?.content()
}

/// Whether a key is anywhere in the data.
pub fn has(data: &Value, key: &str) -> bool {
    !all_of(data, key).is_empty()
}

/// All values of a key, at any depth.
pub fn all_of<'a>(data: &'a Value, key: &str) -> Vec<&'a Value> {
    match data {
        Value::Object(entries) => entries
            .iter()
            .flat_map(|(name, value)| {
                let own = (name == key).then_some(value);
                own.into_iter().chain(all_of(value, key))
            })
            .collect(),
        Value::Array(items) => items.iter().flat_map(|item| all_of(item, key)).collect(),
        _ => Vec::new(),
    }
}

/// Whether some medium of the scene absorbs light.
pub fn absorbs(data: &Value) -> bool {
    let is_zero = |channel: &Value| channel.as_f64() == Some(0.0);
    let is_clear = |color: &Value| match color {
        Value::Array(channels) => channels.iter().all(is_zero),
        grey => is_zero(grey),
    };
    all_of(data, "absorption").into_iter().any(|color| !is_clear(color))
}

/// The tag of a kind: its one key, or the whole of a kind without fields.
pub fn tag(kind: &Value) -> &str {
    let key = || kind.as_object()?.keys().next().map(String::as_str);
    kind.as_str().or_else(key).unwrap_or_default()
}
