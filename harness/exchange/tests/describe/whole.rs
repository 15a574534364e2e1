//! What a description has to say, and nothing more.

use std::collections::BTreeSet;
use std::sync::LazyLock;

use exchange::describe;
use groundtruth::scene::Scene;
use groundtruth::{lights, materials};
use rayon::prelude::*;
use serde_json::Value;

use super::{described, numbers, section};

/// A scene of the gallery and its description.
type Text = (&'static str, Scene, String);

fn for_each_scene(check: impl Fn(&str, &Scene, &str)) {
    static TEXTS: LazyLock<Vec<Text>> = LazyLock::new(|| {
        let scenes: Vec<gallery::Entry> = gallery::scenes().collect();
        let text = |entry: gallery::Entry| {
            let scene = (entry.build)();
            let text = described(entry.name, &scene).text;
            (entry.name, scene, text)
        };
        scenes.into_par_iter().map(text).collect()
    });
    assert!(TEXTS.len() > 40, "only {} scenes", TEXTS.len());
    TEXTS.iter().for_each(|(name, scene, text)| check(name, scene, text));
}

/// The numbers and switches of entries, in their order; yes is −1 and no is −2.
fn settings(lines: &[&str]) -> Vec<f64> {
    let without_label = |line: &str| match line.trim_start().strip_prefix('(') {
        Some(rest) if rest.starts_with(|c: char| c.is_ascii_digit()) => {
            rest.split_once(')').map_or(rest, |(_, rest)| rest).to_owned()
        }
        _ => line.to_owned(),
    };
    let entries = lines.iter().filter(|line| line.starts_with("  "));
    let text: String = entries.map(|line| without_label(line) + "\n").collect();
    numbers(&text.replace("= yes\n", "-1\n").replace("= no\n", "-2\n"))
}

/// The same of the `Debug` output of data.
fn settings_of_data(data: &str) -> Vec<f64> {
    numbers(&data.replace(": true", ": -1").replace(": false", ": -2"))
}

/// Law: every number of lights, materials and objects is in the description, in the order of the scene's
/// data, defaults included, and no other. Oracle: the derived `Debug` of the data, which the description
/// does not use.
#[test]
fn lights_materials_and_objects_have_all_their_numbers() {
    for_each_scene(|name, scene, text| {
        for (title, data) in [
            ("LIGHTS", format!("{:?}", scene.lights)),
            ("MATERIALS", format!("{:?}", scene.materials)),
            ("OBJECTS", format!("{:?}", scene.objects)),
        ] {
            let lines = section(text, title);
            let formulas = lines.iter().position(|line| {
                line.starts_with("At a hit") || line.starts_with("A surface of the kind")
            });
            let found = settings(&lines[..formulas.unwrap_or(lines.len())]);
            let expected = settings_of_data(&data);
            let first = found.iter().zip(&expected).position(|(found, expected)| found != expected);
            assert_eq!(first, None, "{name}, {title}: the first number that differs");
            assert_eq!(found.len(), expected.len(), "{name}, {title}");
        }
    });
}

/// The tags of all lists of kinds in the schema.
fn tags() -> BTreeSet<String> {
    let definitions = scenefile::schema()["definitions"].as_object().expect("it has definitions");
    let mut tags = BTreeSet::new();
    for definition in definitions.values() {
        let lists = definition["oneOf"].as_array().into_iter().flatten();
        let own = (definition["maxProperties"] == 1).then_some(definition);
        for schema in own.into_iter().chain(lists) {
            tags.extend(schema["const"].as_str().map(str::to_owned));
            tags.extend(
                schema["properties"].as_object().into_iter().flatten().map(|it| it.0.clone()),
            );
        }
    }
    tags
}

/// Fields whose value is the name of a kind.
const NAMING: [&str; 15] = [
    "tracer",
    "shadows",
    "mapping",
    "filtering",
    "rule",
    "wrap",
    "wrap_u",
    "wrap_v",
    "picture",
    "interpolation",
    "out_of_gamut",
    "viewing",
    "sampling",
    "encoding",
    "intersect",
];

/// The tags that a scene file uses: tables of one key that is a tag, and texts in fields that name a kind.
fn used(value: &Value, tags: &BTreeSet<String>, used_tags: &mut BTreeSet<String>) {
    match value {
        Value::Object(table) => {
            let only = table.keys().next().filter(|_| table.len() == 1);
            used_tags.extend(only.filter(|key| tags.contains(*key)).cloned());
            for (key, value) in table {
                if let Some(name) = value.as_str().filter(|_| NAMING.contains(&key.as_str())) {
                    used_tags.insert(name.to_owned());
                }
                used(value, tags, used_tags);
            }
        }
        Value::Array(items) => items.iter().for_each(|item| used(item, tags, used_tags)),
        _ => {}
    }
}

/// The kinds that the words explain: title of the list, and tag.
fn explained(text: &str) -> Vec<(String, String)> {
    let mut list = String::new();
    let mut kinds = Vec::new();
    for line in section(text, "WORDS") {
        if !line.starts_with(' ') {
            // a longer description goes on in lines without a dot after the first word
            let title = line.split_once(". ").map(|(title, _)| title);
            if let Some(title) = title.filter(|title| title.starts_with(char::is_uppercase)) {
                list = title.to_owned();
            }
        } else if line.starts_with("  ") && !line.starts_with("   ") && list != "Tables" {
            let tag = line.trim_start().split([':', ' ']).next().unwrap_or_default();
            kinds.push((list.clone(), tag.to_owned()));
        }
    }
    kinds
}

/// Law: the words explain each kind that the scene uses, once, and else only those to which they refer
/// themselves. Oracle: the tags in the exported file.
#[test]
fn the_words_are_those_of_the_scene() {
    let tags = tags();
    for_each_scene(|name, scene, text| {
        let file = scenefile::to_toml(scene).expect("it is plain data");
        let file: Value = toml::from_str(&file).expect("it is TOML");
        let mut expected = BTreeSet::new();
        used(&file, &tags, &mut expected);
        if file["image"].get("filter").is_none() {
            expected.insert("box".to_owned());
        }
        let found = explained(text);
        let once: BTreeSet<&(String, String)> = found.iter().collect();
        assert_eq!(once.len(), found.len(), "{name}: explained twice: {found:?}");
        let words = section(text, "WORDS").join(" ");
        let found: BTreeSet<String> = found.into_iter().map(|(_, tag)| tag).collect();
        let missing: Vec<_> = expected.difference(&found).collect();
        assert!(missing.is_empty(), "{name}: not explained: {missing:?}");
        for tag in found.difference(&expected) {
            assert!(
                words.contains(&format!("`{tag}`")),
                "{name}: {tag} is explained, but not used"
            );
        }
    });
}

/// Law: a description says which normal is meant where surfaces have two, and that all objects block lamps where paths are
/// traced, and only there. Oracle: the words of the exported file that give them: `smooth`, `normals`, `bump`, and the tracer's.
#[test]
fn what_holds_for_some_scenes_is_said_of_them_alone() {
    for_each_scene(|name, scene, text| {
        let file = scenefile::to_toml(scene).expect("it is plain data");
        let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
        let has_two = ["smooth = true", "normals = [", "bump"].iter().any(|it| file.contains(it));
        assert_eq!(text.contains("the interpolated or bumped normal"), has_two, "{name}: normals");
        let traces_paths =
            ["[tracer.path", "[tracer.global_trace]"].iter().any(|it| file.contains(it));
        let is_said = text.contains("are blocked by all objects in any case");
        assert_eq!(is_said, traces_paths, "{name}: shadows");
    });
}

/// Law: every kind of light and material has a formula, and formulas are of kinds that exist. Oracle: the
/// schema.
#[test]
fn every_light_and_material_has_its_formula() {
    let lights: Vec<_> = lights::Kind::ENTRIES.iter().map(|it| (it.module, it.formula)).collect();
    let materials: Vec<_> =
        materials::Kind::ENTRIES.iter().map(|it| (it.module, it.formula)).collect();
    for (definition, formulas) in [("LightKind", lights), ("MaterialKind", materials)] {
        let kinds = &scenefile::schema()["definitions"][definition]["properties"];
        let kinds: BTreeSet<&str> =
            kinds.as_object().expect("it is a list").keys().map(String::as_str).collect();
        assert_eq!(kinds.len(), formulas.len());
        let said = formulas.iter().filter(|(_, formula)| !formula.is_empty());
        assert_eq!(said.map(|(tag, _)| *tag).collect::<BTreeSet<_>>(), kinds);
    }
    let tags = tags();
    let unknown = describe::details().filter(|(_, tag, _)| !tags.contains(*tag));
    assert_eq!(unknown.count(), 0);
}

/// Law: no line is longer than 100 characters, unless it is one word.
#[test]
fn lines_are_short() {
    for_each_scene(|name, _, text| {
        for line in text.lines() {
            let fits = line.chars().count() <= 100 || line.split_whitespace().count() == 1;
            assert!(fits, "{name}: {line}");
        }
    });
}

/// Law: names are printed as they are, also with two spaces, and without control characters.
#[test]
fn names_are_kept_and_obey_no_terminal() {
    let mut scene = (gallery::find("ch03/single-sphere").expect("it is there").build)();
    let own = "  two   spaces\u{1b}[2J";
    scene.about = own.to_owned();
    own.clone_into(&mut scene.objects[0].name);
    let text = described(own, &scene).text;
    assert!(text.contains("name = \"  two   spaces\\u{1b}[2J\""), "{text}");
    assert!(text.chars().all(|c| c == '\n' || !c.is_control()), "{text}");
}
