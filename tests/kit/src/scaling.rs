//! Scaling: the same data with every length multiplied by a factor.
//!
//! Which numbers are lengths stands in the schema of scene files, as the dimension of their field
//! ([`DIMENSION`]). Data are walked beside it as a scene file holds them.

use groundtruth::math::{DIMENSION, power, power_of_two};
use groundtruth::scene::Scene;
use groundtruth::shapes::textbook::EPSILON;
use scenefile::schema;
use schemars::JsonSchema;
use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::Value as Schema;
use toml::{Table, Value};

/// The same thing with every length multiplied by `factor`.
pub fn scaled<Data: JsonSchema + Serialize + DeserializeOwned>(data: &Data, factor: f64) -> Data {
    let definition = match &*Data::schema_name() {
        "Scene" => schema(),
        name => &schema()["definitions"][name],
    };
    assert!(definition.is_object(), "{} is no part of a scene", Data::schema_name());
    let mut value = Value::try_from(data).expect("it is plain data");
    scale(&mut value, definition, &Table::new(), factor);
    value.try_into().expect("only numbers changed")
}

/// The scene with every length multiplied by `2^exponent`: it renders the same picture, bit for bit.
pub fn scaled_scene(scene: &Scene, exponent: i32) -> Scene {
    let mut scene = scene.clone();
    if scene.uses_textbook() {
        scene.epsilon.get_or_insert(EPSILON);
    }
    scaled(&scene, power_of_two(exponent))
}

/// Scales a value of a table, which names the other fields of the table in its dimension.
fn scale(value: &mut Value, schema: &'static Schema, table: &Table, factor: f64) {
    if let Some(dimension) = schema[DIMENSION].as_str() {
        return match dimension {
            "1" => {}
            "length in the last column" => scale_translation(value, factor),
            _ => multiply(value, unit(dimension, table, factor)),
        };
    }
    if let Some(reference) = schema["$ref"].as_str() {
        let name = reference.trim_start_matches("#/definitions/");
        scale(value, &self::schema()["definitions"][name], table, factor);
    }
    let parts = ["allOf", "anyOf", "oneOf"].map(|keyword| schema[keyword].as_array());
    for part in parts.into_iter().flatten().flatten() {
        scale(value, part, table, factor);
    }
    match value {
        Value::Array(items) => {
            items.iter_mut().for_each(|item| scale(item, &schema["items"], table, factor));
        }
        Value::Table(fields) => {
            let all = fields.clone();
            for (name, field) in fields {
                scale(field, &schema["properties"][name], &all, factor);
            }
        }
        _ => {}
    }
}

/// What the scaled unit of a dimension is in the old one: `factor` for a `length`.
fn unit(dimension: &str, table: &Table, factor: f64) -> f64 {
    match dimension {
        "length" => factor,
        "1/length" => 1.0 / factor,
        _ => {
            let (base, field) = dimension.split_once('^').expect("a power of a length");
            power(unit(base, table, factor), sum(&table[field]))
        }
    }
}

/// The sum of the numbers of a value.
fn sum(value: &Value) -> f64 {
    match value {
        Value::Array(items) => items.iter().map(sum).sum(),
        Value::Integer(number) => *number as f64,
        number => number.as_float().expect("a number"),
    }
}

/// Multiplies all numbers of a value.
fn multiply(value: &mut Value, by: f64) {
    match value {
        Value::Array(items) => items.iter_mut().for_each(|item| multiply(item, by)),
        number => *number = Value::Float(by * sum(number)),
    }
}

/// Scales the last column of a matrix but for its last row, which is `[0, 0, 0, 1]`.
fn scale_translation(matrix: &mut Value, factor: f64) {
    for row in &mut matrix.as_array_mut().expect("rows")[..3] {
        multiply(&mut row[3], factor);
    }
}
