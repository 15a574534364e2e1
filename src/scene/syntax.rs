//! What to write in place of a line that is not TOML, for mistakes that people make.

use crate::invalid::BACKSLASH;

/// The error of the TOML parser in this line, and what to write.
pub(super) fn with_advice(problem: &str, line: &str) -> String {
    match advice(line) {
        Some(advice) => format!("{problem}: {advice}"),
        None => problem.to_owned(),
    }
}

fn advice(line: &str) -> Option<String> {
    let is_escape = |text: &str| text.contains('\\');
    // every second part stands in double quotes
    if line.split('"').skip(1).step_by(2).any(is_escape) {
        return Some(BACKSLASH.to_owned());
    }
    let code = line.split('#').next().unwrap_or_default();
    if let Some((key, value)) = code.split_once('=') {
        let (key, value) = (key.trim(), value.trim());
        return of_number(code).or_else(|| bare_word(key, value));
    }
    let (key, value) = code.split_once(':')?;
    Some(format!("write `{} = {}`", key.trim(), value.trim()))
}

/// A decimal comma, and a number that begins or ends with its point.
fn of_number(code: &str) -> Option<String> {
    for (at, _) in code.match_indices('=') {
        let value = code[at + 1..].trim_start();
        let sign = if value.starts_with('-') { "-" } else { "" };
        let value = &value[sign.len()..];
        let (whole, rest) = digits(value);
        let Some(mark) = rest.chars().next().filter(|c| matches!(c, ',' | '.')) else { continue };
        let (fraction, after) = digits(&rest[1..]);
        let is_comma = mark == ',' && !whole.is_empty() && !fraction.is_empty();
        // the next key of a table may be a number, too
        if is_comma && !after.trim_start().starts_with(['=', '.']) {
            let found = &value[..value.len() - after.len()];
            return Some(format!(
                "write `{sign}{whole}.{fraction}` with a point, not `{sign}{found}`"
            ));
        }
        if mark == '.' && whole.is_empty() != fraction.is_empty() {
            let or_zero = |digits: &str| if digits.is_empty() { "0" } else { digits }.to_owned();
            let [whole, fraction] = [whole, fraction].map(or_zero);
            return Some(format!("write `{sign}{whole}.{fraction}`, with digits on both sides"));
        }
    }
    None
}

/// The digits that a text begins with, and the rest.
fn digits(text: &str) -> (&str, &str) {
    text.split_at(text.bytes().take_while(u8::is_ascii_digit).count())
}

/// A word without quotes.
fn bare_word(key: &str, value: &str) -> Option<String> {
    let is_word = value.starts_with(|c: char| c.is_alphabetic())
        && value.chars().all(|c| c.is_alphanumeric() || "_- /.".contains(c));
    is_word.then(|| format!("write `{key} = \"{value}\"`"))
}
