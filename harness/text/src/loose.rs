//! JSON as most languages print it: with `NaN`, `-nan(ind)`, `Infinity`, `1e999`.

/// The number that is not finite with this name: `inf`, `-Infinity`, `nan`, `-nan(ind)`, `1.#QNAN` …
pub fn not_finite(name: &str) -> Option<f64> {
    let lower = name.to_ascii_lowercase();
    let (sign, bare) = match lower.strip_prefix('-') {
        Some(rest) => (-1.0, rest),
        None => (1.0, lower.strip_prefix('+').unwrap_or(&lower)),
    };
    // a payload, as `nan(0x8000000000000)`, or `nan(ind)` for the default one
    let is_payload = |rest: &str| rest.is_empty() || rest.starts_with('(') && rest.ends_with(')');
    match bare {
        "inf" | "infinity" | "1.#inf" | "1.#inf00" => Some(sign * f64::INFINITY),
        "1.#ind" | "1.#qnan" | "1.#snan" | "1.#ind00" | "1.#qnan0" => Some(f64::NAN),
        _ => bare.strip_prefix("nan").filter(|rest| is_payload(rest)).map(|_| f64::NAN),
    }
}

/// The line with numbers that are not finite in quotes, as the probe writes them: `"nan"`, `"inf"`, `"-inf"`.
pub fn quoted(line: &str) -> String {
    let mut text = String::with_capacity(line.len() + 16);
    let mut rest = line;
    while let Some(first) = rest.chars().next() {
        let length = match first {
            '"' => string_length(rest),
            _ if is_of_word(first) => rest.find(|c| !is_of_word(c)).unwrap_or(rest.len()),
            _ => first.len_utf8(),
        };
        let (word, after) = rest.split_at(length);
        match special(word) {
            Some(x) if x.is_nan() => text.push_str("\"nan\""),
            Some(x) => text.push_str(if x > 0.0 { "\"inf\"" } else { "\"-inf\"" }),
            None => text.push_str(word),
        }
        rest = after;
    }
    text
}

/// The length of the string that the text begins with, quotes included.
fn string_length(text: &str) -> usize {
    let mut is_escaped = false;
    for (at, c) in text.char_indices().skip(1) {
        match c {
            '"' if !is_escaped => return at + 1,
            c => is_escaped = c == '\\' && !is_escaped,
        }
    }
    text.len()
}

/// Whether a character belongs to a number or the name of one.
fn is_of_word(c: char) -> bool {
    c.is_ascii_alphanumeric() || "+-.#()_".contains(c)
}

/// The value of a word that is a number, but not a finite one: a name, or more than a double can hold.
fn special(word: &str) -> Option<f64> {
    let is_number = word.starts_with(|c: char| c == '-' || c.is_ascii_digit());
    let too_large = || is_number.then(|| word.parse::<f64>().ok()).flatten();
    not_finite(word).or_else(too_large).filter(|x| !x.is_finite())
}
