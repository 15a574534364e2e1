//! `explain`: its JSON and the document of that, formulas, shares, and a kept test.

use std::collections::{BTreeMap, BTreeSet};

use rayon::prelude::*;
use serde_json::Value;

use crate::kit::{Folder, text_of};

/// The fields of each kind of object.
type Fields = BTreeMap<&'static str, BTreeSet<String>>;

/// The kind of the object under this key in an object of another kind; `None` for what is described in words.
fn kind_of(inside: &str, key: &str) -> Option<&'static str> {
    Some(match (inside, key) {
        ("explanation", "made") => "made",
        ("explanation", "samples") => "sample",
        ("explanation", "statistics") => "statistics",
        ("explanation", "sources") => "sources",
        ("sources", _) => "source",
        ("sample", "ray") | ("ray", "children") => "ray",
        ("ray", "hit") => "hit",
        ("ray", "terms") => "term",
        ("ray", "unlit") => "unlit",
        ("term", "formula") => "formula",
        ("formula", "factors") => "factor",
        ("hit", "optics") => "optics",
        ("hit", "textures") => "texture",
        _ => return None,
    })
}

fn collect(value: &Value, kind: &'static str, fields: &mut Fields) {
    match value {
        Value::Array(all) => all.iter().for_each(|value| collect(value, kind, fields)),
        Value::Object(object) => {
            let known = fields.entry(kind).or_default();
            known.extend(object.keys().cloned());
            for (key, value) in object {
                if let Some(kind) = kind_of(kind, key) {
                    collect(value, kind, fields);
                }
            }
        }
        _ => {}
    }
}

/// The tables of the document: the fields of each heading.
fn documented() -> BTreeMap<String, BTreeSet<String>> {
    let text = text_of("docs/explain-json.md");
    let sections = text.split("\n## `").skip(1);
    let section = |section: &str| {
        let (kind, rest) = section.split_once('`').expect("a heading in backticks");
        let fields = rest.lines().filter_map(|line| line.strip_prefix("| `")?.split('`').next());
        (kind.to_owned(), fields.map(str::to_owned).collect())
    };
    sections.map(section).collect()
}

fn explained(arguments: &str) -> Value {
    Folder::new().run(&format!("groundtruth explain --json {arguments}")).expect(0, &[]).json()
}

/// Scenes and pixels that together have almost every field.
const ASKED: [&str; 10] = [
    "ch28/glass-sphere 200,150",
    "ch28/glass-sphere 200,150 --formulas",
    "ch28/glass-sphere 200,150 --mistake fresnel-transmits-all",
    "ch10/near-focus 100,100 --all",
    "ch18/rectangle 40,40",
    "ch26/cornell-box 100,100 --samples 4",
    "ch29/earth 200,150",
    "ch24/hall-of-mirrors 50,50 --max-depth 2",
    "ch28/glass-sphere 300,300 --tracer path --samples 4",
    "ch23/smooth-sphere 90,110",
];

/// Fields that need a scene of their own; tests of the library ask for them.
const RARE: &[&str] = &[
    "ray.boundaries",
    "ray.black",
    "hit.is_switched_off",
    "term.mis",
    "unlit.angle",
    "unlit.outer",
    "unlit.distance",
    "unlit.cos_lamp",
    "unlit.cos_o",
    "unlit.blocked_by",
    "explanation.notes",
    "optics.critical_angle",
    "optics.media",
    "hit.path",
];

/// Law: the document has each field that `explain --json` prints, in the table of its object; and each field of the
/// document is printed. Oracle: the keys of explanations of several scenes.
#[test]
fn the_document_of_the_json_has_every_field_and_no_other() {
    let answers: Vec<Value> = ASKED.par_iter().map(|asked| explained(asked)).collect();
    let mut found = Fields::new();
    answers.iter().for_each(|answer| collect(answer, "explanation", &mut found));
    let documented = documented();
    let none = BTreeSet::new();
    for (kind, fields) in &found {
        let table = documented.get(*kind).unwrap_or(&none);
        let missing: Vec<&String> = fields.difference(table).collect();
        assert!(missing.is_empty(), "docs/explain-json.md: the table of {kind} has no {missing:?}");
    }
    for (kind, table) in &documented {
        let fields = found.get(kind.as_str()).unwrap_or(&none);
        for field in table.difference(fields) {
            let name = format!("{kind}.{field}");
            assert!(RARE.contains(&name.as_str()), "docs/explain-json.md: nothing prints {name}");
        }
    }
}

/// Law: `--formulas` changes nothing else in the JSON; each term has a formula, whose factors are its value, whose letters
/// and numbers those of the text. Oracles: the JSON without it; the product by hand; the printed text.
#[test]
fn formulas_as_data_are_those_of_the_text_and_their_product_the_value() {
    let pixel = "ch28/glass-sphere 200,150 --min-share 0";
    let (mut with, plain) = (explained(&format!("{pixel} --formulas")), explained(pixel));
    let text = Folder::new().good(&format!("groundtruth explain {pixel} --formulas"));
    let mut found = 0;
    take_formulas(&mut with, &mut |term, formula| {
        found += 1;
        let word = |name: &str| formula[name].as_str().expect("text").to_owned();
        let line = format!(
            "{} = {}  ({}, {})",
            word("symbols"),
            word("numbers"),
            word("place"),
            word("source")
        );
        // the text leaves out the light of a shadow ray that loses nothing
        assert!(text.contains(&line) || term["source"] == "light", "no `{line}` in\n{text}");
        for channel in 0..3 {
            let value = |data: &Value| data["value"][channel].as_f64().expect("a number");
            let product = formula["factors"].as_array().expect("a list").iter().fold(
                1.0,
                |product, factor| {
                    if factor["divides"] == true {
                        product / value(factor)
                    } else {
                        product * value(factor)
                    }
                },
            );
            let wanted = value(term);
            // roundings of a few factors
            let is_near = (product - wanted).abs() <= 1e-9 * wanted.abs();
            assert!(is_near, "the product of {line}: {product}, not {wanted}");
        }
    });
    assert!(found > 10, "formulas: found {found}, expected more than 10");
    assert_eq!(with, plain, "the JSON without its formulas");
}

/// Takes the formula out of each term, and shows both.
fn take_formulas(data: &mut Value, seen: &mut impl FnMut(&Value, &Value)) {
    match data {
        Value::Array(all) => all.iter_mut().for_each(|data| take_formulas(data, seen)),
        Value::Object(object) => {
            for (key, data) in &mut *object {
                if key != "terms" {
                    take_formulas(data, seen);
                    continue;
                }
                for term in data.as_array_mut().expect("a list") {
                    let formula = term.as_object_mut().expect("a term").remove("formula");
                    seen(term, &formula.expect("each term has one"));
                }
            }
        }
        _ => {}
    }
}
