//! Lines that a program answers.

use conform::lines::*;
use conform::{Fault, Reply};
use serde_json::Value;
use serde_json::json;

fn answer(text: &str) -> Value {
    match read(format!("{{\"id\": 3, \"answer\": {text}}}").as_bytes()) {
        Ok((3, Reply::Answer(answer))) => answer,
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
