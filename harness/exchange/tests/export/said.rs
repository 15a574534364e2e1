//! What each target refuses of a scene and what it writes of the scene beside it: the laws of `said.toml`.

use std::collections::BTreeMap;
use std::path::Path;

use exchange::export::{Target, Term};
use groundtruth::scene::Scene;
use toml::{Table, Value};

/// A scene and what is expected of it, by the names of the file.
#[derive(Clone)]
pub struct Case(Table);

impl Case {
    /// With later entries: tables are united.
    fn with(&self, later: &Table) -> Self {
        let mut all = self.0.clone();
        for (name, value) in later {
            match (all.get_mut(name), value) {
                (Some(Value::Table(before)), Value::Table(more)) => before.extend(more.clone()),
                _ => drop(all.insert(name.clone(), value.clone())),
            }
        }
        Self(all)
    }

    /// A text with the entries that it names in braces.
    pub fn filled(&self, text: &str) -> String {
        let is_name = |it: &str| {
            !it.is_empty()
                && it.chars().all(|c| c.is_ascii_lowercase() || "_1234567890".contains(c))
        };
        let Some((before, rest)) = text.split_once('{') else { return text.to_owned() };
        match rest.split_once('}').filter(|(name, _)| is_name(name)) {
            Some((name, after)) => {
                let value = self.0.get(name).and_then(Value::as_str);
                let value = value.unwrap_or_else(|| panic!("no entry `{name}` of {text}"));
                format!("{before}{}{}", self.filled(value), self.filled(after))
            }
            None => format!("{before}{{{}", self.filled(rest)),
        }
    }

    fn scene(&self) -> Scene {
        let text = self.filled("{scene}");
        let read = scenefile::parse(text.clone(), Path::new("here.toml"));
        read.unwrap_or_else(|error| panic!("{error}: {text}")).0
    }

    /// The scene without the term that is left out.
    pub fn left(&self) -> Scene {
        let mut scene = self.scene();
        if let Some(term) = self.0.get("without").and_then(Value::as_str) {
            term.parse::<Term>().expect("a term").remove(&mut scene);
        }
        scene
    }

    /// The words of a list, or the words and numbers of a table.
    fn expected(&self, name: &str) -> Option<BTreeMap<String, String>> {
        let number = |it: &Value| self.filled(&it.to_string()).trim_matches('"').to_owned();
        Some(match self.0.get(name)? {
            Value::Table(all) => all.iter().map(|(it, n)| (self.filled(it), number(n))).collect(),
            Value::Array(all) => (0..)
                .zip(all)
                .map(|(n, it)| (format!("{n}"), self.filled(it.as_str().expect("words"))))
                .collect(),
            other => panic!("{name} = {other}"),
        })
    }
}

/// The entries of a list.
fn tables(list: Option<&Value>) -> impl Iterator<Item = &Table> {
    list.and_then(Value::as_array).into_iter().flatten().map(|it| it.as_table().expect("a table"))
}

/// The scenes of all laws of a file.
pub fn cases(file: &str) -> Vec<Case> {
    let file: Table = toml::from_str(file).expect("it is TOML");
    let texts = Case(file["texts"].as_table().expect("a table").clone());
    let of_law = |law: &Table| {
        let own = texts.with(law);
        let cases: Vec<Case> = tables(law.get("cases")).map(|it| own.with(it)).collect();
        let lists = law.get("with").and_then(Value::as_array).into_iter().flatten();
        lists.fold(cases, |all, list| {
            all.iter().flat_map(|it| tables(Some(list)).map(|more| it.with(more))).collect()
        })
    };
    tables(file.get("law")).flat_map(of_law).collect()
}

/// Law: those of `said.toml`. Oracle: the words and numbers there.
#[test]
fn targets_say_and_refuse_what_the_table_says() {
    let cases = cases(include_str!("said.toml"));
    assert!(cases.len() > 250, "only {} scenes", cases.len());
    for case in cases {
        let (scene, what) = (case.left(), case.filled("{says}:\n{scene}"));
        if let Some(Value::Table(is)) = case.0.get("is") {
            let found = scenefile::to_toml(&scene).expect("it is plain data");
            let expected = scenefile::to_toml(&case.with(is).scene()).expect("it is plain data");
            assert_eq!(found, expected, "what is left, {what}");
        }
        for (name, target) in [("mitsuba", Target::Mitsuba), ("pov", Target::Pov)] {
            check(&case, name, target, &scene, &what);
        }
    }
}

fn check(case: &Case, name: &str, target: Target, scene: &Scene, what: &str) {
    let (refused, writes) = (case.expected(name), case.expected(&format!("{name}_writes")));
    if refused.is_none() && writes.is_none() {
        return;
    }
    let (text, all) = match target.write("scene", "scene", scene, Path::new("")) {
        Ok(written) => (written.text.replace('\n', " "), Vec::new()),
        Err(all) => (String::new(), all.iter().map(ToString::to_string).collect::<Vec<_>>()),
    };
    if let Some(refused) = refused {
        let are_named = all.iter().zip(refused.values()).all(|(it, words)| it.contains(words));
        let is_all = all.len() == refused.len();
        assert!(are_named && is_all, "{name} refuses {all:?}, not {refused:?}, {what}");
    } else {
        assert_eq!(all, [""; 0], "what {name} refuses, {what}");
    }
    for (words, count) in writes.into_iter().flatten() {
        let found = text.matches(&words).count().to_string();
        assert_eq!(found, count, "how often {name} writes `{words}`, {what}\n{text}");
    }
}
