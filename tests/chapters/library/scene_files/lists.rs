//! Lists in place of tables, which the reader alone would take: as the values of the fields, in the order of their
//! declaration.

use groundtruth::kinds::Entry;
use groundtruth::{bumps, cameras, filters, samplers, scene, textures};
use serde::Serialize;
use toml::{Table, Value};

use super::SCENE;
use crate::prelude::*;

/// A step from a value to one inside it.
#[derive(Clone, Debug)]
enum Step {
    Key(String),
    Index(usize),
}

/// The value at the end of a path; a key that is not there is made.
fn at<'a>(value: &'a mut Value, path: &[Step]) -> &'a mut Value {
    path.iter().fold(value, |value, step| match (step, value) {
        (Step::Key(key), Value::Table(table)) => {
            table.entry(key.clone()).or_insert(Value::Boolean(false))
        }
        (Step::Index(index), Value::Array(array)) => &mut array[*index],
        (step, value) => panic!("no {step:?} in {value}"),
    })
}

/// The paths of all tables in a value.
fn tables(value: &Value, path: &[Step], found: &mut Vec<Vec<Step>>) {
    let inside = |step| [path, &[step]].concat();
    match value {
        Value::Table(table) => {
            found.push(path.to_vec());
            let all = table.iter();
            all.for_each(|(key, value)| tables(value, &inside(Step::Key(key.clone())), found));
        }
        Value::Array(array) => {
            let all = array.iter().enumerate();
            all.for_each(|(index, value)| tables(value, &inside(Step::Index(index)), found));
        }
        _ => {}
    }
}

/// The error of the scene with this value at a path, once for each table in the value: a list stands in its place.
fn errors(path: &[Step], specimen: &Value) -> Vec<String> {
    let mut whole = Value::Table(SCENE.parse::<Table>().expect("it is TOML"));
    *at(&mut whole, path) = specimen.clone();
    let text = toml::to_string(&whole).expect("it is TOML");
    scene::parse(text.clone(), Path::new("scene.toml")).unwrap_or_else(|e| panic!("{e}: {text}"));
    let mut found = Vec::new();
    tables(specimen, path, &mut found);
    let error = |path: &Vec<Step>| {
        let mut changed = whole.clone();
        let table = at(&mut changed, path);
        let fields = table.as_table().expect("it is a table").values().cloned().collect();
        *table = Value::Array(fields);
        let text = toml::to_string(&changed).expect("it is TOML");
        match scene::parse(text.clone(), Path::new("scene.toml")) {
            Err(error) => error.to_string(),
            Ok(_) => panic!("{path:?} is read as a table:\n{text}"),
        }
    };
    found.iter().map(error).collect()
}

fn check<K: Serialize>(path: &[Step], entries: &[Entry<K>]) {
    for entry in entries {
        for specimen in (entry.specimens)() {
            let specimen = Value::try_from(&specimen).expect("specimens are plain data");
            for error in errors(path, &specimen) {
                // where a colour or its numbers may stand, the reader itself refuses the list
                let is_said = error.contains("found a list, but a table is needed: write `")
                    || error.contains("expected a colour")
                    || error.contains("expected a number");
                assert!(is_said && error.contains("scene.toml:"), "{}: {error}", entry.module);
            }
        }
    }
}

fn key(name: &str) -> Step {
    Step::Key(name.to_owned())
}

/// Law: of every kind and all that it holds, a list of the values in place of a table is an error that says what to
/// write. Oracle: the specimens of all kinds, which are read as tables.
#[test]
fn no_list_is_read_as_a_table() {
    let first = Step::Index(0);
    let recipe = [key("materials"), first.clone(), key("recipe")];
    check(&[key("objects"), first.clone(), key("shape")], shapes::Kind::ENTRIES);
    check(&[key("lights"), first.clone(), key("source")], lights::Kind::ENTRIES);
    check(&recipe, materials::Kind::ENTRIES);
    check(&[&recipe[..], &[key("matte"), key("cd")]].concat(), textures::Kind::ENTRIES);
    check(&[key("materials"), first, key("bump")], bumps::Kind::ENTRIES);
    check(&[key("camera"), key("lens")], cameras::Kind::ENTRIES);
    check(&[key("image"), key("sampler")], samplers::Kind::ENTRIES);
    check(&[key("image"), key("filter")], filters::Kind::ENTRIES);
}

/// Law: the same for the tables of the scene itself. Oracle: the scene.
#[test]
fn no_table_of_the_scene_can_be_a_list() {
    let whole = SCENE.parse::<Table>().expect("it is TOML");
    for (name, value) in &whole {
        for error in errors(&[key(name)], value) {
            assert!(error.contains("found a list, but a table is needed: write `"), "{error}");
        }
    }
}
