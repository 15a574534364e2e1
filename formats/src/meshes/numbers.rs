//! Numbers as programs write them, also those that are not numbers.

use super::parse_word;

/// The number that a word means: what Rust reads, and the words that C libraries write for what is
/// not a number, as `-nan(ind)`, `nan(0x8000)`, `1.#QNAN` and `-1.#IND00`.
pub(super) fn parse_number(word: &[u8]) -> Option<f64> {
    parse_word(word).or_else(|| is_no_number(word).then_some(f64::NAN))
}

/// The same in single precision, as a binary file has it.
pub(super) fn parse_single(word: &[u8]) -> Option<f64> {
    let single: Option<f32> = parse_word(word);
    single.map(f64::from).or_else(|| is_no_number(word).then_some(f64::NAN))
}

fn is_no_number(word: &[u8]) -> bool {
    let word = word.strip_prefix(b"-").or(word.strip_prefix(b"+")).unwrap_or(word);
    let lower = word.to_ascii_lowercase();
    match lower.strip_prefix(b"nan(") {
        Some(rest) => rest.ends_with(b")"),
        // the C library of Microsoft before 2015, which may round and pad its words: `1.#J`, `1.#INF00`
        None => lower.strip_prefix(b"1.#").is_some_and(is_microsoft),
    }
}

/// What follows `1.#`.
fn is_microsoft(rest: &[u8]) -> bool {
    let letters = rest.iter().take_while(|b| b.is_ascii_alphabetic()).count();
    letters > 0 && rest[letters..].iter().all(u8::is_ascii_digit)
}

/// Whether the `#` at this index is part of such a word, and does not start a comment.
pub(super) fn is_within_number(line: &[u8], at: usize) -> bool {
    line[..at].ends_with(b"1.") && line.get(at + 1).is_some_and(u8::is_ascii_alphabetic)
}
