//! The fields of a scene, named by their paths in its file, and the scene with one of them changed.

use std::path::Path;

use groundtruth::scene::Scene;
use scenefile::SceneError;
use toml::{Table, Value};

/// A field of a scene with another value, both as they stand in a scene file: the path `materials.glass.recipe.dielectric.inside.eta`
/// and the value `1.33`. An element of a list is named by its name, or by its place from 0.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Change {
    /// The path of the field.
    pub path: String,
    /// Its value.
    pub value: String,
}

impl Change {
    /// Reads `path = value`; `None` if it is not of this form.
    pub fn parse(text: &str) -> Option<Self> {
        let (path, value) = text.split_once('=')?;
        Some(Self { path: path.trim().to_owned(), value: value.trim().to_owned() })
    }

    /// The last part of the path and the value: `eta = 1.33`.
    pub fn short(&self) -> String {
        let last = self.path.rsplit('.').next().unwrap_or_default();
        format!("{last} = {}", self.value)
    }

    /// The scene with this value of the field.
    ///
    /// # Errors
    /// No such field, no value, or one that the field does not take.
    pub fn applied(&self, scene: &Scene) -> Result<Scene, String> {
        let mut table = table(scene)?;
        let field = slot(&mut table, &self.path)?;
        let is_text = matches!(field, Value::String(_));
        *field = match format!("value = {}", self.value).parse::<Table>() {
            Ok(mut parsed) if parsed.len() == 1 => parsed.remove("value").unwrap_or(false.into()),
            // a name needs no quotes
            _ if is_text => Value::String(self.value.clone()),
            _ => return Err(format!("\"{}\" is no value of a scene file", self.value)),
        };
        let parsed = scenefile::parse(table.to_string(), Path::new(""));
        parsed.map(|(scene, _)| scene).map_err(|error| match error {
            // without the line, which is of a text that nobody sees
            SceneError::Invalid { invalid, .. } => format!("{self}: {invalid}"),
            other => format!("{self}: {other}"),
        })
    }
}

impl std::fmt::Display for Change {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} = {}", self.path, self.value)
    }
}

/// All fields with their values, in the order of the scene file; none if the scene has a part of a custom kind.
pub fn all(scene: &Scene) -> Vec<Change> {
    let mut fields = Vec::new();
    if let Ok(table) = table(scene) {
        table.iter().for_each(|(key, value)| collect(key.clone(), value, &mut fields));
    }
    // the name of a thing is not a value of it
    fields.retain(|field| field.path != "about" && !field.path.ends_with(".name"));
    fields
}

/// Whether a text has all of these words, in capitals or not.
pub fn has_words(text: &str, words: &str) -> bool {
    let text = text.to_lowercase();
    words.to_lowercase().split_whitespace().all(|word| text.contains(word))
}

fn table(scene: &Scene) -> Result<Table, String> {
    let text = scenefile::to_toml(scene).map_err(|error| error.to_string())?;
    text.parse().map_err(|error: toml::de::Error| error.to_string())
}

fn collect(path: String, value: &Value, fields: &mut Vec<Change>) {
    match value {
        Value::Table(table) => {
            table.iter().for_each(|(key, value)| collect(format!("{path}.{key}"), value, fields));
        }
        Value::Array(values) if values.iter().any(|value| value.is_table()) => {
            for (index, value) in values.iter().enumerate() {
                let before = &values[..index];
                // of equal names only the first would be found
                let is_first = |it: &&str| before.iter().all(|other| name(other) != Some(it));
                let key = name(value).filter(|it| !it.is_empty()).filter(is_first);
                let key = key.map_or(index.to_string(), str::to_owned);
                collect(format!("{path}.{key}"), value, fields);
            }
        }
        value => fields.push(Change { path, value: value.to_string() }),
    }
}

fn name(value: &Value) -> Option<&str> {
    value.get("name")?.as_str()
}

/// The rest of a path after its first part, if that is this key: names may have dots and spaces.
fn after<'a>(path: &'a str, key: &str) -> Option<Option<&'a str>> {
    let rest = path.strip_prefix(key)?;
    match rest.strip_prefix('.') {
        Some(rest) => Some(Some(rest)),
        None => rest.is_empty().then_some(None),
    }
}

/// The value at a path. A field that the scene leaves to its default is added.
fn slot<'a>(table: &'a mut Table, path: &str) -> Result<&'a mut Value, String> {
    let found = table.iter().map(|(key, _)| key.as_str()).find(|key| after(path, key).is_some());
    match found.map(str::to_owned) {
        None if path.is_empty() => Err("a field has a name".to_owned()),
        None if path.contains('.') => {
            let first = path.split('.').next().unwrap_or_default();
            let keys: Vec<&str> = table.keys().map(String::as_str).collect();
            Err(format!("no field \"{first}\"; there are {}", keys.join(", ")))
        }
        None => Ok(table.entry(path).or_insert(false.into())),
        Some(key) => {
            let rest = after(path, &key).flatten();
            let value = table.get_mut(&key).ok_or("the field was found")?;
            inside(value, &key, rest)
        }
    }
}

/// The value at the rest of a path inside a value.
fn inside<'a>(
    value: &'a mut Value,
    key: &str,
    path: Option<&str>,
) -> Result<&'a mut Value, String> {
    let Some(path) = path else { return Ok(value) };
    match value {
        Value::Table(table) => slot(table, path),
        Value::Array(values) => {
            let keyed = |(at, value)| Some((at, name(value)?.to_owned()));
            let named = values.iter().enumerate().filter_map(keyed);
            let placed = (0..values.len()).map(|at| (at, at.to_string()));
            let found = named.chain(placed).find(|(_, key)| after(path, key).is_some());
            let Some((at, own)) = found else {
                let names: Vec<&str> = values.iter().filter_map(name).collect();
                return Err(format!("{key} have no \"{path}\"; there are {}", names.join(", ")));
            };
            inside(&mut values[at], &own, after(path, &own).flatten())
        }
        _ => Err(format!("{key} has no fields")),
    }
}
