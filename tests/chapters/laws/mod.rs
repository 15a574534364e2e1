//! Laws of light whose scenes are files that `groundtruth` and the inspector open: `tests/laws/chNN.toml`.
//!
//! An entry of that table says a law, its scene in the folder `chNN` beside the table, what the cases change in it (`set`), and
//! the formula of the radiance that arrives along the camera's ray through the middle of the picture. `let` names values for all
//! formulas, and each of the `cases` its own; `each` repeats all cases with each value of a list. Text that begins with `= ` is
//! a formula, see [`formula`]. A mean over samples with random numbers is judged by replicas, and has to be `known_to` this
//! relative standard error; what has no variance is exact.

mod closed_forms;
mod formula;

use std::collections::BTreeMap;
use std::path::PathBuf;

use serde::Deserialize;
use toml::{Table, Value};

use formula::{evaluate, filled};

use crate::prelude::*;

/// A test for each law of the table of a chapter, in which there are no others.
macro_rules! laws_of_light {
    ($chapter:literal: $($law:ident),+ $(,)?) => {
        const LAWS_OF_LIGHT: &[&str] = &[$(stringify!($law)),+];
        $(
            #[test]
            fn $law() {
                crate::laws::hold($chapter, stringify!($law), LAWS_OF_LIGHT);
            }
        )+
    };
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Laws {
    #[serde(default, rename = "let")]
    names: Table,
    law: BTreeMap<String, Law>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Law {
    says: String,
    oracle: String,
    /// Where the book says it, if it does: see `harness/tests/book.rs`.
    #[serde(rename = "book")]
    _book: Option<String>,
    scene: String,
    #[serde(default)]
    set: Table,
    #[serde(default, rename = "let")]
    names: Table,
    #[serde(default)]
    cases: Vec<Table>,
    #[serde(default)]
    each: BTreeMap<String, Vec<Value>>,
    expected: String,
    #[serde(default)]
    known_to: f64,
}

impl Law {
    fn cases(&self) -> Vec<Table> {
        let first = if self.cases.is_empty() { vec![Table::new()] } else { self.cases.clone() };
        self.each.iter().fold(first, |cases, (name, values)| {
            let with = |case: &Table, value: &Value| {
                let mut case = case.clone();
                case.insert(name.clone(), value.clone());
                case
            };
            cases
                .iter()
                .flat_map(|case| values.iter().map(move |value| with(case, value)))
                .collect()
        })
    }
}

/// A scene of the laws: its path among theirs.
pub fn scene(path: &str) -> Scene {
    scenefile::open(&folder().join(path)).unwrap_or_else(|e| panic!("{e}")).0
}

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("laws")
}

fn text(path: &Path) -> String {
    std::fs::read_to_string(path).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
}

/// Fails unless each case of this law of a chapter holds, and the chapter's table has exactly `all` these laws.
pub fn hold(chapter: &str, name: &str, all: &[&str]) {
    let table = folder().join(chapter).with_extension("toml");
    let laws: Laws = toml::from_str(&text(&table)).unwrap_or_else(|e| panic!("{e}"));
    let mut all = all.to_vec();
    all.sort_unstable();
    assert_eq!(all, laws.law.keys().collect::<Vec<_>>(), "the laws of {chapter} that have a test");
    let law = &laws.law[name];
    assert!(!law.says.is_empty() && !law.oracle.is_empty(), "{name} says no law or no oracle");
    let cases = law.cases();
    for case in &cases {
        let mut names = laws.names.clone();
        names.extend(law.names.clone());
        names.extend(case.clone());
        let scene = changed(&format!("{chapter}/{}", law.scene), &law.set, &names);
        let Viewpoint { eye, look_at, .. } = scene.camera;
        let found = replicas(&scene, |world| view(world, eye, look_at - eye));
        let expected = evaluate(&law.expected, &names).coordinates.into();
        let what = format!("{}: {}", law.scene, case.to_string().trim().replace('\n', ", "));
        assert_color(&what, &found, expected, cases.len(), law.known_to);
    }
}

/// The scene of a file, which can be opened as it is, with these values set in it.
fn changed(path: &str, set: &Table, names: &Table) -> Scene {
    World::build(&scene(path)).unwrap_or_else(|e| panic!("{path}: {e}"));
    let path = folder().join(path);
    let mut data = Value::Table(toml::from_str(&text(&path)).expect("it was opened"));
    for (at, value) in set {
        *place(&mut data, at) = filled(value, names);
    }
    let text = toml::to_string(&data).expect("it was read as TOML");
    scenefile::parse(text, &path).unwrap_or_else(|e| panic!("{names}: {e}")).0
}

/// The value at a path of fields, and of names or numbers in lists; a field that is not there becomes one.
fn place<'a>(data: &'a mut Value, path: &str) -> &'a mut Value {
    path.split('.').fold(data, |at, key| match at {
        Value::Table(fields) => fields.entry(key).or_insert_with(|| Value::Table(Table::new())),
        Value::Array(all) => {
            let is = |it: &Value| it.get("name").and_then(Value::as_str) == Some(key);
            let found = all.iter().position(is).or_else(|| key.parse().ok());
            &mut all[found.unwrap_or_else(|| panic!("{path}: nothing is named {key}"))]
        }
        other => panic!("{path}: {other} has no field {key}"),
    })
}
