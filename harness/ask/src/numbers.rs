//! Numbers of answers, as languages print them.

use serde_json::Value;
use text::loose::not_finite;

/// A number of JSON, or by name one that JSON does not have, as languages print it.
pub fn number(value: &Value) -> Option<f64> {
    match value {
        Value::Number(number) => number.as_f64(),
        Value::String(name) => not_finite(name),
        _ => None,
    }
}

/// The numbers of a list.
pub fn numbers(value: &Value) -> Option<Vec<f64>> {
    value.as_array()?.iter().map(number).collect()
}

/// Three numbers.
pub fn triple(value: &Value) -> Option<[f64; 3]> {
    numbers(value)?.try_into().ok()
}

/// Whether NaN is among these numbers: JavaScript writes it as `null`, others by a name.
pub fn nan_in(value: &Value) -> bool {
    let is_nan = |value: &Value| value.is_null() || number(value).is_some_and(f64::is_nan);
    let is_number = |value: &Value| value.is_null() || number(value).is_some();
    match value {
        Value::Array(items) => items.iter().all(is_number) && items.iter().any(is_nan),
        // a bare `null` is more often "nothing"
        other => number(other).is_some_and(f64::is_nan),
    }
}
