//! Mistakes that are another shape: what our function answers for it is what they would.

use serde_json::Value;

use super::super::mistakes::{Mistake, OF_FUNCTIONS, same};
use super::super::probe::ours;

/// The mistakes with which our answer to an `intersect` or `occluded` is theirs.
pub fn of_other_shapes(question: &Value, theirs: &Value) -> Vec<&'static Mistake> {
    let Ok(right) = ours(question) else { return Vec::new() };
    let is_it = |mistake: &&Mistake| {
        let mut other = question.clone();
        let data = other.as_object_mut().and_then(|all| all.values_mut().next());
        let changed = data.and_then(|data| mistake.known().change(data));
        let answer = changed.and_then(|()| ours(&other).ok());
        answer.is_some_and(|answer| is_same(theirs, &answer) && !is_same(&right, &answer))
    };
    OF_FUNCTIONS.iter().filter(is_it).collect()
}

/// Whether two answers have the same hits: distances and, of one hit, its normal.
fn is_same(a: &Value, b: &Value) -> bool {
    match (a, b) {
        (Value::Array(a), Value::Array(b)) => {
            a.len() == b.len() && a.iter().zip(b).all(|(a, b)| is_same(a, b))
        }
        (Value::Object(_), Value::Object(_)) => ["t", "normal"].into_iter().all(|name| {
            let numbers = [a, b].map(|hit| match &hit[name] {
                Value::Array(all) => all.iter().filter_map(Value::as_f64).collect(),
                other => other.as_f64().into_iter().collect::<Vec<f64>>(),
            });
            same(&numbers[0], &numbers[1])
        }),
        _ => a == b,
    }
}
