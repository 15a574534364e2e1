//! Answers of programs whose axes are left-handed: ours in a mirror.

use serde_json::{Value, json};

use super::probe::ours;

/// Fields that are positions and directions.
const MIRRORED: [&str; 14] = [
    "center",
    "corner",
    "direction",
    "eye",
    "from",
    "location",
    "look_at",
    "n",
    "normal",
    "origin",
    "point",
    "to",
    "up",
    "wo",
];

/// Our answers where z has the other sign: of the question and of its answer, of the answer alone, of the question alone. None
/// where no camera looks.
pub fn answers(question: &Value, right: &Value) -> Vec<Value> {
    let data = question.as_object().and_then(|it| it.values().next());
    if !data.is_some_and(|data| ["camera", "pixel"].iter().any(|it| data.get(it).is_some())) {
        return Vec::new();
    }
    let there = ours(&mirrored(question.clone())).ok();
    [there.clone().map(mirrored), Some(mirrored(right.clone())), there]
        .into_iter()
        .flatten()
        .collect()
}

/// The same with the other sign of each z.
fn mirrored(mut value: Value) -> Value {
    if let Some(fields) = value.as_object_mut() {
        for (key, field) in fields {
            *field = match &field.as_array().map(Vec::as_slice) {
                Some([x, y, z]) if MIRRORED.contains(&&**key) => {
                    json!([x, y, -z.as_f64().unwrap_or_default()])
                }
                _ => mirrored(field.take()),
            };
        }
    } else if let Some(items) = value.as_array_mut() {
        items.iter_mut().for_each(|item| *item = mirrored(item.take()));
    }
    value
}
