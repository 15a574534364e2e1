//! Small changes of one value of a scene.

use toml::{Table, Value};

use super::fields::{Leaf, Path, Step};

/// At most so many other kinds are tried in place of one.
const OTHER_KINDS: usize = 4;

/// What stands in place of a value.
#[derive(Clone, Debug, PartialEq)]
pub enum Change {
    /// Another value.
    Value(Value),
    /// Nothing: the default counts.
    Removed,
}

/// Small changes of a leaf, to be tried in this order: numbers times 1.02 and so on, plus a pixel's side, plus 1, negative; the
/// other truth value, word, name or kind; at last nothing.
pub fn changes(leaf: &Leaf, scene: &Table) -> Vec<Change> {
    let Some(value) = at(scene, &leaf.path) else { return Vec::new() };
    let pixel = scene["image"].get("pixel_size").and_then(Value::as_float).unwrap_or(1.0);
    let mut values = match value {
        Value::Float(x) => {
            let all = [1.02 * x, x + pixel, 0.98 * x, x + 1.0, x - 1.0, 0.5 * x, -x];
            all.map(Value::Float).to_vec()
        }
        Value::Integer(n) => [n + 1, n - 1].map(Value::Integer).to_vec(),
        Value::Boolean(it) => vec![Value::Boolean(!it)],
        Value::String(text) if leaf.is_label() => vec![Value::String(format!("{text}'"))],
        Value::String(_) if leaf.choices.is_empty() => names(scene),
        _ => leaf.choices.iter().take(OTHER_KINDS).cloned().collect(),
    };
    values.retain(|other| other != value);
    let removed = leaf.is_optional.then_some(Change::Removed);
    values.into_iter().map(Change::Value).chain(removed).collect()
}

/// The names of the scene's first materials and objects: another one of them may stand where a name stands.
fn names(scene: &Table) -> Vec<Value> {
    let of = |list: &str| {
        let items = scene.get(list).and_then(Value::as_array).into_iter().flatten();
        items.filter_map(|item| item.get("name").cloned()).take(OTHER_KINDS)
    };
    of("materials").chain(of("objects")).collect()
}

/// The value at a path.
fn at<'a>(scene: &'a Table, path: &Path) -> Option<&'a Value> {
    let (first, rest) = path.split_first()?;
    let Step::Field(first) = first else { return None };
    rest.iter().try_fold(scene.get(first)?, |value, step| match step {
        Step::Field(name) => value.get(name),
        Step::Item(index) => value.get(*index),
    })
}

/// The scene with this change of a leaf.
pub fn changed(scene: &Table, path: &Path, change: &Change) -> Table {
    let mut whole = Value::Table(scene.clone());
    let Some((last, before)) = path.split_last() else { return scene.clone() };
    let inner = before.iter().try_fold(&mut whole, |value, step| match step {
        Step::Field(name) => value.get_mut(name),
        Step::Item(index) => value.get_mut(*index),
    });
    match (inner, last, change) {
        (Some(Value::Table(table)), Step::Field(name), Change::Value(value)) => {
            table.insert(name.clone(), value.clone());
        }
        (Some(Value::Table(table)), Step::Field(name), Change::Removed) => {
            table.remove(name);
        }
        (Some(Value::Array(items)), Step::Item(index), Change::Value(value)) => {
            items[*index] = value.clone();
        }
        _ => {}
    }
    match whole {
        Value::Table(table) => table,
        _ => scene.clone(),
    }
}
