//! Numbers for people: four digits. Files of JSON, and questions and commands that are copied, keep all digits.

use std::ops::RangeInclusive;

use groundtruth::rgb::Rgb;

/// A number with four digits at most: `0.003922`, `1.813`, `2.15e-7`; 0 only if it is nought.
pub fn short(x: f64) -> String {
    with_digits(x, 4, -4..=4)
}

/// A number with two digits at most, as those of measurements: `0.031`, `350`, `1.2e7`.
pub fn rough(x: f64) -> String {
    with_digits(x, 2, -4..=3)
}

/// A number with so many digits, and with a power of ten unless its power is one of these.
fn with_digits(x: f64, digits: usize, plain: RangeInclusive<i32>) -> String {
    if x == 0.0 || !x.is_finite() {
        return format!("{}", x + 0.0);
    }
    let scientific = format!("{x:.*e}", digits - 1);
    let (mantissa, exponent) = scientific.split_once('e').unwrap_or((&scientific, "0"));
    let trimmed = |number: &str| match number.contains('.') {
        true => number.trim_end_matches('0').trim_end_matches('.').to_owned(),
        false => number.to_owned(),
    };
    match exponent.parse::<i32>().unwrap_or(0) {
        exponent if plain.contains(&exponent) => {
            trimmed(&format!("{x:.*}", (digits as i32 - 1 - exponent).max(0) as usize))
        }
        _ => format!("{}e{exponent}", trimmed(mantissa)),
    }
}

/// The same of three: `(0.2383, 0.2539, 0.2376)`.
pub fn three(numbers: [f64; 3]) -> String {
    format!("({})", numbers.map(short).join(", "))
}

/// Three numbers with all their digits.
pub fn exact([x, y, z]: [f64; 3]) -> String {
    format!("({x:?}, {y:?}, {z:?})")
}

/// A colour with all its digits: one number if its channels are equal.
pub fn exact_color(color: Rgb) -> String {
    if color == Rgb::grey(color.r) { format!("{:?}", color.r) } else { exact(color.to_array()) }
}

/// A text whose long numbers have four digits; words, and names with digits in them, stay.
pub fn shortened(text: &str) -> String {
    let mut result = String::with_capacity(text.len());
    let mut rest = text;
    let mut is_in_name = false;
    while let Some(c) = rest.chars().next() {
        let length = if is_in_name { 0 } else { number(rest) };
        match rest[..length].parse::<f64>() {
            Ok(value) if digits(&rest[..length]) > LONG => result += &short(value),
            _ if length > 0 => result += &rest[..length],
            _ => result.push(c),
        }
        is_in_name = length == 0 && (c.is_alphanumeric() || c == '_');
        rest = &rest[length.max(c.len_utf8())..];
    }
    result
}

/// Numbers of more digits are shortened.
const LONG: usize = 4;

/// The length of the decimal number with which a text begins, 0 if there is none.
fn number(text: &str) -> usize {
    let count = |from: usize| text[from..].bytes().take_while(u8::is_ascii_digit).count();
    let mut length = count(0);
    if length == 0 {
        return 0;
    }
    if text[length..].starts_with('.') && count(length + 1) > 0 {
        length += 1 + count(length + 1);
    }
    if text[length..].starts_with('e') {
        let sign = usize::from(text[length + 1..].starts_with(['+', '-']));
        let exponent = count(length + 1 + sign);
        length += if exponent > 0 { 1 + sign + exponent } else { 0 };
    }
    length
}

/// How many digits the mantissa of a number with a fraction or an exponent has; none of an integer, which is a count.
fn digits(number: &str) -> usize {
    if !number.contains(['.', 'e']) {
        return 0;
    }
    let (mantissa, _) = number.split_once('e').unwrap_or((number, ""));
    mantissa.trim_start_matches(['0', '.']).bytes().filter(u8::is_ascii_digit).count()
}
