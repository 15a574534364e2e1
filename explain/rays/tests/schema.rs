use std::path::Path;

use rays::{FIELDS, Field};
use serde_json::{Map, Value, json};
use testkit::same_text::{Printed, hold};

/// What the value of a field of this form may be.
fn form(field: &Field) -> Value {
    let number = json!({"anyOf": [{"type": "number"}, {"type": ["string", "null"]}]});
    let list = |count: usize, of: Value| json!({"type": "array", "items": of, "minItems": count, "maxItems": count});
    let whole = json!({"type": "integer", "minimum": 0});
    match field.form {
        "number" => number,
        "point" | "vector" => list(3, number),
        "pair" => list(2, number),
        "pixel" => list(2, whole),
        "count" => whole,
        "truth" => json!({"type": "boolean"}),
        "kind" => json!({"type": "string"}),
        "id" | "name" => json!({"type": ["string", "number"]}),
        "color" => {
            json!({"anyOf": [{"type": "number"}, {"type": ["string", "null"]}, list(3, number)]})
        }
        other => panic!("no such form: {other}"),
    }
}

/// The schema of a ray's line.
fn schema() -> Value {
    let mut fields = Map::new();
    for field in FIELDS {
        let first = field.names[0];
        for name in field.names {
            let means =
                if *name == first { field.means.to_owned() } else { format!("short for {first}") };
            fields.insert(
                (*name).to_owned(),
                json!({"description": means, "anyOf": [form(field), {"type": "null"}]}),
            );
        }
    }
    fields.insert(
        "values".to_owned(),
        json!({"description": "fields of one's own", "type": "object"}),
    );
    let either = |long: &str, short: &[&str]| {
        let names = std::iter::once(&long).chain(short).map(|name| json!({"required": [name]}));
        json!({"anyOf": names.collect::<Vec<_>>()})
    };
    let text = json!({"type": "string"});
    json!({
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "A line of a log of rays",
        "anyOf": [
            {"title": "head", "type": "object", "required": ["rays"], "properties": {
                "rays": {"const": 1}, "program": text, "precision": {"enum": ["single", "double", null]}, "picture": text,
                "size": {"type": "array", "items": {"type": "integer"}, "minItems": 2, "maxItems": 2},
                "scene": {"type": ["string", "object"]}, "scale": {"type": "number"},
                "axes": {"type": "array", "items": {"enum": ["x", "y", "z", "-x", "-y", "-z"]}, "minItems": 3, "maxItems": 3},
            }},
            {"title": "lamp", "type": "object", "required": ["lamp"], "not": {"required": ["origin"]}},
            {"title": "object", "type": "object", "required": ["object"], "not": {"anyOf": [{"required": ["origin"]}, {"required": ["o"]}]}},
            {"title": "ray", "type": "object", "properties": fields, "allOf": [either("origin", &["o"]), either("direction", &["d", "dir"])]},
        ],
    })
}

/// Law: the schema in docs has the fields that are read. Oracle: the table of fields; scripts/renew-texts.sh writes it anew.
#[test]
fn the_schema_has_all_fields() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/rays.schema.json");
    let should = serde_json::to_string_pretty(&schema()).expect("a text") + "\n";
    hold(&path, &should, Printed::Exactly);
}
