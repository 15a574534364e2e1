//! The vocabulary of scene files: the tables, lists of kinds, fields and types of the [`schema()`].

use groundtruth::invalid::Key;
use groundtruth::kinds::tag;
use groundtruth::math::DIMENSION;
use serde_json::{Map, Value};

use super::schema::schema;

/// A named part of the schema: a table with fields, a list of kinds, or a plain value.
#[derive(Clone, Copy, Debug)]
pub struct Definition {
    /// The name in the schema, or the tag of a kind.
    pub name: &'static str,
    schema: &'static Value,
}

/// A field of a table.
#[derive(Clone, Copy, Debug)]
pub struct Field {
    /// The name in scene files.
    pub name: &'static str,
    /// Whether it has no default.
    pub required: bool,
    schema: &'static Value,
}

/// One of the kinds of a list.
#[derive(Clone, Copy, Debug)]
pub struct Choice {
    /// The name in scene files.
    pub tag: &'static str,
    /// `None` for a kind that is written as a string.
    content: Option<&'static Value>,
    schema: &'static Value,
}

impl Definition {
    /// The table that is the whole file.
    pub fn scene() -> Self {
        Self { name: "Scene", schema: schema() }
    }

    /// All definitions, the scene first.
    pub fn all() -> impl Iterator<Item = Self> {
        let others = entries(schema(), "definitions");
        std::iter::once(Self::scene())
            .chain(others.map(|(name, schema)| Self { name: name.as_str(), schema }))
    }

    /// The name in the documentation; plural for lists of kinds.
    pub fn title(&self) -> String {
        match self.schema["title"].as_str() {
            Some(title) if self.is_list() => title.to_owned(),
            _ => tag(self.name).replace('_', " "),
        }
    }

    /// The doc comment.
    pub fn description(&self) -> &'static str {
        self.schema["description"].as_str().unwrap_or_default()
    }

    /// The fields of a table, in the order of its declaration.
    pub fn fields(&self) -> impl Iterator<Item = Field> {
        let required = self.schema["required"].as_array();
        let is_required =
            move |name: &str| required.is_some_and(|all| all.iter().any(|it| it == name));
        let fields = entries(self.schema, "properties").filter(|_| !self.is_list());
        fields.map(move |(name, schema)| Field { name, required: is_required(name), schema })
    }

    /// The kinds of a list: the keys of a table that has exactly one, or the variants of an enum.
    pub fn choices(&self) -> Vec<Choice> {
        if self.schema["maxProperties"] == 1 {
            let kinds = entries(self.schema, "properties");
            return kinds
                .map(|(tag, schema)| Choice { tag, content: Some(schema), schema })
                .collect();
        }
        let variants = self.schema["oneOf"].as_array().into_iter().flatten();
        let choice = |schema: &'static Value| {
            if let Some(tag) = schema["const"].as_str() {
                return Some(Choice { tag, content: None, schema });
            }
            let (tag, content) = entries(schema, "properties").next()?;
            Some(Choice { tag, content: Some(content), schema })
        };
        variants.filter_map(choice).collect()
    }

    /// Whether both are the same part of the schema.
    pub fn is(&self, other: &Self) -> bool {
        std::ptr::eq(self.schema, other.schema)
    }

    /// Whether it is a plain value, such as a colour or a point: no table and no list of kinds.
    pub fn is_value(&self) -> bool {
        !self.is_table() && !self.is_list()
    }

    /// Whether it is a list of kinds.
    pub fn is_list(&self) -> bool {
        self.schema["maxProperties"] == 1 || self.schema.get("oneOf").is_some()
    }

    /// Whether it is a table with fields, perhaps with none.
    pub fn is_table(&self) -> bool {
        self.schema["type"] == "object" && !self.is_list()
    }

    /// An example of a table on its own.
    pub fn example(&self) -> Option<&'static Value> {
        self.schema["examples"].as_array()?.first()
    }

    /// The definition of the value of this key, if the table or list has the key.
    fn inside(&self, key: &str) -> Option<Self> {
        if self.is_list() {
            return self.choices().into_iter().find(|choice| choice.tag == key)?.table();
        }
        self.fields().find(|field| field.name == key)?.content()
    }

    /// The innermost table, list or kind on a path.
    pub fn at(path: &[Key]) -> Self {
        let keys = path.iter().filter_map(|key| match key {
            Key::Field(name) => Some(name.as_str()),
            Key::Item(..) => None,
        });
        let mut inner = Self::scene();
        for key in keys {
            let Some(next) = inner.inside(key) else { break };
            inner = next;
        }
        inner
    }
}

impl Field {
    /// The doc comment.
    pub fn description(&self) -> &'static str {
        self.schema["description"].as_str().unwrap_or_default()
    }

    /// The default, if it is a value.
    pub fn default(&self) -> Option<&'static Value> {
        self.schema.get("default")
    }

    /// The type of its value, in words, and its unit.
    pub fn values(&self) -> String {
        values(self.schema)
    }

    /// The table or list of kinds of its value, or of the elements if it is a list.
    pub fn content(&self) -> Option<Definition> {
        content(self.schema)
    }

    /// Whether its value is a list.
    pub fn is_array(&self) -> bool {
        self.schema["type"] == "array"
    }

    /// Whether it can be a value of this type of JSON, such as `array` or `object`.
    pub fn can_be(&self, kind: &str) -> bool {
        can_be(self.schema, kind)
    }

    /// Whether an element of its value, a list, can be a value of this type of JSON.
    pub fn elements_can_be(&self, kind: &str) -> bool {
        elements_can_be(self.schema, kind)
    }

    /// The range of a whole number, if both of its ends are known.
    pub fn range(&self) -> Option<[u64; 2]> {
        Some([self.schema["minimum"].as_u64()?, self.schema["maximum"].as_u64()?])
    }
}

impl Choice {
    /// The chapter that introduces it, such as `ch19`.
    pub fn chapter(&self) -> Option<&'static str> {
        self.schema["x-chapter"].as_str()
    }

    /// The doc comment: its own, or that of its table.
    pub fn description(&self) -> &'static str {
        let own = self.schema["description"].as_str();
        own.or(self.table().map(|table| table.description())).unwrap_or_default()
    }

    /// The type of the value after the tag, in words; `None` for a kind that is written as a
    /// string.
    pub fn values(&self) -> Option<String> {
        self.content.map(values)
    }

    /// The table after the tag, named like the tag.
    pub fn table(&self) -> Option<Definition> {
        let schema = self.content?;
        if schema["type"] == "object" {
            return Some(Definition { name: self.tag, schema });
        }
        let table = content(schema).filter(Definition::is_table)?;
        Some(Definition { name: self.tag, ..table })
    }

    /// Whether the value after the tag can be of this type of JSON.
    pub fn can_be(&self, kind: &str) -> bool {
        self.content.is_some_and(|schema| can_be(schema, kind))
    }

    /// Whether an element of that value, a list, can be of this type of JSON.
    pub fn elements_can_be(&self, kind: &str) -> bool {
        self.content.is_some_and(|schema| elements_can_be(schema, kind))
    }

    /// An example of the value after the tag.
    pub fn example(&self) -> Option<&'static Value> {
        let own = self.schema["examples"].as_array().and_then(|all| all.first());
        own.or_else(|| self.table()?.example())
    }
}

/// The entries of a keyword that is a table.
fn entries(
    schema: &'static Value,
    keyword: &str,
) -> impl Iterator<Item = (&'static String, &'static Value)> + use<> {
    schema[keyword].as_object().into_iter().flat_map(Map::iter)
}

/// The definition that a `$ref` names.
fn named(schema: &'static Value) -> Option<Definition> {
    let name = schema["$ref"].as_str()?.rsplit('/').next()?;
    Some(Definition { name, schema: self::schema()["definitions"].get(name)? })
}

/// The subschemas of `allOf` and `anyOf`.
fn parts(schema: &'static Value) -> impl Iterator<Item = &'static Value> {
    let of = |keyword| schema[keyword].as_array().into_iter().flatten();
    of("allOf").chain(of("anyOf"))
}

/// Whether a value of this schema can be of this type of JSON; `true` if it says nothing.
fn can_be(schema: &'static Value, kind: &str) -> bool {
    if let Some(definition) = named(schema) {
        return can_be(definition.schema, kind);
    }
    let variants = schema["oneOf"].as_array().into_iter().flatten();
    let mut all = parts(schema).chain(variants).peekable();
    match schema["type"].as_str() {
        Some(of) => of == kind,
        None => all.peek().is_none() || all.any(|part| can_be(part, kind)),
    }
}

/// Whether an element of a list of this schema can be a value of this type of JSON; `true` if it
/// says nothing.
fn elements_can_be(schema: &'static Value, kind: &str) -> bool {
    if let Some(definition) = named(schema) {
        return elements_can_be(definition.schema, kind);
    }
    match schema.get("items") {
        Some(items) => can_be(items, kind),
        None => {
            let mut lists = parts(schema).filter(|part| can_be(part, "array")).peekable();
            lists.peek().is_none() || lists.any(|part| elements_can_be(part, kind))
        }
    }
}

/// The table or list of kinds of a value of this schema, or of its elements.
fn content(schema: &'static Value) -> Option<Definition> {
    if let Some(definition) = named(schema) {
        let found = definition.is_table() || definition.is_list();
        return if found { Some(definition) } else { content(definition.schema) };
    }
    parts(schema).chain(schema.get("items")).find_map(content)
}

/// The type of a schema's values, in words, with the unit as in `number [1/length]`.
fn values(schema: &'static Value) -> String {
    match schema[DIMENSION].as_str() {
        Some("1") | None => type_of(schema),
        Some(dimension) => format!("{} [{dimension}]", type_of(schema)),
    }
}

fn type_of(schema: &'static Value) -> String {
    if let Some(definition) = named(schema) {
        return values_of(&definition);
    }
    let alternatives: Vec<_> = parts(schema).map(values).collect();
    if !alternatives.is_empty() {
        return alternatives.join(" or ");
    }
    match schema["type"].as_str() {
        Some("array") => {
            let each = schema.get("items").map(values).unwrap_or_default();
            match schema["minItems"].as_u64() {
                Some(count) => format!("list of {count}, each a {each}"),
                None => format!("list, each {each}"),
            }
        }
        Some("boolean") => "true or false".to_owned(),
        Some("integer") => "whole number".to_owned(),
        Some("object") => match schema.get("additionalProperties").filter(|it| it.is_object()) {
            Some(each) => format!("table, each entry {}", values(each)),
            None => "table".to_owned(),
        },
        Some("string") => "text".to_owned(),
        Some(other) => other.to_owned(),
        None => String::new(),
    }
}

fn values_of(definition: &Definition) -> String {
    let title = definition.title();
    if let Some(words) = definition.schema["enum"].as_array() {
        let words = words.iter().map(|word| format!("`{word}`"));
        return words.collect::<Vec<_>>().join(" or ");
    }
    let texts: Option<Vec<_>> = definition
        .choices()
        .iter()
        .map(|choice| choice.content.is_none().then(|| format!("`\"{}\"`", choice.tag)))
        .collect();
    match texts {
        Some(texts) if definition.is_list() => texts.join(" or "),
        _ if definition.is_list() => format!("one of the {title}"),
        _ if definition.is_table() => format!("table `{title}`"),
        _ => title,
    }
}
