//! Laws of the probe: each question against its own oracle, and the guarantees for input lines.

mod answers;
mod borders;
mod errors;
mod eyes;
mod grid;
mod lobes;
mod radiance;

use serde_json::Value;

/// The answer to a question.
fn ask(question: &Value) -> Value {
    let line = conform::probe::answer(&question.to_string());
    let mut reply: Value = serde_json::from_str(&line).expect("answers are JSON");
    assert_eq!(reply.get("error"), None, "{question}");
    reply["answer"].take()
}

/// The numbers of an answer.
fn numbers(value: &Value) -> Vec<f64> {
    let list = value.as_array().expect("a list");
    list.iter().map(|x| x.as_f64().expect("a number")).collect()
}

/// Whether each number is within `tolerance` of the expected one.
fn close(found: &Value, expected: &[f64], tolerance: f64) -> bool {
    let found = numbers(found);
    found.len() == expected.len()
        && found.iter().zip(expected).all(|(a, b)| (a - b).abs() <= tolerance)
}
