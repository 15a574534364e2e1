//! Words, cells and figures that the pages share.

use groundtruth::film::{Film, OutOfGamut, Tone};
use text::digits::rough;
use text::document::*;

/// The heading of a part of a page, and a description below it.
pub fn beginning(name: &str, about: impl Into<Node>) -> Element {
    several().with(heading(3, capital(name))).with(paragraph(about))
}

/// A recommendation, and the words before it.
pub fn pick(before: &str, words: String) -> Element {
    let before = element("strong").with(before);
    element("p").class("pick").with(before).with(format!(" {words}"))
}

/// A rendered picture with a caption below it.
pub fn film(film: &Film, exposure: f64, alt: &str, caption: String) -> Element {
    let tone = Tone { exposure, gamma: 2.2, out_of_gamut: OutOfGamut::MaxToOne };
    figure(image(film, &tone, alt), caption)
}

/// The words with a capital first letter.
pub fn capital(words: &str) -> String {
    let mut letters = words.chars();
    letters.next().map_or(String::new(), |first| first.to_uppercase().chain(letters).collect())
}

/// What stands in the place of a number that does not exist.
pub const DASH: &str = "–";

/// A number to two digits, or a dash for `None`.
pub fn rough_or_dash(x: Option<f64>) -> String {
    x.map_or_else(|| DASH.to_owned(), rough)
}

/// A text with minus signs instead of hyphens.
pub fn with_minus(number: &str) -> String {
    number.replace('-', "−")
}

/// Words of a cell that is marked.
pub fn bad(words: impl ToString) -> Element {
    span("bad", words.to_string())
}

/// A time, with a mark if its measurement was disturbed.
pub fn flagged(time: String, disturbed: bool) -> Element {
    let mark = disturbed.then(|| several().with(" ").with(bad("‡")));
    several().with(time).with_all(mark)
}

/// Seconds with a suitable unit: `35 ns`, `1.2 ms`.
pub fn time(seconds: f64) -> String {
    with_unit(seconds, [("s", 1.0), ("ms", 1e-3), ("µs", 1e-6), ("ns", 1e-9)])
}

/// Bytes with a suitable unit.
pub fn bytes(count: f64) -> String {
    with_unit(count, [("GB", 1e9), ("MB", 1e6), ("kB", 1e3), ("B", 1.0)])
}

fn with_unit(x: f64, units: [(&str, f64); 4]) -> String {
    let fits = |(_, size): &&(&str, f64)| x >= *size;
    let (unit, size) = units.iter().find(fits).unwrap_or(&units[3]);
    format!("{} {unit}", rough(x / size))
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
pub fn listed(words: impl IntoIterator<Item = impl ToString>) -> String {
    listed_in("", words, "").unwrap_or_else(|| "none".to_owned())
}

/// ` (or a and b, about as good)`; nothing for none.
pub fn or_as_good(words: impl IntoIterator<Item = impl ToString>) -> String {
    listed_in(" (or ", words, ", about as good)").unwrap_or_default()
}

/// The list with words before and after it; `None` for none.
pub fn listed_in(
    before: &str,
    words: impl IntoIterator<Item = impl ToString>,
    after: &str,
) -> Option<String> {
    let words: Vec<String> = words.into_iter().map(|word| word.to_string()).collect();
    let list = match &words[..] {
        [] => return None,
        [one] => one.clone(),
        [first @ .., last] => format!("{} and {last}", first.join(", ")),
    };
    Some(format!("{before}{list}{after}"))
}
