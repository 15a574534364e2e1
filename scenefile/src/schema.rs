//! The JSON schema of scene files, generated from the doc comments, types and defaults of the
//! scene's types, and from the specimens of the kinds.

use std::sync::LazyLock;

use groundtruth::scene::Scene;
use schemars::generate::SchemaSettings;
use serde_json::{Map, Value, json};

/// The JSON schema (draft 7, which editors of TOML read) of scene files.
pub fn schema() -> &'static Value {
    static SCHEMA: LazyLock<Value> = LazyLock::new(|| {
        let generator = SchemaSettings::draft07().into_generator();
        let mut schema = generator.into_root_schema_for::<Scene>().to_value();
        tidy(&mut schema);
        schema
    });
    &SCHEMA
}

/// Removes what applies to Rust and JSON but not to TOML, recursively.
fn tidy(schema: &mut Value) {
    match schema {
        Value::Array(parts) => {
            parts.retain(|part| *part != json!({ "type": "null" })); // TOML has no null
            parts.iter_mut().for_each(tidy);
        }
        Value::Object(keywords) => {
            keywords.shift_remove("format"); // the width of numbers
            if let Some(of) = keywords.get_mut("type").filter(|of| of.is_array()) {
                *of = of[0].clone(); // the other is null
            }
            if let Some(Value::String(text)) = keywords.get_mut("description") {
                *text = unwrapped(text);
            }
            keywords.values_mut().for_each(tidy);
            show_false(keywords);
        }
        _ => {}
    }
}

/// A doc comment with each paragraph on one line, without links.
fn unwrapped(text: &str) -> String {
    let unlinked = text.replace("[`", "`").replace("`]", "`");
    let paragraphs = unlinked.split("\n\n").map(|paragraph| paragraph.replace('\n', " "));
    paragraphs.collect::<Vec<_>>().join("\n\n")
}

/// Adds the default `false` of Boolean fields: schemars omits a default that serde does not write.
fn show_false(table: &mut Map<String, Value>) {
    let required = table.get("required").cloned().unwrap_or_default();
    let is_required =
        |name: &str| required.as_array().is_some_and(|all| all.contains(&json!(name)));
    let Some(Value::Object(fields)) = table.get_mut("properties") else { return };
    for (name, field) in fields {
        if field["type"] == "boolean" && field.get("default").is_none() && !is_required(name) {
            field["default"] = json!(false);
        }
    }
}
