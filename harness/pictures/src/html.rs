//! Text in HTML pages.

use groundtruth::printable;

/// For text, and for attributes between double quotes: the text with the characters of markup escaped, and what a reader's program may obey instead of showing it (control
/// characters, direction marks) as `\u{202e}`. Ends of lines and tabs stay.
pub fn escaped(text: &str) -> String {
    let mut html = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => html += "&amp;",
            '<' => html += "&lt;",
            '>' => html += "&gt;",
            '"' => html += "&quot;",
            '\n' | '\t' => html.push(c),
            c if printable::is_obeyed(c) => html.extend(c.escape_unicode()),
            c => html.push(c),
        }
    }
    html
}
