//! The fields that a scene says, and where it says them.

use std::collections::BTreeSet;

use groundtruth::scene::vocabulary::{Choice, Definition, Field};
use serde_json::Value as Json;
use toml::{Table, Value};

/// Where a value stands: fields, and indices of lists.
pub type Path = Vec<Step>;

/// One step of the way to a value.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Step {
    /// To the value of this field.
    Field(String),
    /// To this element of a list.
    Item(usize),
}

/// A value of a scene that can be changed by itself.
#[derive(Clone, Debug)]
pub struct Leaf {
    /// The field, by the kind or table that it belongs to: `material phong.exponent`, `image.filter`, `scene.epsilon`; of a
    /// kind itself its name, `material phong`.
    pub field: String,
    /// Where it stands.
    pub path: Path,
    /// The other words or kinds that may stand there.
    pub choices: Vec<Value>,
    /// Whether the field has a default, which counts if it is left out.
    pub is_optional: bool,
}

impl Leaf {
    /// Whether it is a text for people or a name by which others call its table.
    pub fn is_label(&self) -> bool {
        self.field.ends_with(".name") || self.field == "scene.about"
    }
}

/// The leaves of a scene that differ from their defaults: a program that ignores the others draws the same picture.
pub fn leaves(scene: &Table) -> Vec<Leaf> {
    let mut leaves = Leaves(Vec::new());
    leaves.table(Definition::scene(), "scene", scene, &Vec::new());
    leaves.0
}

/// The name of a kind of a list: `material phong`.
fn kind_name(list: &Definition, tag: &str) -> String {
    format!("{} {tag}", list.title().trim_end_matches('s'))
}

/// The fields and kinds that scene files may have, by the names of leaves; without kinds that are the default of a field.
pub fn vocabulary() -> BTreeSet<String> {
    let mut names = Names::default();
    names.table(Definition::scene(), "scene");
    names.all.difference(&names.defaults).cloned().collect()
}

/// Names found on the way through the schema.
#[derive(Default)]
struct Names {
    all: BTreeSet<String>,
    defaults: BTreeSet<String>,
    entered: BTreeSet<String>,
}

impl Names {
    fn table(&mut self, of: Definition, owner: &str) {
        if !self.entered.insert(owner.to_owned()) {
            return;
        }
        for field in of.fields() {
            let is_plain = field.content().is_none()
                || field.can_be("number")
                || field.can_be("array") && field.elements_can_be("number");
            if is_plain {
                self.all.insert(format!("{owner}.{}", field.name));
            }
            let Some(content) = field.content() else { continue };
            if content.is_table() {
                self.table(content, &content.title());
                continue;
            }
            let tag = field.default().and_then(|default| match default {
                Json::String(tag) => Some(tag),
                default => default.as_object()?.keys().next(),
            });
            self.defaults.extend(tag.map(|tag| kind_name(&content, tag)));
            for choice in content.choices() {
                let name = kind_name(&content, choice.tag);
                if let Some(table) = choice.table() {
                    self.table(table, &name);
                }
                self.all.insert(name);
            }
        }
    }
}

struct Leaves(Vec<Leaf>);

impl Leaves {
    /// The leaves of a table of this definition, which is called `owner`.
    fn table(&mut self, of: Definition, owner: &str, table: &Table, path: &Path) {
        let fields: Vec<Field> = of.fields().collect();
        for (key, value) in table {
            let field = fields.iter().find(|field| field.name == key);
            if field.and_then(Field::default).is_some_and(|default| is_same(default, value)) {
                continue;
            }
            let inner = with(path, Step::Field(key.clone()));
            let name = format!("{owner}.{key}");
            let words = field.map_or_else(Vec::new, |field| words(&field.values()));
            let is_optional = field.is_some_and(|field| !field.required);
            let leaf = Leaf { field: name, path: inner, choices: words, is_optional };
            self.value(field.and_then(Field::content), value, leaf);
        }
    }

    /// The leaves of a value of this definition; `leaf` is the value itself, if it is one.
    fn value(&mut self, of: Option<Definition>, value: &Value, leaf: Leaf) {
        match (value, of) {
            (Value::Array(items), _) => {
                for (index, item) in items.iter().enumerate() {
                    let path = with(&leaf.path, Step::Item(index));
                    // an element has no default
                    self.value(of, item, Leaf { path, is_optional: false, ..leaf.clone() });
                }
            }
            (Value::Table(table), Some(list)) if list.is_list() => {
                let Some((tag, content)) = table.iter().next() else { return };
                let name = kind_name(&list, tag);
                let choices = others(&list, tag);
                let (path, is_optional) = (leaf.path.clone(), leaf.is_optional);
                self.0.push(Leaf { field: name.clone(), path, choices, is_optional });
                let path = with(&leaf.path, Step::Field(tag.clone()));
                let choice = list.choices().into_iter().find(|choice| choice.tag == tag);
                let inner = choice.as_ref().and_then(Choice::table);
                match (content, inner) {
                    (Value::Table(table), Some(of)) => self.table(of, &name, table, &path),
                    _ => {
                        let choices = choice.and_then(|choice| choice.values());
                        let choices = choices.map_or_else(Vec::new, |values| words(&values));
                        let leaf = Leaf { field: name, path, choices, is_optional: false };
                        self.value(inner, content, leaf);
                    }
                }
            }
            (Value::Table(table), Some(of)) => self.table(of, &of.title(), table, &leaf.path),
            (Value::Table(table), None) => {
                for (key, item) in table {
                    let path = with(&leaf.path, Step::Field(key.clone()));
                    self.value(None, item, Leaf { path, ..leaf.clone() });
                }
            }
            (Value::String(tag), Some(list)) if list.is_list() => {
                self.0.push(Leaf {
                    field: kind_name(&list, tag),
                    choices: others(&list, tag),
                    ..leaf
                });
            }
            _ => self.0.push(leaf),
        }
    }
}

fn with(path: &Path, step: Step) -> Path {
    path.iter().cloned().chain([step]).collect()
}

/// The words that a value may be, if there is a choice of words: those in quotes.
fn words(values: &str) -> Vec<Value> {
    let quoted = values.split('`').skip(1).step_by(2);
    quoted.map(|word| Value::String(word.trim_matches('"').to_owned())).collect()
}

/// Other kinds of a list than this one, with their examples; of textures first a single grey.
fn others(list: &Definition, tag: &str) -> Vec<Value> {
    let grey = (list.title() == "textures").then(|| Value::Array(vec![Value::Float(0.5); 3]));
    let choices = list.choices().into_iter().filter(|choice| choice.tag != tag);
    let others = choices.filter_map(|choice| {
        let word = || Some(Value::String(choice.tag.to_owned()));
        if choice.values().is_none() {
            return word();
        }
        let content = Value::try_from(choice.example()?).ok()?;
        Some(Value::Table(Table::from_iter([(choice.tag.to_owned(), content)])))
    });
    grey.into_iter().chain(others).collect()
}

/// Whether a value is this default.
fn is_same(default: &Json, value: &Value) -> bool {
    match (default, value) {
        (Json::Number(a), Value::Integer(b)) => a.as_f64() == Some(*b as f64),
        (Json::Number(a), Value::Float(b)) => a.as_f64() == Some(*b),
        (Json::Array(a), Value::Array(b)) => {
            a.len() == b.len() && a.iter().zip(b).all(|(a, b)| is_same(a, b))
        }
        (Json::Object(a), Value::Table(b)) => {
            a.len() == b.len() && a.iter().all(|(key, a)| b.get(key).is_some_and(|b| is_same(a, b)))
        }
        (Json::String(a), Value::String(b)) => a == b,
        (Json::Bool(a), Value::Boolean(b)) => a == b,
        _ => false,
    }
}
