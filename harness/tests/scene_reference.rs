//! A scene file can be written from the documentation alone: docs/scene.md, `groundtruth kinds`, the
//! schema for editors and the pointers in error messages agree with what the program reads.

use std::collections::BTreeMap;
use std::fmt::Debug;
use std::path::Path;
use std::sync::LazyLock;

use exchange::reference;
use groundtruth::kinds::Entry;
use groundtruth::scene::Scene;
use groundtruth::textures;
use groundtruth::{bumps, cameras, filters, lights, materials, samplers, shapes};
use scenefile::vocabulary::Definition;
use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::{Value, json};

use crate::kit::{Folder, root, text_of};

/// Calls `check` for each specimen: with the name of its list of kinds in the schema, the specimen as JSON,
/// and a function that reads such JSON and formats the result.
fn for_each_specimen(mut check: impl FnMut(&'static str, Value, &dyn Fn(Value) -> String)) {
    fn list<Kind: Serialize + DeserializeOwned + Debug>(
        name: &'static str,
        entries: &[Entry<Kind>],
        check: &mut impl FnMut(&'static str, Value, &dyn Fn(Value) -> String),
    ) {
        for specimen in entries.iter().flat_map(|entry| (entry.specimens)()) {
            let value = serde_json::to_value(&specimen).expect("specimens are plain data");
            check(name, value, &|value| match serde_json::from_value::<Kind>(value) {
                Ok(read) => format!("{read:?}"),
                Err(error) => panic!("{name}: {error}"),
            });
        }
    }
    list("ShapeKind", shapes::Kind::ENTRIES, &mut check);
    list("MaterialKind", materials::Kind::ENTRIES, &mut check);
    list("TextureKind", textures::Kind::ENTRIES, &mut check);
    list("LightKind", lights::Kind::ENTRIES, &mut check);
    list("CameraKind", cameras::Kind::ENTRIES, &mut check);
    list("SamplerKind", samplers::Kind::ENTRIES, &mut check);
    list("FilterKind", filters::Kind::ENTRIES, &mut check);
    list("BumpKind", bumps::Kind::ENTRIES, &mut check);
}

fn validator(definition: Option<&str>) -> jsonschema::Validator {
    let mut schema = scenefile::schema().clone();
    if let Some(name) = definition {
        let reference = format!("#/definitions/{name}");
        schema = json!({ "$ref": reference, "definitions": schema["definitions"] });
        schema["$schema"] = scenefile::schema()["$schema"].clone();
    }
    jsonschema::validator_for(&schema).expect("the schema is a schema")
}

/// Those of the lists of kinds.
static OF_LISTS: LazyLock<BTreeMap<&str, jsonschema::Validator>> = LazyLock::new(|| {
    let lists = Definition::all().map(|it| it.name).filter(|name| name.ends_with("Kind"));
    lists.map(|name| (name, validator(Some(name)))).collect()
});

/// The errors that a validator reports for a value.
fn errors(validator: &jsonschema::Validator, value: &Value) -> Vec<String> {
    let describe = |e: jsonschema::ValidationError<'_>| format!("{}: {e}", e.instance_path());
    validator.iter_errors(value).map(describe).collect()
}

/// Law: the page is what the program prints now.
#[test]
fn the_page_of_scene_files_is_up_to_date() {
    assert!(
        text_of("docs/scene.md") == reference::page(),
        "docs/scene.md is out of date; renew it by\n\n    \
         cargo run -- kinds --page > docs/scene.md\n"
    );
}

/// Law: the schema admits every specimen. Oracle: another implementation of JSON Schema.
#[test]
fn every_specimen_conforms_to_the_schema() {
    let mut count = 0;
    for_each_specimen(|list, specimen, _| {
        count += 1;
        assert_eq!(errors(&OF_LISTS[list], &specimen), [""; 0], "{list}: {specimen}");
    });
    assert!(count > 90, "only {count} specimens");
}

/// Law: the schema refuses a specimen with an additional field of a misspelt name. (Renaming a field would
/// be a weaker test, because a required field would then be missing, too.)
#[test]
fn no_specimen_with_a_misspelt_field_conforms_to_the_schema() {
    let mut count = 0;
    for_each_specimen(|list, specimen, _| {
        let validator = &OF_LISTS[list];
        let (tag, fields) = specimen.as_object().and_then(|it| it.iter().next()).expect("a kind");
        for (name, value) in fields.as_object().expect("a table") {
            let mut more = fields.clone();
            more[format!("{name}x")] = value.clone();
            count += 1;
            assert!(!validator.is_valid(&json!({ tag: more })), "{list}: {tag}.{name}x is taken");
        }
    });
    assert!(count > 200, "only {count} fields");
}

/// Law: what the program reads and writes conforms to the schema that editors check it with.
#[test]
fn every_gallery_scene_and_commented_scene_conforms_to_the_schema() {
    let validator = validator(None);
    let mut scenes: Vec<(String, String)> = gallery::scenes()
        .map(|it| {
            (it.name.to_owned(), scenefile::to_toml(&(it.build)()).expect("it is plain data"))
        })
        .collect();
    let files = std::fs::read_dir(root().join("scenes")).expect("there are scenes");
    for path in files.map(|file| file.expect("readable").path()) {
        if path.extension().is_some_and(|extension| extension == "toml") {
            let text = std::fs::read_to_string(&path).expect("scenes are text");
            scenes.push((path.display().to_string(), text));
        }
    }
    assert!(scenes.len() > 40, "only {} scenes", scenes.len());
    for (name, text) in scenes {
        let value: Value = toml::from_str(&text).expect("it is TOML");
        assert_eq!(errors(&validator, &value), [""; 0], "{name}");
    }
}

/// Law: the default of an omitted field is the one in the schema. Oracle: serde's reader.
#[test]
fn the_defaults_of_the_schema_are_those_of_the_reader() {
    let mut count = 0;
    let mut check = |table: Definition, whole: &Value, at: &str, read: &dyn Fn(Value) -> String| {
        for field in table.fields() {
            let Some(default) = field.default() else { continue };
            let (mut written, mut left_out) = (whole.clone(), whole.clone());
            let of = |value: &mut Value| value.pointer_mut(at).expect("it is there").take();
            let mut fields = of(&mut written);
            fields[field.name] = default.clone();
            *written.pointer_mut(at).expect("it is there") = fields.clone();
            fields.as_object_mut().expect("a table").shift_remove(field.name);
            *left_out.pointer_mut(at).expect("it is there") = fields;
            count += 1;
            assert_eq!(read(left_out), read(written), "{}.{}", table.title(), field.name);
        }
    };
    for_each_specimen(|list, specimen, read| {
        let list = Definition::all().find(|it| it.name == list).expect("it is in the schema");
        for kind in list.choices() {
            if let (Some(table), Some(_)) = (kind.table(), specimen.get(kind.tag)) {
                check(table, &specimen, &format!("/{}", kind.tag), read);
            }
        }
    });
    let first: Value = toml::from_str(&text_of("scenes/first.toml")).expect("it is TOML");
    let as_scene = |value: Value| match serde_json::from_value::<Scene>(value) {
        Ok(scene) => format!("{scene:?}"),
        Err(error) => panic!("{error}"),
    };
    for (name, at) in [
        ("Scene", ""),
        ("Image", "/image"),
        ("Camera", "/camera"),
        ("Light", "/lights/0"),
        ("Material", "/materials/0"),
        ("Object", "/objects/0"),
    ] {
        let table = Definition::all().find(|it| it.name == name).expect("it is in the schema");
        check(table, &first, at, &as_scene);
    }
    assert!(count > 60, "only {count} defaults");
}

/// The lamp that the example of an area light names.
const LAMP: &str = r#"
[[materials]]
name = "glow"
recipe.emissive = {}

[[objects]]
name = "lamp"
material = "glow"
shape.sphere = { center = [0, 9, 0], radius = 1 }
"#;

/// Law: every example of the page can be added to the first scene, which is then read without an error.
#[test]
fn every_example_of_the_page_is_part_of_a_scene_that_is_read() {
    let page = reference::page();
    let blocks: Vec<_> = page.split("```toml\n").skip(1).collect();
    assert!(blocks.len() > 60, "only {} examples", blocks.len());
    for block in blocks {
        let example = block.split("```").next().unwrap_or_default();
        let first = text_of("scenes/first.toml") + LAMP;
        let mut whole: toml::Table = toml::from_str(&first).expect("it is TOML");
        for (key, value) in toml::from_str::<toml::Table>(example).expect("examples are TOML") {
            match (whole.get_mut(&key), value) {
                (Some(toml::Value::Array(items)), toml::Value::Array(more)) => {
                    items.retain(|item| more.iter().all(|it| it.get("name") != item.get("name")));
                    items.extend(more);
                }
                (_, value) => drop(whole.insert(key, value)),
            }
        }
        let text = toml::to_string(&whole).expect("it can be written");
        let read = scenefile::from_toml(&text, &root().join("scenes/example.toml"));
        if let Err(error) = read {
            panic!("{error}\n{example}");
        }
    }
}

/// Law: everything on the page is explained, and nothing refers to the Rust documentation.
#[test]
fn every_kind_table_and_field_says_what_it_means() {
    for topic in reference::topics() {
        let name = topic.name();
        let is_list = topic.is_list();
        assert!(is_list || topic.summary().len() > 5, "{name}: what is it?");
        assert!(!topic.text().contains("[`") && !topic.text().contains("::"), "{}", topic.text());
        assert!(!topic.text().contains("See `"), "{name}: says only where to look");
    }
    let mut unclear = Vec::new();
    for table in Definition::all().filter(Definition::is_table) {
        for field in table.fields() {
            let meaning = field.description();
            let place = format!("{}.{}", table.name, field.name);
            let begins = meaning.split([' ', ';', '.', ':']).next().unwrap_or_default();
            let is_whole = meaning.len() > 8 && meaning.ends_with('.');
            if !is_whole || ["Of", "Positive", "Finite", "At"].contains(&begins) {
                unclear.push(format!("{place}: {meaning}"));
            }
            assert!(!field.values().is_empty(), "{place} has no type");
        }
    }
    assert_eq!(unclear, [""; 0]);
}

/// A change of the first scene, and the end of the error.
const POINTERS: &[(&str, &str, &str)] = &[
    ("shape.sphere", "shape.spheer", "see `groundtruth kinds shapes` (docs/scene.md)"),
    ("radius = 1 ", "radios = 1 ", "see `groundtruth kinds sphere` (docs/scene.md)"),
    ("radius = 1 ", "radius = \"big\" ", "see `groundtruth kinds sphere` (docs/scene.md)"),
    (", radius = 1 ", " ", "see `groundtruth kinds sphere` (docs/scene.md)"),
    ("look_at", "look", "see `groundtruth kinds camera` (docs/scene.md)"),
    ("width = 480\n", "", "see `groundtruth kinds image` (docs/scene.md)"),
    ("size = 1,", "", "see `groundtruth kinds plane_checker` (docs/scene.md)"),
    ("ls = 0.3", "light = 0.3", "see `groundtruth kinds ambient` (docs/scene.md)"),
    ("material = \"orange\"\n", "", "see `groundtruth kinds object` (docs/scene.md)"),
    ("[image]", "[img]", "see `groundtruth kinds scene` (docs/scene.md)"),
    (
        "reflective = { kr = 0.8, cr = [0.9, 0.95, 1] }",
        "dielectric = { inside = 1.5 }",
        "recipe.dielectric.inside: invalid type: floating point `1.5`, expected a table, as \
         `inside = { eta = … }`; see `groundtruth kinds medium` (docs/scene.md)",
    ),
];

/// Law: an error about a field or kind ends with a pointer to the documentation of an existing topic.
#[test]
fn an_error_about_a_field_or_kind_says_where_to_read_about_it() {
    let first = text_of("scenes/first.toml");
    for (part, replacement, end) in POINTERS {
        assert!(first.contains(part), "{part} is in the scene");
        let text = first.replacen(part, replacement, 1);
        let error = match scenefile::from_toml(&text, Path::new("first.toml")) {
            Err(error) => error.to_string(),
            Ok(_) => panic!("{part} -> {replacement} is read"),
        };
        assert!(error.ends_with(end), "{part} -> {replacement}: {error}");
        let topic = error.split("groundtruth kinds ").nth(1).and_then(|it| it.split('`').next());
        assert!(reference::about(topic.expect("it names one")).is_ok(), "{error}");
    }
    let not_toml = scenefile::from_toml("[image", Path::new("x.toml")).expect_err("it is not TOML");
    assert!(!not_toml.to_string().contains("kinds"), "{not_toml}");
}

/// Law: `kinds` prints the overview and the schema of the library. Oracle: the library's own.
#[test]
fn the_command_shows_the_reference_and_the_schema() {
    let folder = Folder::new();
    assert_eq!(folder.good("groundtruth kinds"), reference::overview());
    assert_eq!(folder.run("groundtruth kinds --schema").json(), *scenefile::schema());
}
