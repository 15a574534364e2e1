//! Percentages of relative differences, one form for text and pages.

/// From so many per cent on, three digits and a power of ten are printed: a mean may be 10⁻⁴⁰ of another.
const LARGE: f64 = 1000.0;

/// `2.08 %`, or `2.08e30 %`: a part of 1 with so many decimals, or with three digits if it is large.
pub fn percent(part: f64, decimals: usize) -> String {
    match 100.0 * part {
        large if large.abs() >= LARGE => format!("{large:.2e} %"),
        small => format!("{small:.decimals$} %"),
    }
}

/// The same with its sign: `+2.08 %`, `−2.08 %`.
pub fn signed(part: f64, decimals: usize) -> String {
    let sign = if part < 0.0 { "−" } else { "+" };
    format!("{sign}{}", percent(part.abs(), decimals))
}

/// With two decimals, and none from 10 % on.
pub fn short(part: f64) -> String {
    percent(part, if part >= 0.1 { 0 } else { 2 })
}

/// A part of pixels or of a difference, with three digits: `55.0 %`, `0.463 %`; below a thousandth of 1 % it says so.
pub fn of_pixels(part: f64) -> String {
    match 100.0 * part {
        0.0 => "0 %".to_owned(),
        small if small < 0.001 => "less than 0.001 %".to_owned(),
        small if small < 10.0 => {
            format!("{} %", format!("{small:.3}").trim_end_matches('0').trim_end_matches('.'))
        }
        large if large >= 99.95 => format!("{large:.0} %"),
        large => format!("{large:.1} %"),
    }
}
