//! Every error message of the probe.

mod geometry;
mod light;
mod pictures;

use conform::probe;

/// Lines that are not valid questions, and their errors.
const LINES: &[(&str, &str)] = &[
    (r#""#, "column 0: EOF while parsing a value"),
    (r#"hello"#, "column 1: expected value"),
    (
        r#"[1]"#,
        r#"column 0: invalid type: list, expected an object with one question, as {"intersect": {…}}"#,
    ),
    (r#"{}"#, "column 2: no question; there are: intersect, occluded, …"),
    (r#"{"id": 3}"#, "column 9: no question; there are: intersect, occluded, …"),
    (
        r#"{"intersekt": {}}"#,
        "column 12: no question `intersekt`; there are: intersect, occluded, …",
    ),
    (
        r#"{"fresnel": {"cos_i": 1, "eta": 1}, "light": {"light": {"ambient": {}}, "from": [0, 0, 0]}}"#,
        "column 91: a second question; a line asks one",
    ),
    (r#"{"id": 1, "id": 2, "fresnel": {"cos_i": 1, "eta": 1}}"#, "column 17: duplicate field `id`"),
    (r#"{"fresnel": {"cos_i": 1, "eta": 1}} x"#, "column 37: trailing characters"),
    (r#"{"fresnel": {"cos_i": 1, "eta": 1}"#, "column 34: EOF while parsing an object"),
];

#[test]
fn errors_say_where_what_and_what_would_fit() {
    let questions = [LINES, geometry::ERRORS, light::ERRORS, pictures::ERRORS].concat();
    for (line, error) in questions {
        let reply: serde_json::Value =
            serde_json::from_str(&probe::answer(line)).expect("answers are JSON");
        match (error.strip_suffix('…'), reply["error"].as_str()) {
            (Some(start), Some(found)) => assert!(found.starts_with(start), "{line}: {found}"),
            _ => assert_eq!(reply["error"], error, "{line}"),
        }
    }
}
