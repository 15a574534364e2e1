//! Edits of a scene, as the file of mistakes says them.

use std::collections::BTreeMap;
use std::ops::{Add, Mul};

use groundtruth::math::power;
use serde::{Deserialize, Deserializer};
use serde_json::Value;

use super::called::called;
use super::places::{Fields, Place, any, inside, tracer};

/// A change of tables of a scene: where, and what is done with the fields of each. The file says what the verbs mean. A field is
/// a name, or names of tables and then of a field, or the index of an item of a list, with dots between.
#[derive(Debug, Default, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Edit {
    r#in: Place,
    #[serde(deserialize_with = "one_or_many")]
    each: Vec<String>,
    #[serde(deserialize_with = "one_or_many")]
    kind: Vec<String>,
    #[serde(deserialize_with = "one_or_many")]
    not: Vec<String>,
    #[serde(deserialize_with = "one_or_many")]
    tracer: Vec<String>,
    #[serde(deserialize_with = "one_or_many")]
    has: Vec<String>,
    r#where: BTreeMap<String, Value>,
    above: BTreeMap<String, f64>,
    set: BTreeMap<String, Value>,
    instead: BTreeMap<String, Value>,
    #[serde(deserialize_with = "one_or_many")]
    without: Vec<String>,
    times: BTreeMap<String, Amount>,
    plus: BTreeMap<String, Amount>,
    power: BTreeMap<String, Amount>,
    at_most: BTreeMap<String, Amount>,
    exchange: Option<[String; 2]>,
    like: BTreeMap<String, String>,
    toggle: BTreeMap<String, [Value; 2]>,
    reverse: Option<String>,
    call: Option<String>,
}

/// A number, or the field of the same table that has it.
#[derive(Debug, Deserialize)]
#[serde(untagged)]
enum Amount {
    Number(f64),
    Field(String),
}

/// A text, or a list of texts.
fn one_or_many<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Vec<String>, D::Error> {
    #[derive(Deserialize)]
    #[serde(untagged)]
    enum Texts {
        One(String),
        Many(Vec<String>),
    }
    Ok(match Texts::deserialize(deserializer)? {
        Texts::One(text) => vec![text],
        Texts::Many(texts) => texts,
    })
}

/// Makes all edits in a scene, in the field `scene` of a value. `None` if none changes anything.
pub fn apply(edits: &[Edit], data: &mut Value) -> Option<()> {
    any(edits.iter().filter_map(|edit| edit.apply(data)))
}

impl Edit {
    fn apply(&self, data: &mut Value) -> Option<()> {
        let fits =
            |names: &[String], name: &str| names.is_empty() || names.iter().any(|it| it == name);
        if !fits(&self.tracer, tracer(data)) {
            return None;
        }
        self.r#in.each(data, &|kind, fields| {
            if !fits(&self.kind, kind) || self.not.iter().any(|it| it == kind) {
                return None;
            }
            let whole = self.each.is_empty() || self.each == ["*"];
            let changed = if whole { self.change(fields) } else { None };
            match self.each.is_empty() {
                true => changed,
                false => changed.or_else(|| inside(fields, &self.each, &|it| self.change(it))),
            }
        })
    }

    /// Changes one table, if it is as it has to be.
    fn change(&self, fields: &mut Fields) -> Option<()> {
        let is =
            |(path, value): (&String, &Value)| get(fields, path).is_none_or(|it| same(it, value));
        let is_above = |(path, least): (&String, &f64)| {
            get(fields, path).and_then(Value::as_f64).is_some_and(|it| it > *least)
        };
        let has = |path: &String| get(fields, path).is_some();
        if !self.has.iter().all(has)
            || !self.r#where.iter().all(is)
            || !self.above.iter().all(is_above)
        {
            return None;
        }
        let changes = [
            all(&self.set, fields, set),
            all(&self.instead, fields, instead),
            any(self.without.iter().filter_map(|path| without(fields, path))),
            all(&self.times, fields, |fields, path, by| number_by(fields, path, by, Mul::mul)),
            all(&self.plus, fields, |fields, path, by| number_by(fields, path, by, Add::add)),
            all(&self.power, fields, |fields, path, by| number_by(fields, path, by, power)),
            all(&self.at_most, fields, |fields, path, by| number_by(fields, path, by, f64::min)),
            all(&self.like, fields, |fields, path, from| like(fields, path, from)),
            all(&self.toggle, fields, toggle),
            self.exchange.as_ref().and_then(|[a, b]| exchange(fields, a, b)),
            self.reverse.as_ref().and_then(|path| reverse(fields, path)),
            self.call.as_ref().and_then(|name| called(name)(fields)),
        ];
        any(changes.into_iter().flatten())
    }
}

fn all<T>(
    amounts: &BTreeMap<String, T>,
    fields: &mut Fields,
    change: impl Fn(&mut Fields, &str, &T) -> Option<()>,
) -> Option<()> {
    any(amounts.iter().filter_map(|(path, amount)| change(fields, path, amount)))
}

/// The table that has a field, and the field's name in it.
fn slot<'a, 'b>(fields: &'a mut Fields, path: &'b str) -> Option<(&'a mut Fields, &'b str)> {
    match path.split_once('.') {
        None => Some((fields, path)),
        Some((first, rest)) => slot(fields.get_mut(first)?.as_object_mut()?, rest),
    }
}

/// The value of a field, or of an item of a list.
fn get<'a>(fields: &'a Fields, path: &str) -> Option<&'a Value> {
    let mut keys = path.split('.');
    let first = fields.get(keys.next()?)?;
    keys.try_fold(first, |value, key| match value {
        Value::Array(items) => items.get(key.parse::<usize>().ok()?),
        value => value.get(key),
    })
}

/// The place of an item of a list.
fn item<'a>(fields: &'a mut Fields, path: &str) -> Option<&'a mut Value> {
    let (list, index) = path.rsplit_once('.')?;
    let (fields, name) = slot(fields, list)?;
    fields.get_mut(name)?.as_array_mut()?.get_mut(index.parse::<usize>().ok()?)
}

/// Whether two values are the same; 1 is 1.0.
fn same(a: &Value, b: &Value) -> bool {
    match (a.as_f64(), b.as_f64()) {
        (Some(a), Some(b)) => a == b,
        _ => a == b,
    }
}

/// Sets a field, if that changes it.
pub(super) fn set(fields: &mut Fields, path: &str, value: &Value) -> Option<()> {
    if get(fields, path).is_some_and(|it| same(it, value)) {
        return None;
    }
    if let Some(item) = item(fields, path) {
        *item = value.clone();
        return Some(());
    }
    let (fields, name) = slot(fields, path)?;
    fields.insert(name.to_owned(), value.clone());
    Some(())
}

/// Sets a field that is there.
pub(super) fn instead(fields: &mut Fields, path: &str, value: &Value) -> Option<()> {
    let _ = get(fields, path)?;
    set(fields, path, value)
}

pub(super) fn without(fields: &mut Fields, path: &str) -> Option<()> {
    let (fields, name) = slot(fields, path)?;
    fields.remove(name).map(|_| ())
}

fn like(fields: &mut Fields, path: &str, from: &str) -> Option<()> {
    let value = get(fields, from)?.clone();
    instead(fields, path, &value)
}

fn exchange(fields: &mut Fields, a: &str, b: &str) -> Option<()> {
    let (first, second) = (get(fields, a)?.clone(), get(fields, b)?.clone());
    set(fields, a, &second)?;
    set(fields, b, &first)
}

fn toggle(fields: &mut Fields, path: &str, [one, other]: &[Value; 2]) -> Option<()> {
    match get(fields, path)? {
        it if same(it, one) => set(fields, path, other),
        it if same(it, other) => set(fields, path, one),
        _ => None,
    }
}

fn reverse(fields: &mut Fields, path: &str) -> Option<()> {
    let (fields, name) = slot(fields, path)?;
    let items = fields.get_mut(name)?.as_array_mut()?;
    items.reverse();
    (items.len() > 1).then_some(())
}

fn number_by(fields: &mut Fields, path: &str, by: &Amount, of: fn(f64, f64) -> f64) -> Option<()> {
    let by = match by {
        Amount::Number(by) => *by,
        Amount::Field(path) => get(fields, path)?.as_f64()?,
    };
    number(fields, path, |x| of(x, by))
}

/// Changes a number, or each number of a list; of a whole number it makes a whole one where it can.
pub(super) fn number(fields: &mut Fields, path: &str, by: impl Fn(f64) -> f64) -> Option<()> {
    let one = |value: &Value| {
        let x = by(value.as_f64()?);
        let is_whole = !value.is_f64() && x == x.trunc();
        Some(if is_whole { Value::from(x as i64) } else { Value::from(x) })
    };
    let other = match get(fields, path)? {
        Value::Array(items) => Value::Array(items.iter().map(one).collect::<Option<_>>()?),
        value => one(value)?,
    };
    set(fields, path, &other)
}
