//! What to write in place of a line that is not TOML, for mistakes that people make.

use groundtruth::invalid::BACKSLASH;

/// The error of the TOML parser in this line, and what to write.
pub(super) fn with_advice(problem: &str, line: &str) -> String {
    match advice(line) {
        Some(advice) => format!("{problem}: {advice}"),
        None => problem.to_owned(),
    }
}

/// The byte offset of a bracket that is not closed where a text that is not TOML fails, and what to
/// write. A list or a table of several lines begins with a bracket at the end of its line; another
/// is missing its end there.
pub(super) fn unclosed(text: &str, at: usize) -> Option<(usize, String)> {
    let line = text[..at].rfind('\n').map_or(0, |end| end + 1);
    let rest = text[line..].lines().next().unwrap_or_default();
    let is_next_entry = |rest: &str| {
        let key = rest.split_once('=').map_or("", |(key, _)| key).trim();
        let is_key = |c: char| c.is_alphanumeric() || "_-.\"".contains(c);
        let header = rest.trim_start_matches('[');
        (!key.is_empty() && key.chars().all(is_key))
            || (header.len() < rest.len() && header.starts_with(char::is_alphabetic))
    };
    let is_end = text[at..].trim().is_empty();
    let before = if is_end { text } else { &text[..line] };
    let (open, bracket) = brackets(before).pop()?;
    let begins_block = text[open + 1..].lines().next().is_some_and(|rest| rest.trim().is_empty());
    let close = if bracket == '[' { ']' } else { '}' };
    let problem = format!("this `{bracket}` is not closed; write its `{close}`");
    (is_end || (is_next_entry(rest) && !begins_block)).then_some((open, problem))
}

/// The brackets that are open at the end of a text, with their byte offsets; none in texts and
/// comments.
fn brackets(text: &str) -> Vec<(usize, char)> {
    let (mut open, mut quote, mut letters) = (Vec::new(), None, text.char_indices());
    while let Some((at, letter)) = letters.next() {
        match (quote, letter) {
            // a text of one line ends with it
            (Some(_), '\n') => quote = None,
            (Some('"'), '\\') => drop(letters.next()),
            (Some(end), _) if end == letter => quote = None,
            (Some(_), _) => {}
            (None, '"' | '\'' | '#') => {
                quote = Some(letter).map(|mark| if mark == '#' { '\n' } else { mark })
            }
            (None, '[' | '{') => open.push((at, letter)),
            (None, ']' | '}') => drop(open.pop()),
            _ => {}
        }
    }
    open
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
