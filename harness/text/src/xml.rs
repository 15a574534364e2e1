//! Text in XML 1.0 (W3C, *Extensible Markup Language*, fifth edition).

use groundtruth::printable;

/// Whether a document may hold the character: the production `Char`.
fn is_char(c: char) -> bool {
    matches!(c, '\t' | '\n' | '\r' | ' '..='\u{d7ff}' | '\u{e000}'..='\u{fffd}' | '\u{10000}'..)
}

/// The text with what a document cannot hold, and what a terminal obeys, as `\u{fffe}`; ends of lines and tabs stay. Markup
/// is not escaped.
pub fn held(text: &str) -> String {
    let mut held = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '\n' | '\t' => held.push(c),
            c if !is_char(c) || printable::is_obeyed(c) => held.extend(c.escape_unicode()),
            c => held.push(c),
        }
    }
    held
}

/// The value of an attribute between double quotes.
pub fn attribute(value: &str) -> String {
    let mut text = String::with_capacity(value.len());
    for c in held(value).chars() {
        match c {
            '&' => text += "&amp;",
            '<' => text += "&lt;",
            '>' => text += "&gt;",
            '"' => text += "&quot;",
            // a reader would make spaces of them
            '\n' => text += "&#10;",
            '\t' => text += "&#9;",
            c => text.push(c),
        }
    }
    text
}

/// A comment. Two hyphens would end it: a space parts them.
pub fn comment(text: &str) -> String {
    let mut inner = String::with_capacity(text.len());
    for c in held(text).chars() {
        if c == '-' && inner.ends_with('-') {
            inner.push(' ');
        }
        inner.push(c);
    }
    format!("<!-- {inner} -->")
}
