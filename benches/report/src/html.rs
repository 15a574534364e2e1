//! Texts, numbers and tables as HTML that is also well-formed XML.

use std::fmt::Write;

use groundtruth::film::{Film, OutOfGamut, Tone, data_uri};
pub use pictures::html::escaped;

/// A table whose rows are drawn from values `R`; its caption, headings and cells are HTML.
pub struct Table<'a, R> {
    caption: String,
    groups: Vec<Group>,
    columns: Vec<Column<'a, R>>,
}

/// Neighbouring columns.
struct Group {
    /// The heading above those of the columns; may be empty.
    heading: String,
    columns: usize,
}

struct Column<'a, R> {
    heading: String,
    /// The attribute of its cells.
    class: &'static str,
    cell: Box<dyn Fn(&R) -> String + 'a>,
}

impl<'a, R> Table<'a, R> {
    /// A table with this caption above it, and no columns.
    pub fn new(caption: impl Into<String>) -> Self {
        Self { caption: caption.into(), groups: Vec::new(), columns: Vec::new() }
    }

    /// The table with a heading above its next columns.
    pub fn group(mut self, heading: impl Into<String>) -> Self {
        self.groups.push(Group { heading: heading.into(), columns: 0 });
        self
    }

    /// The table with one more column. The cells of the first one are the names of the rows.
    pub fn column(mut self, heading: impl ToString, cell: impl Fn(&R) -> String + 'a) -> Self {
        let mut class = "";
        let is_later = self.groups.len() > 1;
        if let Some(group) = self.groups.last_mut() {
            if is_later && group.columns == 0 {
                class = " class=\"start\"";
            }
            group.columns += 1;
        }
        let heading = heading.to_string();
        self.columns.push(Column { heading, class, cell: Box::new(cell) });
        self
    }

    /// The table as markup.
    pub fn html<'r>(&self, rows: impl IntoIterator<Item = &'r R>) -> String
    where
        R: 'r,
    {
        let mut html = format!("<table>\n<caption>{}</caption>\n<thead>\n", self.caption);
        if !self.groups.is_empty() {
            html.push_str("<tr>");
            for Group { heading, columns } in &self.groups {
                let _ = write!(html, "<th class=\"group\" colspan=\"{columns}\">{heading}</th>");
            }
            html.push_str("</tr>\n");
        }
        html.push_str("<tr>");
        for Column { heading, class, .. } in &self.columns {
            let _ = write!(html, "<th{class}>{heading}</th>");
        }
        html.push_str("</tr>\n</thead>\n<tbody>\n");
        for row in rows {
            html.push_str("<tr>");
            for (index, Column { class, cell, .. }) in self.columns.iter().enumerate() {
                let tag = if index == 0 { "th" } else { "td" };
                let _ = write!(html, "<{tag}{class}>{}</{tag}>", cell(row));
            }
            html.push_str("</tr>\n");
        }
        html + "</tbody>\n</table>\n"
    }
}

/// A heading, and a description below it.
pub fn heading(name: &str, about: &str) -> String {
    format!("<h3>{}</h3>\n<p>{}</p>\n", capital(name), escaped(about))
}

/// A recommendation, and the words before it.
pub fn pick(before: &str, words: &str) -> String {
    format!("<p class=\"pick\"><strong>{before}</strong> {words}</p>\n")
}

/// Content that is hidden below a summary line until a click.
pub fn folded(summary: &str, content: &str) -> String {
    format!("<details>\n<summary>{summary}</summary>\n{content}</details>\n")
}

/// A picture with a caption below it.
pub fn figure(svg: &str, caption: &str) -> String {
    format!("<figure>\n{svg}\n<figcaption>{caption}</figcaption>\n</figure>\n")
}

/// A rendered picture with a caption below it.
pub fn film(film: &Film, exposure: f64, alt: &str, caption: &str) -> String {
    let tone = Tone { exposure, gamma: 2.2, out_of_gamut: OutOfGamut::MaxToOne };
    let data = data_uri(film, &tone);
    figure(&format!("<img alt=\"{}\" src=\"{data}\"/>", escaped(alt)), caption)
}

/// Figures beside each other: diagrams (`pictures`) or small pictures (`crops`).
pub fn row(class: &str, figures: &[String]) -> String {
    format!("<div class=\"{class}\">\n{}</div>\n", figures.concat())
}

/// The words with a capital first letter.
pub fn capital(words: &str) -> String {
    let mut letters = words.chars();
    letters.next().map_or(String::new(), |first| first.to_uppercase().chain(letters).collect())
}

/// A number to two digits: `0.031`, `4.2`, `350`, `1.2·10⁷`.
pub fn short(x: f64) -> String {
    if x == 0.0 {
        return "0".to_owned();
    }
    let scientific = format!("{x:.1e}");
    let (digits, exponent) = scientific.split_once('e').unwrap_or((&scientific, "0"));
    match exponent.parse::<i32>().unwrap_or(0) {
        4.. | ..-3 => format!("{digits}·10{}", superscript(exponent)),
        1.. => format!("{x:.0}"),
        0 => digits.to_owned(),
        below => format!("{x:.*}", (1 - below) as usize),
    }
}

/// What stands in the place of a number that does not exist.
pub const DASH: &str = "–";

/// A number to two digits, or a dash for `None`.
pub fn short_or_dash(x: Option<f64>) -> String {
    x.map_or_else(|| DASH.to_owned(), short)
}

/// A text with minus signs instead of hyphens.
pub fn with_minus(number: &str) -> String {
    number.replace('-', "−")
}

/// An integer in superscript, for powers of ten: `⁻⁷`.
pub fn superscript(integer: &str) -> String {
    const DIGITS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let raised = |c: char| c.to_digit(10).map_or('⁻', |digit| DIGITS[digit as usize]);
    integer.chars().map(raised).collect()
}

/// A time, with a mark if its measurement was disturbed.
pub fn flagged(time: String, disturbed: bool) -> String {
    if disturbed { format!("{time} <span class=\"bad\">‡</span>") } else { time }
}

/// Seconds with a suitable unit: `35 ns`, `1.2 ms`.
pub fn time(seconds: f64) -> String {
    for (unit, size) in [("s", 1.0), ("ms", 1e-3), ("µs", 1e-6)] {
        if seconds >= size {
            return format!("{} {unit}", short(seconds / size));
        }
    }
    format!("{} ns", short(seconds / 1e-9))
}

/// Bytes with a suitable unit.
pub fn bytes(count: f64) -> String {
    for (unit, size) in [("GB", 1e9), ("MB", 1e6), ("kB", 1e3)] {
        if count >= size {
            return format!("{} {unit}", short(count / size));
        }
    }
    format!("{count} B")
}

/// A count with spaces between groups of three digits: `31 623`.
pub fn count(n: usize) -> String {
    let digits = n.to_string();
    let mut text = String::new();
    for (index, digit) in digits.chars().enumerate() {
        if index > 0 && (digits.len() - index).is_multiple_of(3) && digits.len() > 4 {
            text.push('\u{202f}'); // narrow no-break space
        }
        text.push(digit);
    }
    text
}

/// `a`, `a and b`, `a, b and c`.
pub fn listed(words: &[String]) -> String {
    match words {
        [] => "none".to_owned(),
        [one] => one.clone(),
        [first @ .., last] => format!("{} and {last}", first.join(", ")),
    }
}

/// ` (or a and b, about as good)`; nothing for none.
pub fn or_as_good(words: &[String]) -> String {
    match words {
        [] => String::new(),
        words => format!(" (or {}, about as good)", listed(words)),
    }
}
