//! The places of a document: the keys that lead to a value, an index of a list as a text.

use toml::Value;

pub type Place = Vec<String>;

/// The value at a place; a key that is not there is made.
pub fn at<'a>(value: &'a mut Value, place: &[String]) -> &'a mut Value {
    place.iter().fold(value, |value, key| match value {
        Value::Array(array) => &mut array[key.parse::<usize>().expect("an index")],
        Value::Table(table) => table.entry(key.clone()).or_insert(Value::Boolean(false)),
        _ => panic!("{key} is in no table"),
    })
}

/// The places of a value and of all inside it for which this holds; `place` is that of the value.
pub fn places(value: &Value, place: &[String], is_one: &dyn Fn(&Value) -> bool) -> Vec<Place> {
    let inside: Vec<(String, &Value)> = match value {
        Value::Table(table) => table.iter().map(|(key, inner)| (key.clone(), inner)).collect(),
        Value::Array(array) => (0..).map(|i: usize| i.to_string()).zip(array).collect(),
        _ => Vec::new(),
    };
    let own = is_one(value).then(|| place.to_vec());
    let inside = inside
        .into_iter()
        .flat_map(|(key, inner)| places(inner, &[place, &[key]].concat(), is_one));
    own.into_iter().chain(inside).collect()
}
