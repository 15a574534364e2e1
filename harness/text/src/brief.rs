//! Numbers, colours and counts in a sentence or a line of a table: three digits.

use groundtruth::rgb::Rgb;

/// A colour as `(0.12, 0.03, 0.03)`, a grey as `0.5`, shortened for people.
pub fn short(color: Rgb) -> String {
    let [r, g, b] = color.to_array().map(brief);
    if color == Rgb::grey(color.r) { r } else { format!("({r}, {g}, {b})") }
}

/// Three significant digits, or so.
pub fn brief(x: f64) -> String {
    match x.abs() {
        0.0 => "0".to_owned(),
        a if (1e-3..1e4).contains(&a) => format!("{}", (x * 1e3).round() / 1e3),
        _ => format!("{x:.2e}"),
    }
}

/// `83 %`, `0.4 %`.
pub fn percent(share: f64) -> String {
    match 100.0 * share {
        0.0 => "0 %".to_owned(),
        p if p.abs() < 0.05 => "< 0.1 %".to_owned(),
        p if p.abs() < 9.95 => format!("{p:.1} %"),
        p => format!("{p:.0} %"),
    }
}

/// `1 ray`, `2 rays`.
pub fn count(number: usize, thing: &str) -> String {
    format!("{number} {thing}{}", if number == 1 { "" } else { "s" })
}
