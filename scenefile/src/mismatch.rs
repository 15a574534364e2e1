//! Lists where a table is meant, and tables where a list of tables is meant. The reader reports
//! these at another value, as it knows the types of values but not what the header of a table
//! meant; or it takes a list for a table.

use groundtruth::invalid::Key;
use toml::Spanned;
use toml::de::{DeArray, DeTable, DeValue};

use super::locations::name;
use super::vocabulary::{Choice, Definition, Field};

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

    /// Whether an element of its value, a list, can be a value of this type of JSON.
    fn elements_can_be(&self, kind: &str) -> bool {
        match self {
            Self::Field(field) => field.elements_can_be(kind),
            Self::Kind(choice) => choice.elements_can_be(kind),
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
            (None, DeValue::Array(array)) => {
                let as_list = as_list(key_name, path);
                let problem = format!("found a list, but a table is needed: write {as_list}");
                let problem = (!entry.elements_can_be("array")).then_some(problem);
                elements(array, content, path, problem.as_deref())
            }
            _ => None,
        };
        path.pop();
        if mismatch.is_some() {
            return mismatch;
        }
    }
    None
}

/// The first mismatch of the elements of a list; an element that is a list itself has this problem.
fn elements(
    array: &DeArray<'_>,
    content: Definition,
    path: &mut Vec<Key>,
    of_list: Option<&str>,
) -> Option<Mismatch> {
    (0..).zip(array).find_map(|(index, element)| {
        path.push(Key::Item(index, name(element.get_ref())));
        let found = match element.get_ref() {
            DeValue::Table(table) => inside(table, content, path),
            DeValue::Array(_) => of_list.map(|problem| Mismatch {
                path: path.clone(),
                at: element.span().start,
                problem: problem.to_owned(),
            }),
            _ => None,
        };
        path.pop();
        found
    })
}

/// How a table is written.
fn as_table(name: &str, path: &[Key], content: &Definition) -> String {
    match content.fields().next() {
        Some(_) if path.len() == 1 => format!("`[{name}]`"),
        Some(field) => format!("`{name} = {{ {} = … }}`", field.name),
        None if content.is_table() => format!("`{name} = {{}}`"),
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
