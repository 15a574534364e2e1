//! Percentages.

use groundtruth::math::power;

use text::percent::{of_pixels, percent, short, signed};

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

/// Law: each form of a percentage begins where it says: decimals end at 10 %, powers of ten begin at 1000 %; of pixels, at
/// least a thousandth of 1 % is told, three digits are, and 100 % from 99.95 % on. Oracle: numbers on both sides of each
/// border, by hand.
#[test]
fn forms_of_percentages_have_borders() {
    let cases = [
        (short(0.1), "10 %"),
        (short(0.0999), "9.99 %"),
        (percent(9.999, 0), "1000 %"),
        (percent(9.99, 1), "999.0 %"),
        (percent(10.0, 1), "1.00e3 %"),
        (percent(-10.0, 1), "-1.00e3 %"),
        (signed(-1e-9, 2), "−0.00 %"),
        (signed(1e-9, 2), "+0.00 %"),
        (of_pixels(0.000_01), "0.001 %"),
        (of_pixels(0.000_009_9), "less than 0.001 %"),
        (of_pixels(0.099_99), "9.999 %"),
        (of_pixels(0.1), "10.0 %"),
        (of_pixels(0.02), "2 %"),
        (of_pixels(0.025), "2.5 %"),
        (of_pixels(0.9994), "99.9 %"),
        (of_pixels(0.9996), "100 %"),
        (of_pixels(1.5), "150 %"),
    ];
    for (found, expected) in cases {
        assert_eq!(found, expected);
    }
}
