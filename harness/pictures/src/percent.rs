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

#[cfg(test)]
mod tests {
    use groundtruth::math::power;

    use super::{percent, short, signed};

    /// Law: a percentage has few characters whatever the number is, its sign, and its value to three digits. Oracle:
    /// numbers written by hand, and the number read back.
    #[test]
    fn percentages_are_short_and_true() {
        assert_eq!(percent(0.0208, 2), "2.08 %");
        assert_eq!([signed(-0.7055, 2), signed(0.0, 2)], ["−70.55 %", "+0.00 %"]);
        assert_eq!([short(0.0657), short(0.16)], ["6.57 %", "16 %"]);
        assert_eq!(signed(3.456e38, 2), "+3.46e40 %");
        for exponent in -300..300 {
            let part = 1.234 * power(10.0, f64::from(exponent));
            let text = signed(-part, 3);
            assert!(text.chars().count() <= 12, "{text}");
            let read: f64 = text[3..].trim_end_matches(" %").parse().expect("a number");
            assert!((read - 100.0 * part).abs() <= 5e-3 * (100.0 * part) + 5e-4, "{text}");
        }
    }
}
