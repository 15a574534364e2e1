//! Lists in place of tables, which the reader alone would take: as the values of the fields, in the order of their
//! declaration.

use groundtruth::kinds::Entry;
use groundtruth::{bumps, cameras, filters, samplers, textures};
use serde::Serialize;
use toml::{Table, Value};

use super::SCENE;
use super::places::{Place, at, places};
use crate::prelude::*;

/// The error of the scene with this value at a path, once for each table in the value: a list stands in its place.
fn errors(path: &[String], specimen: &Value) -> Vec<String> {
    let mut whole = Value::Table(SCENE.parse::<Table>().expect("it is TOML"));
    *at(&mut whole, path) = specimen.clone();
    let text = toml::to_string(&whole).expect("it is TOML");
    scenefile::parse(text.clone(), Path::new("scene.toml"))
        .unwrap_or_else(|e| panic!("{e}: {text}"));
    let error = |path: Place| {
        let mut changed = whole.clone();
        let table = at(&mut changed, &path);
        let fields = table.as_table().expect("it is a table").values().cloned().collect();
        *table = Value::Array(fields);
        let text = toml::to_string(&changed).expect("it is TOML");
        match scenefile::parse(text.clone(), Path::new("scene.toml")) {
            Err(error) => error.to_string(),
            Ok(_) => panic!("{path:?} is read as a table:\n{text}"),
        }
    };
    places(specimen, path, &Value::is_table).into_iter().map(error).collect()
}

fn check<K: Serialize>(path: &str, entries: &[Entry<K>]) {
    for entry in entries {
        for specimen in (entry.specimens)() {
            let specimen = Value::try_from(&specimen).expect("specimens are plain data");
            for error in errors(&place(path), &specimen) {
                // where a colour or its numbers may stand, the reader itself refuses the list
                let is_said = error.contains("found a list, but a table is needed: write `")
                    || error.contains("expected a colour")
                    || error.contains("expected a number");
                assert!(is_said && error.contains("scene.toml:"), "{}: {error}", entry.module);
            }
        }
    }
}

fn place(path: &str) -> Place {
    path.split('.').map(str::to_owned).collect()
}

/// Law: of every kind and all that it holds, a list of the values in place of a table is an error that says what to
/// write. Oracle: the specimens of all kinds, which are read as tables.
#[test]
fn no_list_is_read_as_a_table() {
    check("objects.0.shape", shapes::Kind::ENTRIES);
    check("lights.0.source", lights::Kind::ENTRIES);
    check("materials.0.recipe", materials::Kind::ENTRIES);
    check("materials.0.recipe.matte.cd", textures::Kind::ENTRIES);
    check("materials.0.bump", bumps::Kind::ENTRIES);
    check("camera.lens", cameras::Kind::ENTRIES);
    check("image.sampler", samplers::Kind::ENTRIES);
    check("image.filter", filters::Kind::ENTRIES);
}

/// Law: the same for the tables of the scene itself. Oracle: the scene.
#[test]
fn no_table_of_the_scene_can_be_a_list() {
    let whole = SCENE.parse::<Table>().expect("it is TOML");
    for (name, value) in &whole {
        for error in errors(&place(name), value) {
            assert!(error.contains("found a list, but a table is needed: write `"), "{error}");
        }
    }
}
