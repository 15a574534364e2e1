//! Numbers of answers, as languages print them.

use serde_json::Value;

/// A number of JSON, or by name one that JSON does not have, as languages print it.
pub fn number(value: &Value) -> Option<f64> {
    match value {
        Value::Number(number) => number.as_f64(),
        Value::String(name) => not_finite(name),
        _ => None,
    }
}

/// The number that is not finite with this name: `inf`, `-Infinity`, `nan`, `-nan(ind)`, `1.#QNAN` …
pub(crate) fn not_finite(name: &str) -> Option<f64> {
    let lower = name.to_ascii_lowercase();
    let (sign, bare) = match lower.strip_prefix('-') {
        Some(rest) => (-1.0, rest),
        None => (1.0, lower.strip_prefix('+').unwrap_or(&lower)),
    };
    // a payload, as `nan(0x8000000000000)`, or `nan(ind)` for the default one
    let is_payload = |rest: &str| rest.is_empty() || rest.starts_with('(') && rest.ends_with(')');
    match bare {
        "inf" | "infinity" | "1.#inf" | "1.#inf00" => Some(sign * f64::INFINITY),
        "1.#ind" | "1.#qnan" | "1.#snan" | "1.#ind00" | "1.#qnan0" => Some(f64::NAN),
        _ => bare.strip_prefix("nan").filter(|rest| is_payload(rest)).map(|_| f64::NAN),
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
