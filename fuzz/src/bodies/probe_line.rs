//! A line of the probe: any text gets one line of JSON, in bounded time and memory.

use conform::probe;

/// Answers each line.
pub fn run(data: &[u8]) {
    let Ok(text) = std::str::from_utf8(data) else { return };
    for line in text.lines() {
        let answer = probe::answer(line);
        assert!(!answer.contains('\n'), "one line for each line");
        assert!(answer.starts_with('{') && answer.ends_with('}'), "an object: {answer}");
    }
}
