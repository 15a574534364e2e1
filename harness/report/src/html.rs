//! Texts, numbers and tables as HTML that is also well-formed XML.

use std::fmt::Write;

pub use pictures::html::escaped;

/// A table; its cells are HTML.
#[derive(Debug, Default)]
pub struct Table {
    /// The caption above the table.
    pub caption: String,
    /// Headings of groups of columns, with the number of columns; none if empty.
    pub groups: Vec<(String, usize)>,
    /// The headings of the columns.
    pub headings: Vec<String>,
    /// The rows; the first cell of a row is its name.
    pub rows: Vec<Vec<String>>,
}

impl Table {
    /// The table as markup.
    pub fn html(&self) -> String {
        let mut html = format!("<table>\n<caption>{}</caption>\n<thead>\n", self.caption);
        if !self.groups.is_empty() {
            html.push_str("<tr>");
            for (heading, columns) in &self.groups {
                let _ = write!(html, "<th class=\"group\" colspan=\"{columns}\">{heading}</th>");
            }
            html.push_str("</tr>\n");
        }
        let starts = self.starts();
        let class = |column: usize| if starts.contains(&column) { " class=\"start\"" } else { "" };
        html.push_str("<tr>");
        for (column, heading) in self.headings.iter().enumerate() {
            let _ = write!(html, "<th{}>{heading}</th>", class(column));
        }
        html.push_str("</tr>\n</thead>\n<tbody>\n");
        for row in &self.rows {
            html.push_str("<tr>");
            for (column, cell) in row.iter().enumerate() {
                let tag = if column == 0 { "th" } else { "td" };
                let _ = write!(html, "<{tag}{}>{cell}</{tag}>", class(column));
            }
            html.push_str("</tr>\n");
        }
        html + "</tbody>\n</table>\n"
    }

    /// The columns at which a group starts, except the first.
    fn starts(&self) -> Vec<usize> {
        let ends = self.groups.iter().scan(0, |end, (_, columns)| {
            *end += columns;
            Some(*end)
        });
        ends.collect()
    }
}

/// Content that is hidden below a summary line until a click.
pub fn folded(summary: &str, content: &str) -> String {
    format!("<details>\n<summary>{summary}</summary>\n{content}</details>\n")
}

/// A picture with a caption below it.
pub fn figure(svg: &str, caption: &str) -> String {
    format!("<figure>\n{svg}\n<figcaption>{caption}</figcaption>\n</figure>\n")
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
        2.. => format!("{x:.0}"),
        1 => format!("{x:.0}"),
        0 => digits.to_owned(),
        below => format!("{x:.*}", (1 - below) as usize),
    }
}

/// A number to two digits, or a dash for `None`.
pub fn short_or_dash(x: Option<f64>) -> String {
    x.map_or_else(|| "–".to_owned(), short)
}

/// An integer in superscript, for powers of ten: `⁻⁷`.
pub fn superscript(integer: &str) -> String {
    let raised = |c: char| match c {
        '-' => '⁻',
        '0' => '⁰',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        _ => c.to_digit(10).and_then(|d| char::from_u32('⁰' as u32 + d)).unwrap_or(c),
    };
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
