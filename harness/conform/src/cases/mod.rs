//! Families of questions that are data: entries of the files in `scenes` and `questions`. `scenes/notation.toml` explains
//! how they are written.

mod functions;
mod judges;
mod kinds;
mod notation;

use ask::Draw;
use std::sync::LazyLock;

use serde_json::{Value, json};
use toml::Table;

use super::family::Family;
use super::radiance::NAMER;
use super::values::{self, Rules, WHOLE};
use judges::judge;
use kinds::kinds;
use notation::Drawing;

/// The text of files of one of the folders.
macro_rules! files {
    ($($folder:literal: $($name:literal)*;)*) => {
        &[$($(include_str!(concat!("../../", $folder, "/", $name, ".toml"))),*),*]
    };
}

const FILES: &[&str] = files! {
    "scenes": "notation" "basics" "lights" "surfaces" "textures" "images" "mirrors" "glass" "pixels" "lamps" "paths" "pictures";
    "questions": "kinds" "optics" "lamps" "instances" "images" "meshes" "noise" "sampling" "spaces";
};

static ENTRIES: LazyLock<Vec<Entry>> =
    LazyLock::new(|| read(&FILES.concat()).expect("a test reads the files"));

/// All families of the files.
pub fn families() -> Vec<Family> {
    ENTRIES.iter().map(Entry::family).collect()
}

/// A family: an entry whose name has dots, with all that it has from others.
#[derive(Debug)]
pub struct Entry {
    /// As `radiance.mirror.ball.values`.
    pub name: String,
    fields: Table,
    rules: Rules,
}

/// The families in a text.
///
/// # Errors
/// Says which entry is wrong, and why.
pub fn read(text: &str) -> Result<Vec<Entry>, String> {
    let all: Table = text.parse().map_err(|error| format!("{error}"))?;
    let mut entries = Vec::new();
    for name in all.keys().filter(|name| name.contains('.')) {
        let fields = inherited(&all, name, 0).map_err(|problem| format!("{name}: {problem}"))?;
        let mut own = all[name].as_table().into_iter().flat_map(Table::keys);
        if let Some(key) = own.find(|key| !is_used(&fields, name, key)) {
            return Err(format!("{name}: nothing uses `{key}`"));
        }
        for words in each(&fields).map_err(|problem| format!("{name}: {problem}"))? {
            entries.push(Entry::new(name, fields.clone(), &words)?);
        }
    }
    Ok(entries)
}

/// The fields of each family that an entry is: of each kind of a list, of each table that is written, or of one.
fn each(fields: &Table) -> Result<Vec<Table>, String> {
    if let Some(list) = fields.get("kinds").and_then(toml::Value::as_str) {
        return kinds(list).ok_or_else(|| format!("no list of kinds is called `{list}`"));
    }
    let each = fields.get("each").and_then(toml::Value::as_array);
    let tables = each.map(|each| each.iter().filter_map(toml::Value::as_table).cloned().collect());
    Ok(tables.unwrap_or_else(|| vec![Table::new()]))
}

/// The fields of an entry, after those of the entry that it is in.
fn inherited(all: &Table, name: &str, depth: usize) -> Result<Table, String> {
    if depth > all.len() {
        return Err(format!("`{name}` is in itself"));
    }
    let own = all.get(name).and_then(toml::Value::as_table);
    let own = own.ok_or_else(|| format!("no entry is called `{name}`"))?;
    let mut fields = Table::new();
    let of = match own.get("in") {
        Some(toml::Value::Array(several)) => several.clone(),
        Some(one) => vec![one.clone()],
        None if name == "everything" => Vec::new(),
        None => vec!["everything".into()],
    };
    for of in of.iter().filter_map(toml::Value::as_str) {
        join(&mut fields, &inherited(all, of, depth + 1)?);
    }
    join(&mut fields, own);
    Ok(fields)
}

/// Tables whose fields are joined with those of the same table; all else takes the place of what was there.
const JOINED: [&str; 6] = ["scene", "image", "camera", "lights", "materials", "objects"];

fn join(fields: &mut Table, own: &Table) {
    for (key, value) in own {
        match (fields.get_mut(key).and_then(toml::Value::as_table_mut), value.as_table()) {
            (Some(table), Some(own)) if JOINED.contains(&&**key) => table.extend(own.clone()),
            _ => drop(fields.insert(key.clone(), value.clone())),
        }
    }
}

/// Fields that say how a family is asked.
const KEYS: [&str; 10] =
    ["in", "each", "kinds", "about", "chapter", "judge", "needed", "free", "cases", "shrunk"];

/// Whether a field says what is asked, or has its name in one that does.
fn is_used(fields: &Table, name: &str, key: &str) -> bool {
    let text = fields.to_string();
    KEYS.contains(&key)
        || name.split('.').next() == Some(key)
        || [format!("${key}"), format!("{key}?")].iter().any(|it| text.contains(it))
}

impl Entry {
    fn new(name: &str, mut fields: Table, words: &Table) -> Result<Self, String> {
        let mut name = name.to_owned();
        fields.extend(words.clone());
        for (word, value) in words.iter().filter_map(|(word, value)| Some((word, value.as_str()?)))
        {
            name = name.replace(&format!("{{{word}}}"), value);
            if let Some(toml::Value::String(about)) = fields.get_mut("about") {
                *about = about.replace(&format!("{{{word}}}"), value);
            }
        }
        for list in ["lights", "materials", "objects"] {
            let items = fields.get(list).and_then(toml::Value::as_table);
            if let Some(items) = items.map(|items| items.iter().map(listed(list)).collect()) {
                fields.insert(list.to_owned(), toml::Value::Array(items));
            }
        }
        let words = |key: &str| {
            let words = fields.get(key).and_then(toml::Value::as_array).into_iter().flatten();
            words.filter_map(toml::Value::as_str).map(str::to_owned).collect()
        };
        let rules = Rules { needed: words("needed"), free: words("free") };
        let entry = Self { name, fields, rules };
        let has = |key: &&&str| entry.fields.get(**key).is_none_or(|it| it.as_str().is_none());
        match ["about", "chapter", "judge"].iter().find(has) {
            Some(key) => Err(format!("{}: no `{key}`", entry.name)),
            None if judge(entry.word("judge"), &WHOLE).is_none() => {
                Err(format!("{}: no judge is called `{}`", entry.name, entry.word("judge")))
            }
            None => Ok(entry),
        }
    }

    fn word(&self, key: &str) -> &str {
        self.fields[key].as_str().unwrap_or_default()
    }

    /// The case of this seed and number.
    ///
    /// # Errors
    /// Says which field is wrong, and why.
    pub fn case(&self, seed: u64, index: usize) -> Result<Value, String> {
        let question = self.name.split('.').next().unwrap_or_default();
        let data = Drawing::new(&self.fields, Draw::case(seed, index)).anew(question);
        let data = data.map_err(|problem| format!("{}: {problem}", self.name))?;
        Ok(json!({question: data}))
    }

    fn family(&'static self) -> Family {
        let judge = judge(self.word("judge"), &self.rules).expect("read with the entry");
        let in_scene = ["radiance.", "trace."].iter().any(|it| self.name.starts_with(it));
        let case = |seed, index| self.case(seed, index).expect("a test draws of each family");
        Family {
            name: self.name.clone(),
            about: self.word("about").to_owned(),
            chapter: self.word("chapter"),
            ordinary: true,
            share: self.fields.get("cases").and_then(|share| json!(share).as_f64()).unwrap_or(1.0),
            cases: Box::new(move |seed, n| (0..n).map(|index| case(seed, index)).collect()),
            judge,
            namer: Some(if in_scene { NAMER } else { values::NAMER }),
            is_shrunk: self.fields.get("shrunk").and_then(toml::Value::as_bool).unwrap_or(true),
        }
    }
}

/// An item of a list in scene files: its name, and what is written of it in short.
fn listed(list: &str) -> impl Fn((&String, &toml::Value)) -> toml::Value {
    let (key, other) = match list {
        "lights" => ("source", ""),
        "materials" => ("recipe", ""),
        _ => ("shape", "material"),
    };
    move |(name, value)| {
        let mut item = Table::new();
        item.insert("name".to_owned(), name.as_str().into());
        match value {
            toml::Value::Table(fields) if fields.contains_key(key) => item.extend(fields.clone()),
            toml::Value::Array(pair) => {
                item.extend([other, key].map(str::to_owned).into_iter().zip(pair.clone()));
            }
            short => drop(item.insert(key.to_owned(), short.clone())),
        }
        toml::Value::Table(item)
    }
}
