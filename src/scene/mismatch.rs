//! Lists where a table is meant, and tables where a list of tables is meant. The reader reports these at another
//! value, as it knows the types of values but not what the header of a table meant.

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::locations::name;
use super::vocabulary::{Choice, Definition, Field};
use crate::invalid::Key;

/// The first of them.
pub(super) struct Mismatch {
    /// The path of the value.
    pub path: Vec<Key>,
    /// The byte offset of its key.
    pub at: usize,
    /// What was found and what to write.
    pub problem: String,
}

/// The first mismatch of a document.
pub(super) fn first(document: &Spanned<DeValue<'_>>) -> Option<Mismatch> {
    let DeValue::Table(table) = document.as_ref() else { return None };
    inside(table, Definition::scene(), &mut Vec::new())
}

/// What the schema says of a key.
enum Entry {
    Field(Field),
    Kind(Choice),
}

impl Entry {
    fn of(definition: &Definition, key: &str) -> Option<Self> {
        if definition.is_list() {
            let kind = definition.choices().into_iter().find(|choice| choice.tag == key);
            return kind.map(Self::Kind);
        }
        definition.fields().find(|field| field.name == key).map(Self::Field)
    }

    fn can_be(&self, kind: &str) -> bool {
        match self {
            Self::Field(field) => field.can_be(kind),
            Self::Kind(choice) => choice.can_be(kind),
        }
    }

    fn content(&self) -> Option<Definition> {
        match self {
            Self::Field(field) => field.content(),
            Self::Kind(choice) => choice.table(),
        }
    }
}

fn inside(table: &DeTable<'_>, definition: Definition, path: &mut Vec<Key>) -> Option<Mismatch> {
    for (key, value) in table {
        let key_name: &str = key.get_ref();
        let Some(entry) = Entry::of(&definition, key_name) else { continue };
        let Some(content) = entry.content() else { continue };
        path.push(key_name.into());
        let found = match value.get_ref() {
            DeValue::Array(_) if !entry.can_be("array") => Some(format!(
                "found a list, but a table is needed: write {}",
                as_table(key_name, path, &content)
            )),
            DeValue::Table(_) if !entry.can_be("object") => Some(format!(
                "found a table, but a list is needed: write {}",
                as_list(key_name, path)
            )),
            _ => None,
        };
        let mismatch = match (found, value.get_ref()) {
            (Some(problem), _) => {
                Some(Mismatch { path: path.clone(), at: key.span().start, problem })
            }
            (None, DeValue::Table(table)) => inside(table, content, path),
            (None, DeValue::Array(array)) => (0..).zip(array).find_map(|(index, element)| {
                let DeValue::Table(table) = element.get_ref() else { return None };
                path.push(Key::Item(index, name(element.get_ref())));
                let found = inside(table, content, path);
                path.pop();
                found
            }),
            _ => None,
        };
        path.pop();
        if mismatch.is_some() {
            return mismatch;
        }
    }
    None
}

/// How a table is written.
fn as_table(name: &str, path: &[Key], content: &Definition) -> String {
    match content.fields().next() {
        Some(_) if path.len() == 1 => format!("`[{name}]`"),
        Some(field) => format!("`{name} = {{ {} = … }}`", field.name),
        None => format!("`{name} = {{ kind = {{ … }} }}`"),
    }
}

/// How a list of tables is written.
fn as_list(name: &str, path: &[Key]) -> String {
    match path.len() {
        1 => format!("`[[{name}]]` for each of them"),
        _ => format!("`{name} = [{{ … }}, …]`"),
    }
}
