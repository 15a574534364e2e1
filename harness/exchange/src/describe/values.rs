//! The data of a scene as lines of text: every field with its value, also where it is the default.

use serde_json::{Map, Value};

use scenefile::vocabulary::Definition;

use super::page::DescriptionPage;
use super::words::Words;
pub(super) use crate::export::number as shown;

/// Fields that change only the time, not the picture.
const WITHOUT_EFFECT: &[&str] = &["accel"];

/// The fields of a table that change the picture.
pub fn is_described(field: &str) -> bool {
    !WITHOUT_EFFECT.contains(&field)
}

/// Writes values to a page, and notes the kinds and tables that they use.
#[derive(Debug, Default)]
pub struct DescribedValues {
    /// The text so far.
    pub page: DescriptionPage,
    /// What has been used so far.
    pub words: Words,
}

impl DescribedValues {
    /// The fields of a table, each on a line. One that is missing has its default; one that is missing and
    /// has no default is left out.
    pub fn fields(&mut self, indent: usize, table: Definition, value: &Value) {
        self.words.table(table);
        self.fields_of(indent, table, value);
    }

    fn fields_of(&mut self, indent: usize, table: Definition, value: &Value) {
        for field in table.fields().filter(|field| is_described(field.name)) {
            if let Some(value) = value.get(field.name).or(field.default()) {
                self.value(indent, field.name, value, field.content());
            }
        }
    }

    /// One value; `content` is the table or list of kinds that it may be of.
    pub fn value(&mut self, indent: usize, name: &str, value: &Value, content: Option<Definition>) {
        match (content, value) {
            (Some(list), Value::String(tag)) if list.is_list() => {
                self.kind(indent, name, list, tag, &Value::Null);
            }
            (Some(list), Value::Object(kind)) if list.is_list() => {
                for (tag, value) in kind {
                    self.kind(indent, name, list, tag, value);
                }
            }
            (Some(table), Value::Object(_)) => {
                self.page.line(indent, &format!("{name}:"));
                self.fields(indent + 2, table, value);
            }
            (Some(_), Value::Array(items)) if items.iter().any(has_words) => {
                self.page.line(indent, &format!("{name}, in order:"));
                for (number, item) in (1..).zip(items) {
                    self.value(indent + 2, &format!("({number})"), item, content);
                }
            }
            (_, Value::Object(entries)) => self.entries(indent, name, entries),
            _ => self.page.line(indent, &format!("{name} = {}", plain(value))),
        }
    }

    /// A table whose keys are names that the scene chooses.
    fn entries(&mut self, indent: usize, name: &str, entries: &Map<String, Value>) {
        self.page.line(indent, &format!("{name}:"));
        for (key, value) in entries {
            self.page.line(indent + 2, &format!("{key} = {}", plain(value)));
        }
    }

    fn kind(&mut self, indent: usize, name: &str, list: Definition, tag: &str, value: &Value) {
        self.words.kind(list, tag);
        let choice = list.choices().into_iter().find(|choice| choice.tag == tag);
        match choice.and_then(|choice| choice.table()) {
            Some(table) => {
                self.page.line(indent, &format!("{name}: {tag}"));
                self.fields_of(indent + 2, table, value);
            }
            None if value.is_null() => self.page.line(indent, &format!("{name}: {tag}")),
            None => self.page.line(indent, &format!("{name}: {tag} = {}", plain(value))),
        }
    }
}

/// Whether the item of a list is a table or a name of a kind, and not a row of numbers.
fn has_words(item: &Value) -> bool {
    item.is_object() || item.is_string()
}

/// A value without names in it.
pub fn plain(value: &Value) -> String {
    match value {
        Value::Array(items) => {
            let items: Vec<_> = items.iter().map(plain).collect();
            format!("[{}]", items.join(", "))
        }
        Value::Bool(true) => "yes".to_owned(),
        Value::Bool(false) => "no".to_owned(),
        Value::Number(number) => match number.as_f64() {
            Some(real) if number.is_f64() => shown(real),
            _ => number.to_string(),
        },
        Value::String(text) => format!("{text:?}"),
        _ => value.to_string(),
    }
}

/// Coordinates, as `[1, 2, 3]`.
pub fn row(numbers: [f64; 3]) -> String {
    format!("[{}]", numbers.map(shown).join(", "))
}
