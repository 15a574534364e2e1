//! Examples: a value where a scene file has it, with the fields that must be written beside it. They
//! come from the specimens of the kinds and from the first of the commented scenes.

use std::collections::VecDeque;
use std::sync::LazyLock;

use serde::Serialize;
use serde_json::Value;

use crate::scene::vocabulary::{Choice, Definition};

/// The text of scenes/first.toml.
pub const FIRST_SCENE: &str = include_str!("../../scenes/first.toml");

/// Longer lines become a table of their own.
const LONGEST_LINE: usize = 100;

/// A key on the way from the scene to a table or list of kinds.
#[derive(Clone)]
struct Key {
    name: &'static str,
    /// Whether it holds a list of such things, as `objects` does.
    is_array: bool,
}

/// A kind, where its list first appears in a scene file.
pub fn example_of_kind(kind: &Choice, list: &Definition) -> Option<String> {
    let mut path = path_to(list)?;
    path.push(Key { name: kind.tag, is_array: false });
    written_at(&path, kind.example()?)
}

/// A table: as in the first scene, or else its own example.
pub fn example_of_table(table: &Definition) -> Option<String> {
    let path = path_to(table)?;
    match &path[..] {
        [] => None,
        [top] => Some(header(top) + &lines(table, first(top)?)),
        _ => written_at(&path, table.example()?),
    }
}

/// The shortest way from the scene to a definition.
fn path_to(wanted: &Definition) -> Option<Vec<Key>> {
    let mut seen = Vec::new();
    let mut open = VecDeque::from([(Definition::scene(), Vec::new())]);
    while let Some((definition, path)) = open.pop_front() {
        if definition.is(wanted) {
            return Some(path);
        }
        if seen.iter().any(|it| definition.is(it)) {
            continue;
        }
        seen.push(definition);
        let mut go_on = |name, is_array, content: Option<Definition>| {
            let path = [&path[..], &[Key { name, is_array }]].concat();
            open.extend(content.map(|content| (content, path)));
        };
        for field in definition.fields() {
            go_on(field.name, field.is_array(), field.content());
        }
        for choice in definition.choices() {
            go_on(choice.tag, false, choice.table());
        }
    }
    None
}

/// The value at a path, in its table with all that must be written there. `None` inside of lists in
/// other tables.
fn written_at(path: &[Key], value: &Value) -> Option<String> {
    let (top, rest) = path.split_first()?;
    if rest.iter().any(|key| key.is_array) {
        return None;
    }
    let table = Definition::scene().fields().find(|field| field.name == top.name)?.content()?;
    let names: Vec<_> = rest.iter().map(|key| key.name).collect();
    if !table.is_table() {
        return Some(format!("{}.{} = {}\n", top.name, names.join("."), toml(value)));
    }
    let mut text = header(top);
    for field in table.fields().filter(|field| field.required && field.name != names[0]) {
        text += &format!("{} = {}\n", field.name, toml(&first(top)?[field.name]));
    }
    let line = format!("{} = {}\n", names.join("."), toml(value));
    match value.as_object() {
        Some(fields) if line.chars().count() > LONGEST_LINE => {
            text += &format!("[{}.{}]\n", top.name, names.join("."));
            text.extend(fields.iter().map(|(name, value)| format!("{name} = {}\n", toml(value))));
        }
        _ => text += &line,
    }
    Some(text)
}

fn header(top: &Key) -> String {
    if top.is_array { format!("[[{}]]\n", top.name) } else { format!("[{}]\n", top.name) }
}

/// The fields that a value has, in the order of the table's declaration.
fn lines(table: &Definition, value: &Value) -> String {
    let written = |name: &str| value.get(name).map(|value| format!("{name} = {}\n", toml(value)));
    table.fields().filter_map(|field| written(field.name)).collect()
}

/// The first scene's table of this key, or the first of them.
fn first(top: &Key) -> Option<&'static Value> {
    static SCENE: LazyLock<Value> =
        LazyLock::new(|| toml::from_str(FIRST_SCENE).expect("a test reads scenes/first.toml"));
    let value = SCENE.get(top.name)?;
    if top.is_array { value.get(0) } else { Some(value) }
}

/// A value as TOML on one line.
pub fn toml(value: &Value) -> String {
    let mut text = String::new();
    match value.serialize(toml::ser::ValueSerializer::new(&mut text)) {
        Ok(_) => text,
        Err(_) => value.to_string(), // null, which has no TOML
    }
}
