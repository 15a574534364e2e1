//! HTML pages that need nothing beside them; what a script adds, they can be read without.

use groundtruth::printable;

use super::document::{Element, Node};

/// The rules that all pages have in common: light or dark as the reader's system is, light on paper; nothing is wider than
/// a telephone but tables, which scroll by themselves.
const STYLE: &str = "\
:root { color-scheme: light dark; --ink: #111; --paper: #fff; --line: #ddd; --quiet: #6b6b6b; --bad: #fdd; --box: #f4f4f4; \
--edge: #999; --mark: #c60; }
@media screen and (prefers-color-scheme: dark) {
  :root { --ink: #e4e4e4; --paper: #15171a; --line: #3a3d42; --quiet: #a0a4aa; --bad: #5c2327; --box: #22252a; \
--edge: #666; --mark: #f80; }
}
body { font: 15px/1.45 system-ui, sans-serif; color: var(--ink); background: var(--paper); margin: 1.5em auto; \
max-width: 100em; padding: 0 1em; overflow-wrap: anywhere; }
h1 { font-size: 1.4em; line-height: 1.3; max-width: 50em; margin: 0.2em 0 0.8em; }
h2 { font-size: 1.15em; margin: 1.4em 0 0.4em; break-after: avoid; }
h3 { font-size: 1em; margin: 1em 0 0.3em; break-after: avoid; }
p { max-width: 60em; }
.about { color: var(--quiet); margin: 0; }
.next code { font-size: 1em; }
a { color: inherit; }
img { max-width: 100%; }
pre { white-space: pre-wrap; overflow-wrap: anywhere; }
code { font-size: 90%; user-select: all; overflow-wrap: anywhere; }
table { border-collapse: collapse; overflow-wrap: normal; }
tbody th { font-weight: normal; }
.wide { overflow-x: auto; }
tr, figure { break-inside: avoid; }
@media print {
  body { margin: 0; max-width: none; font-size: 10pt; }
  .wide { overflow: visible; }
  table { font-size: 8.5pt; }
  .wide th, .wide td { padding: 0.1em 0.4em; }
  img, .ramp, .failed { print-color-adjust: exact; -webkit-print-color-adjust: exact; }
}
";

/// Rules for tables: lines between the rows.
pub const LINES: &str = "\
th, td { padding: 0.1em 0.8em; text-align: left; }
tr { border-bottom: 1px solid var(--line); }
";

/// Rules for tables of numbers whose first column has the names of rows; after [`LINES`].
pub const NUMBERS: &str = "\
th, td { text-align: right; font-variant-numeric: tabular-nums; }
th:first-child, td:first-child { text-align: left; }
";

/// Rules for cards of answers: what failed, what says little, and details.
pub const CARD: &str = "\
.failed { background: var(--bad); }
.quiet { color: var(--quiet); }
pre { background: var(--box); padding: 0.5em; }
";

/// The class of two pictures one over the other, of which a checkbox shows the second.
pub const FLIP: &str = "flip";

/// For pages with such pictures: F flips all of them; + and − make pictures larger and smaller by the factor `--zoom` of
/// the rules, up to 16 times. Without it the checkboxes flip, and the browser zooms.
const SCRIPT: &str = "\
<script>
let zoom = 1;
addEventListener('keydown', event => {
  if (event.ctrlKey || event.altKey || event.metaKey) return;
  const key = event.key.toLowerCase();
  if (key == 'f') document.querySelectorAll('.flip input').forEach(box => box.checked = !box.checked);
  zoom = Math.min(16, Math.max(1, zoom * ({ '+': 2, '=': 2, '-': 0.5 }[key] || 1)));
  document.documentElement.style.setProperty('--zoom', zoom);
});
</script>
";

/// A whole page: its title (escaped), the rules that it adds to the common style, and its body; with a script if it has
/// pictures that flip.
pub fn page(title: &str, rules: &[&str], body: &str) -> String {
    let rules = rules.concat();
    let has_flip = body.contains(&format!("class=\"{FLIP}\""));
    let script = if has_flip { SCRIPT } else { "" };
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n\
         <title>{title}</title>\n<style>\n{STYLE}{rules}</style>\n</head>\n<body>\n\
         {body}{script}</body>\n</html>\n"
    )
}

/// Elements that have no content, and no end.
const EMPTY: [&str; 3] = ["br", "img", "input"];
/// Elements after which the next one begins a line.
const LINE: [&str; 19] = [
    "caption",
    "details",
    "div",
    "figcaption",
    "figure",
    "h1",
    "h2",
    "h3",
    "li",
    "p",
    "pre",
    "section",
    "summary",
    "table",
    "tbody",
    "thead",
    "tr",
    "ul",
    "br",
];

impl Element {
    /// The element as markup, which is well-formed XML, too.
    pub fn html(&self) -> String {
        let mut html = String::new();
        self.write(&mut html);
        html
    }

    fn write(&self, html: &mut String) {
        let Self { name, attributes, children } = self;
        if !name.is_empty() {
            *html += &format!("<{name}");
            for (attribute, value) in attributes {
                *html += &format!(" {attribute}=\"{}\"", escaped(value));
            }
            *html += if EMPTY.contains(name) { "/>" } else { ">" };
        }
        for child in children {
            match child {
                Node::Text(text) => *html += &escaped(text),
                Node::Drawing(svg) => *html += svg,
                Node::Element(element) => element.write(html),
            }
        }
        if !name.is_empty() && !EMPTY.contains(name) {
            *html += &format!("</{name}>");
        }
        if LINE.contains(name) {
            html.push('\n');
        }
    }
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
