//! The lines of a program: a question with its id, and a reply with the question's.
//!
//! JSON has no NaN and no infinity, but most languages print them: `NaN`, `-nan`, `-nan(ind)`, `Infinity`, `1e999`. A
//! line with them is read all the same: a number that is none is a wrong answer, not a broken line.

use std::collections::BTreeMap;

use serde_json::Value;

use super::subject::{Fault, Reply, Stop};
use groundtruth::printable;
use text::loose::quoted;

/// How much of a bad line is shown, in bytes.
const SHOWN: usize = 200;

/// A question with its id, which comes first so that it is seen in long lines.
pub fn line(question: &Value, id: u64) -> String {
    let mut text = format!("{{\"id\":{id}");
    for (key, value) in question.as_object().into_iter().flatten() {
        let key = Value::from(key.as_str());
        text.push_str(&format!(",{key}:{value}"));
    }
    text.push_str("}\n");
    text
}

/// The id and the reply of a line.
pub fn read(line: &[u8]) -> Result<(u64, Reply), Fault> {
    let shown = || {
        let text = String::from_utf8_lossy(&line[..line.len().min(SHOWN)]).into_owned();
        printable::text(&text)
    };
    let garbled = |problem: &str| Err(Fault::Garbled(format!("{problem}: {}", shown())));
    let Some(mut reply) = object(line) else { return garbled("not a JSON object") };
    let id = match reply.get("id") {
        Some(Value::Number(id)) => match id.as_u64().or_else(|| whole(id.as_f64()?)) {
            Some(id) => id,
            None => return garbled("`id` is not that of a question"),
        },
        Some(_) => return garbled("`id` is not that of a question"),
        None => return garbled("no `id`; copy the question's"),
    };
    let text = |value: &Value| value.as_str().map_or_else(|| value.to_string(), str::to_owned);
    let kinds = ["answer", "error", "unsupported"];
    let found: Vec<&str> = kinds.into_iter().filter(|kind| reply.contains_key(*kind)).collect();
    match found[..] {
        ["answer"] => Ok((id, Ok(reply.remove("answer").unwrap_or_default()))),
        ["error"] => Ok((id, Err(Stop::Refused(text(&reply["error"]))))),
        ["unsupported"] => Ok((id, Err(Stop::Unsupported(text(&reply["unsupported"]))))),
        _ => garbled("needs one of `answer`, `error`, `unsupported`"),
    }
}

/// The fields of a line, which may have numbers that JSON does not have.
fn object(line: &[u8]) -> Option<BTreeMap<String, Value>> {
    serde_json::from_slice(line)
        .ok()
        .or_else(|| serde_json::from_str(&quoted(std::str::from_utf8(line).ok()?)).ok())
}

/// `7.0` is the id 7: some languages have no integers.
fn whole(id: f64) -> Option<u64> {
    (id >= 0.0 && id.fract() == 0.0 && id < 1e15).then_some(id as u64)
}
