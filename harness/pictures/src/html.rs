//! HTML pages that need nothing beside them, and no script.

use groundtruth::printable;

/// The rules that all pages have in common.
const STYLE: &str = "\
body { font: 15px/1.4 system-ui, sans-serif; margin: 2em auto; max-width: 80em; padding: 0 1em; }
pre { white-space: pre-wrap; overflow-wrap: anywhere; }
table { border-collapse: collapse; }
";

/// Rules for tables: lines between the rows.
pub const LINES: &str = "\
th, td { padding: 0.1em 0.8em; text-align: left; }
tr { border-bottom: 1px solid #ddd; }
";

/// Rules for tables of numbers whose first column has the names of rows; after [`LINES`].
pub const NUMBERS: &str = "\
th, td { text-align: right; font-variant-numeric: tabular-nums; }
th:first-child, td:first-child { text-align: left; }
";

/// Rules for cards of answers: what failed, what says little, and details.
pub const CARD: &str = "\
.failed { background: #fdd; }
.quiet { color: #999; }
pre { background: #f4f4f4; padding: 0.5em; }
";

/// A whole page: its title (escaped), the rules that it adds to the common style, and its body.
pub fn page(title: &str, rules: &[&str], body: &str) -> String {
    let rules = rules.concat();
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n\
         <title>{title}</title>\n<style>\n{STYLE}{rules}</style>\n</head>\n<body>\n\
         {body}</body>\n</html>\n"
    )
}

/// The text as markup shows it, also between the double quotes of an attribute: characters of markup are escaped, and
/// what a reader's program may obey instead of showing it (control characters, direction marks) becomes `\u{202e}`. Ends
/// of lines and tabs stay.
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
