//! Lines that a program answers.

use ask::lines::*;
use ask::{Fault, Stop};
use serde_json::Value;
use serde_json::json;

fn answer(text: &str) -> Value {
    match read(format!("{{\"id\": 3, \"answer\": {text}}}").as_bytes()) {
        Ok((3, Ok(answer))) => answer,
        other => panic!("{text}: {other:?}"),
    }
}

/// Law: what C, C++, Python, Java, Go, Lua, Fortran and old Visual C++ print for NaN and infinity is read as such.
/// Oracle: the list of words, from their manuals.
#[test]
fn numbers_that_are_not_finite_are_read_as_languages_print_them() {
    for nan in
        ["NaN", "nan", "-nan", "-NaN", "nan(ind)", "-nan(ind)", "nan(snan)", "-1.#IND", "1.#QNAN"]
    {
        assert_eq!(answer(&format!("[1.5,{nan} ,2]")), json!([1.5, "nan", 2]), "{nan}");
    }
    for inf in ["Infinity", "inf", "+Inf", "INF", "1e999", "1.#INF"] {
        assert_eq!(answer(&format!("{{\"t\":{inf}}}")), json!({"t": "inf"}), "{inf}");
    }
    for inf in ["-Infinity", "-inf", "-1e999", "-1.#INF"] {
        assert_eq!(answer(inf), json!("-inf"), "{inf}");
    }
}

/// Law: text stays as it is, and what is no number stays no JSON. Oracle: lines by hand.
#[test]
fn words_in_strings_and_other_words_are_left_alone() {
    assert_eq!(answer("[NaN, \"a \\\"nan, NaN\"]"), json!(["nan", "a \"nan, NaN"]));
    for text in ["None", "NaNa", "1.5.2", "nan(", "undefined", "[1,,2]", "0x1p3", "infinitely"] {
        let line = format!("{{\"id\": 3, \"answer\": {text}}}");
        assert!(matches!(read(line.as_bytes()), Err(Fault::Garbled(_))), "{text}");
    }
}

/// Law: an id is a whole number of at least 0, also with a point or a power of ten; any other is garbled. A line has
/// exactly one of `answer`, `error` and `unsupported`. Oracle: lines by hand.
#[test]
fn a_line_has_an_id_and_one_reply() {
    for (id, expected) in [
        ("0", Some(0)),
        ("7", Some(7)),
        ("7.0", Some(7)),
        ("7e0", Some(7)),
        ("12e1", Some(120)),
        ("18446744073709551615", Some(u64::MAX)),
        ("7.5", None),
        ("-1", None),
        ("-0.5", None),
        ("1e15", None),
        ("1e300", None),
        ("NaN", None),
        ("\"7\"", None),
        ("[7]", None),
        ("true", None),
        ("null", None),
    ] {
        let line = format!("{{\"id\": {id}, \"answer\": 1}}");
        let found = read(line.as_bytes()).ok().map(|it| it.0);
        assert_eq!(found, expected, "the id {id}");
    }
    let kinds = [("answer", "1"), ("error", "\"e\""), ("unsupported", "\"u\"")];
    for set in 0..8_usize {
        let some = kinds.iter().enumerate().filter(|(i, _)| set >> i & 1 == 1);
        let fields: String =
            some.map(|(_, (key, value))| format!(", \"{key}\": {value}")).collect();
        let line = format!("{{\"id\": 1{fields}}}");
        let expected = match set {
            1 => Some(Ok(json!(1))),
            2 => Some(Err(Stop::Refused("e".to_owned()))),
            4 => Some(Err(Stop::Unsupported("u".to_owned()))),
            _ => None,
        };
        let found = read(line.as_bytes()).ok().map(|it| it.1);
        assert_eq!(found, expected, "the reply of {line}");
    }
    assert!(read(b"{\"answer\": 1}").is_err(), "a line without an id");
}
