//! Numbers for people.

use text::digits::{rough, short, shortened};

/// Law: a number of any size is told with at most four digits, and at most half a unit of the fourth off. Oracle: the text
/// read again.
#[test]
fn numbers_have_four_digits() {
    let mut value = 1.234_567_89e-12;
    while value < 1e15 {
        for x in [value, -value] {
            let text = short(x);
            let read: f64 = text.parse().expect("a number");
            assert!((read - x).abs() <= 0.5e-3 * x.abs(), "{x}: {text}");
            let mantissa = text.split('e').next().unwrap_or_default();
            let digits = mantissa.trim_start_matches(['-', '0', '.']);
            assert!(digits.chars().filter(char::is_ascii_digit).count() <= 5, "{x}: {text}");
        }
        value *= 3.7;
    }
    let told = [0.0, -0.0, 0.5, 1.0, 0.003_921_57, 99_999.9, f64::INFINITY].map(short);
    assert_eq!(told, ["0", "0", "0.5", "1", "0.003922", "1e5", "inf"]);
    let told = [0.0, 4.21, 35.4, 349.6, 0.0312, 1.23e7, 9.96, 99.6, 4.4e-9].map(rough);
    assert_eq!(told, ["0", "4.2", "35", "350", "0.031", "1.2e7", "10", "100", "4.4e-9"]);
}

/// Law: long numbers of a text are shortened; words, names with digits, counts and short numbers stay. Oracle: texts by hand.
#[test]
fn long_numbers_of_texts_are_shortened() {
    let text =
        "wi2 = [-0.7674417887673955, 0.5], 123456 of ch03 ± 2e-4, 5.564717e-3, m2.500001.pfm";
    assert_eq!(
        shortened(text),
        "wi2 = [-0.7674, 0.5], 123456 of ch03 ± 2e-4, 0.005565, m2.500001.pfm"
    );
}
