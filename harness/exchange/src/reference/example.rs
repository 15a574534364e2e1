//! Examples: a value where a scene file has it, with the fields that must be written beside it.
//! They come from the specimens of the kinds and from the first of the commented scenes.

use std::collections::VecDeque;
use std::sync::LazyLock;

use scenefile::vocabulary::{Choice, Definition};
use serde::Serialize;
use serde_json::{Value, json};

/// The text of scenes/first.toml.
pub(super) const FIRST_SCENE: &str = include_str!("../../../../scenes/first.toml");

/// Longer lines become a table of their own.
const LONGEST_LINE: usize = 100;

/// A key on the way from the scene to a table or list of kinds.
#[derive(Clone)]
struct Key {
    name: &'static str,
    /// Whether it holds a list of such things, as `objects` does.
    is_array: bool,
    /// Of the tag of a kind, what may follow it.
    example: Option<&'static Value>,
}

/// A kind, where its list first appears in a scene file.
pub fn example_of_kind(kind: &Choice, list: &Definition) -> Option<String> {
    let mut path = path_to(list)?;
    path.push(Key { name: kind.tag, is_array: false, example: None });
    written_at(&path, kind.example()?.clone())
}

/// A table: as in the first scene, or else its own example.
pub fn example_of_table(table: &Definition) -> Option<String> {
    let path = path_to(table)?;
    match &path[..] {
        [] => None,
        [top] => Some(header(top) + &lines(table, first(top)?)),
        _ => written_at(&path, table.example()?.clone()),
    }
}

/// Where scene files have a table or list of kinds, as "as `sampler` in `[image]`".
pub fn home_of(definition: &Definition) -> Option<String> {
    let path = path_to(definition)?;
    let (top, rest) = path.split_first()?;
    if rest.is_empty() {
        return Some(format!("as `{}`", top.name));
    }
    let names: Vec<_> = rest.iter().map(|key| key.name).collect();
    Some(format!("as `{}` in `{}`", names.join("."), header(top).trim_end()))
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
        let mut go_on = |key: Key, content: Option<Definition>| {
            open.extend(content.map(|content| (content, [&path[..], &[key]].concat())));
        };
        for field in definition.fields() {
            let key = Key { name: field.name, is_array: field.is_array(), example: None };
            go_on(key, field.content());
        }
        for kind in definition.choices() {
            go_on(Key { name: kind.tag, is_array: false, example: kind.example() }, kind.table());
        }
    }
    None
}

/// The value at a path, in its table with all that must be written there. `None` inside of lists in
/// other tables.
fn written_at(path: &[Key], value: Value) -> Option<String> {
    let (top, rest) = path.split_first()?;
    if rest.iter().any(|key| key.is_array) {
        return None;
    }
    let (names, value) = inside_of_kinds(rest, value);
    let keys = names.join(".");
    let table = Definition::scene().fields().find(|field| field.name == top.name)?.content()?;
    if !table.is_table() {
        return Some(format!("{}.{keys} = {}\n", top.name, toml(&value)));
    }
    let mut text = header(top);
    for field in table.fields().filter(|field| field.required && field.name != names[0]) {
        let value = match rest.last() {
            Some(kind) if field.name == "name" => kind.name.into(),
            _ => first(top)?[field.name].clone(),
        };
        text += &format!("{} = {}\n", field.name, toml(&value));
    }
    let line = format!("{keys} = {}\n", toml(&value));
    match value.as_object() {
        Some(fields) if line.chars().count() > LONGEST_LINE => {
            text += &format!("[{}.{keys}]\n", top.name);
            text.extend(fields.iter().map(|(name, value)| format!("{name} = {}\n", toml(value))));
        }
        _ => text += &line,
    }
    Some(text)
}

/// A value at the end of these keys as the value of the first of them: a kind on the way has the
/// other fields of its example, without which a material would be black.
fn inside_of_kinds(keys: &[Key], value: Value) -> (Vec<&'static str>, Value) {
    let mut names: Vec<_> = keys.iter().map(|key| key.name).collect();
    let Some(kind) = keys.iter().position(|key| key.example.is_some()) else {
        return (names, value);
    };
    let inner = names[kind + 2..].iter().rev().fold(value, |inner, &name| json!({ name: inner }));
    let mut outer = keys[kind].example.cloned().unwrap_or_default();
    outer[names[kind + 1]] = inner;
    names.truncate(kind + 1);
    (names, outer)
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
