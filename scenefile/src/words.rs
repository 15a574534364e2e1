//! The messages of the readers of TOML and JSON, in words for a user who does not know Rust.

use groundtruth::invalid::MAX_NESTING;
use groundtruth::{printable, similar};

/// The message of a text reader with the names short that it quotes by backticks.
fn with_short_names(message: &str) -> String {
    let parts = message.split('`').enumerate();
    let parts: Vec<String> = parts
        .map(|(i, part)| if i % 2 == 1 { printable::name(part) } else { part.to_owned() })
        .collect();
    parts.join("`")
}

/// The message of a text reader about an unknown field or kind: with similar names, or else with
/// all.
fn of_unknown(message: &str) -> Option<String> {
    let variant = message.strip_prefix("unknown variant `").map(|rest| ("kind", rest));
    let unknown = || message.strip_prefix("unknown field `").map(|rest| ("field", rest));
    let (what, rest) = variant.or_else(unknown)?;
    let (found, expected) = rest.split_once("`, expected ")?;
    let known: Vec<&str> = expected.split('`').skip(1).step_by(2).collect();
    Some(match similar::did_you_mean(found, &known) {
        none if none.is_empty() => format!("unknown {what} `{found}`, expected {expected}"),
        hint => format!("unknown {what} `{found}`{hint}"),
    })
}

/// For a number such as `1000.0` in the start of a message, how it is written as a whole one.
fn whole_number_in(start: &str) -> String {
    let found = start.strip_prefix("invalid type: floating point `");
    let found = found.and_then(|rest| rest.split('`').next()?.parse::<f64>().ok());
    match found.filter(|n| n.fract() == 0.0 && (0.0..=f64::from(u32::MAX)).contains(n)) {
        Some(number) => format!("; write {number}"),
        None => String::new(),
    }
}

/// What [`plain_words`] says where a whole number of 32 bits is needed.
pub(crate) const WHOLE_NUMBER: &str = "expected a whole number from 0 to 4294967295";

/// What [`plain_words`] says of a kind that is written as a string.
pub(crate) const NEEDS_TABLE: &str =
    "a kind needs a table of fields, as `kind = { … }`; it may be empty";

/// The message of a text reader, in words for a user who does not know Rust.
pub fn plain_words(message: &str) -> String {
    let message = with_short_names(&message.replace('\n', "; "));
    if let Some(plain) = of_unknown(&message) {
        return plain;
    }
    let message = message.replacen("invalid type: map,", "invalid type: table,", 1);
    let message = message.replacen("invalid type: sequence,", "invalid type: list,", 1);
    for (technical, plain) in [
        ("expected u32", WHOLE_NUMBER),
        ("expected f64", "expected a number"),
        ("expected u64", "expected a whole number that is not negative"),
        ("expected a sequence", "expected a list"),
    ] {
        if let Some(start) = message.strip_suffix(technical) {
            let advice =
                if plain.contains("whole") { whole_number_in(start) } else { String::new() };
            return format!("{start}{plain}{advice}");
        }
    }
    if message.contains("recursion limit") || message.contains("max recursion depth") {
        return format!(
            "nested too deeply (at most 80 tables and lists fit in one another, and {MAX_NESTING} shapes)"
        );
    }
    if message.starts_with("wanted exactly 1 element") {
        return "exactly one kind is needed here, as `kind = { … }`".to_owned();
    }
    if message == "invalid type: unit variant, expected newtype variant" {
        return NEEDS_TABLE.to_owned();
    }
    if message == "wanted string or table" {
        return "a kind is needed here, as `kind = { … }`".to_owned();
    }
    message
}
