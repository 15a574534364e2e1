//! Percentages.

use groundtruth::math::power;

use pictures::percent::{percent, short, signed};

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
