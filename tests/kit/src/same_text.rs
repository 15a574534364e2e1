//! Compares texts with numbers: words and integers exactly, other numbers within rounding.

use std::path::Path;

/// Numbers that are printed with all digits may differ by this share: the last few of their 17 digits
/// depend on the order of a sum.
const RELATIVE: f64 = 1e-12;
/// Absolute tolerance: the difference of nearly equal numbers of about 1 is only rounding.
const RESIDUE: f64 = 1e-16;
/// A number with fewer digits may have been rounded for printing.
const ALL_DIGITS: usize = 13;

/// How the numbers of a text were printed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Printed {
    /// With all digits.
    Exactly,
    /// Some rounded: numbers with fewer than 13 digits may differ by one unit of the last digit.
    Rounded,
}

/// A description of the first difference from the expected text; `None` if they are the same.
pub fn difference(found: &str, expected: &str, printed: Printed) -> Option<String> {
    let mut lines = (1..).zip(found.lines().zip(expected.lines()));
    let first = lines.find_map(|(number, (found, expected))| {
        let why = line_difference(found, expected, printed)?;
        Some(format!("line {number}: {why}\n   found: {found}\nexpected: {expected}"))
    });
    first.or_else(|| {
        let [found, expected] = [found, expected].map(|text| text.lines().count());
        (found != expected).then(|| format!("{found} lines, expected {expected}"))
    })
}

/// Holds a document to what it should say: up to rounding, they are the same.
///
/// With `RENEW_TEXTS` in the environment the document is written instead: `scripts/renew-texts.sh`.
///
/// # Panics
/// They differ, or the document cannot be read or written.
pub fn hold(document: &Path, should_say: &str, printed: Printed) {
    let says = std::fs::read_to_string(document).expect("it is there");
    let Some(wrong) = difference(should_say, &says, printed) else { return };
    let file = document.display();
    match std::env::var_os("RENEW_TEXTS") {
        Some(_) => std::fs::write(document, should_say).expect("it can be written"),
        None => panic!("{file}: {wrong}\nif that is right, renew it: scripts/renew-texts.sh"),
    }
}

fn line_difference(found: &str, expected: &str, printed: Printed) -> Option<String> {
    let [found, expected] = [found, expected].map(pieces);
    let mut pairs = found.iter().zip(&expected);
    let first = pairs.find_map(|(found, expected)| piece_difference(found, expected, printed));
    let (found, expected) = (found.len(), expected.len());
    first.or_else(|| (found != expected).then(|| "one line is longer".to_owned()))
}

/// The line split into numbers (without their signs) and the text between them.
fn pieces(line: &str) -> Vec<&str> {
    let mut pieces = Vec::new();
    let mut rest = line;
    while !rest.is_empty() {
        let number = number_length(rest);
        let length = if number > 0 { number } else { word_length(rest) };
        let (piece, after) = rest.split_at(length);
        pieces.push(piece);
        rest = after;
    }
    pieces
}

/// The length of the number at the start of a text: digits, and perhaps a fraction and an exponent.
fn number_length(text: &str) -> usize {
    let digits = |from: usize| text[from..].bytes().take_while(u8::is_ascii_digit).count();
    let mut length = digits(0);
    if length == 0 {
        return 0;
    }
    if text[length..].starts_with('.') && digits(length + 1) > 0 {
        length += 1 + digits(length + 1);
    }
    if text[length..].starts_with('e') {
        let sign = usize::from(text[length + 1..].starts_with(['+', '-']));
        let exponent = digits(length + 1 + sign);
        length += if exponent > 0 { 1 + sign + exponent } else { 0 };
    }
    length
}

/// The length of the text before the next number; digits within a name are part of the name.
fn word_length(text: &str) -> usize {
    let mut is_name = false;
    for (at, c) in text.char_indices() {
        if c.is_ascii_digit() && !is_name {
            return at;
        }
        is_name = c.is_alphabetic() || c == '_' || (is_name && c.is_ascii_digit());
    }
    text.len()
}

fn piece_difference(found: &str, expected: &str, printed: Printed) -> Option<String> {
    if found == expected {
        return None;
    }
    let words = || Some(format!("\"{found}\", expected \"{expected}\""));
    let (Ok(a), Ok(b)) = (found.parse::<f64>(), expected.parse::<f64>()) else { return words() };
    let unit = last_unit(found).min(last_unit(expected));
    let is_integer = |text: &str| !text.contains(['.', 'e']);
    if is_integer(found) && is_integer(expected) {
        return words();
    }
    let apart = (a - b).abs();
    let few = found.len().max(expected.len()) < ALL_DIGITS + 1;
    // numbers one unit apart may differ by slightly more, by rounding of the difference
    let is_rounded = printed == Printed::Rounded && few && apart <= 1.001 * unit;
    let is_same = apart <= RELATIVE * a.abs().max(b.abs()) || apart <= RESIDUE || is_rounded;
    (!is_same).then(|| format!("{found}, expected {expected}: {apart:e} apart"))
}

/// One unit of the last digit of a number.
fn last_unit(number: &str) -> f64 {
    let (mantissa, exponent) = number.split_once('e').unwrap_or((number, "0"));
    let decimals = mantissa.split_once('.').map_or(0, |(_, fraction)| fraction.len());
    let exponent = exponent.parse().unwrap_or(0) - decimals as i32;
    format!("1e{exponent}").parse().unwrap_or(0.0)
}

/// Law: words, signs and integers must be equal, numbers with all digits may differ by 1e-12, and rounded
/// numbers by one unit of the last digit if `Rounded` allows it. Oracle: pairs judged by hand.
#[test]
fn texts_are_the_same_up_to_the_rounding_of_their_numbers() {
    use Printed::{Exactly, Rounded};
    let same = [
        ("", "", Exactly),
        ("ray 12, η 1.5", "ray 12, η 1.5", Exactly),
        ("[-0.1807615224856393, 2]", "[-0.1807615224856401, 2]", Exactly),
        ("[3.0, 9.531222933115641e-18]", "[3.0, 0.0]", Exactly),
        ("0.30000000000000004", "0.3", Exactly),
        ("weight 0.049 × (0, 0.3)", "weight 0.048 × (0, 0.3)", Rounded),
        ("1.531", "1.532", Rounded),
        ("6.35e-4", "6.36e-4", Rounded),
        ("1", "0.999", Rounded),
    ];
    for (found, expected, printed) in same {
        assert_eq!(difference(found, expected, printed), None, "{found} and {expected}");
    }
    let different = [
        ("ray 12", "ray 13", Rounded),
        ("12 rays", "12 ray", Rounded),
        ("ch28", "ch27", Rounded),
        ("-0.5", "0.5", Rounded),
        ("0.1807615224856393", "0.1807615224866393", Rounded),
        ("0.049", "0.048", Exactly),
        ("0.049", "0.047", Rounded),
        ("one\ntwo", "one", Rounded),
        ("0.5 and", "0.5", Rounded),
        ("1.0e5", "1.0e6", Rounded),
    ];
    for (found, expected, printed) in different {
        assert!(difference(found, expected, printed).is_some(), "{found} is not {expected}");
    }
    let said = difference("a 1.25", "a 1.5", Exactly).expect("they differ");
    assert_eq!(said, "line 1: 1.25, expected 1.5: 2.5e-1 apart\n   found: a 1.25\nexpected: a 1.5");
}
