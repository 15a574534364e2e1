//! Answers of other types, and answers that are off by a little.

use serde_json::{Value, json};

use super::counted::{Lambert, card, data, first, vector};
use super::mistakes::{scaled, times};
use super::named::Changed;
use super::squares::Squares;

/// Law: in double precision, weights, densities and directions of samples that are off by 10⁻⁶ break their law, and by 10⁻¹⁵
/// they do not; a claim of `float` allows 10⁻⁷, and not 10⁻². Oracle: the planted error; the laws move directions by the square
/// root of the rounding, so that errors below 10⁻⁷, or 10⁻³ with `float`, cannot be found.
#[test]
fn values_are_held_to_their_precision() {
    for (question, field, law) in
        [("sample", "weight", "weight"), ("sample", "pdf", "same pdf"), ("sample", "wi", "sides")]
    {
        for (is_float, by, is_broken) in
            [(false, 1e-6, true), (false, 1e-15, false), (true, 1e-2, true), (true, 1e-7, false)]
        {
            let change = |asked: &Value, answer: Value| match asked.get(question) {
                Some(_) => scaled(answer, field, &[field], 1.0 + by),
                None => answer,
            };
            let mut subject = Lambert::new(json!({"float": is_float}), json!({}), change);
            let found = card(&mut subject, 2);
            // a law that is broken may break others with it; it is the first
            let expected = is_broken.then_some(law);
            assert_eq!(
                first(&found),
                expected,
                "{field} off by {by:e}, float: {is_float}\n{found}"
            );
        }
    }
    // one of both directions of a lobe that claims to be reciprocal, or to be isotropic
    for (claims, law, by) in [
        (json!({"reciprocal": true}), "reciprocal", (|wo| wo[2]) as fn([f64; 3]) -> f64),
        (json!({"isotropic": true}), "turned", |wo| wo[0]),
    ] {
        for (size, channel, is_broken) in
            [(1e-6, 0, true), (1e-6, 1, true), (1e-6, 2, true), (1e-17, 0, false)]
        {
            let change = |asked: &Value, mut answer: Value| {
                let factor = 1.0 + size * by(vector(&data(asked)["wo"]));
                let mut scale = |value: &mut Value| {
                    value[channel] = json!(value[channel].as_f64().map(|x| x * factor));
                };
                // the weight follows, so that no other law is broken
                match answer.get_mut("f") {
                    Some(f) => f.as_array_mut().into_iter().flatten().for_each(scale),
                    None => {
                        let samples = answer.as_array_mut().into_iter().flatten();
                        samples.filter_map(|it| it.get_mut("weight")).for_each(&mut scale);
                    }
                }
                answer
            };
            let mut subject = Lambert::new(claims.clone(), json!({}), change);
            let found = card(&mut subject, 2);
            assert_eq!(first(&found), is_broken.then_some(law), "off by {size:e}\n{found}");
        }
    }
}

/// Law: a field of another type, one that is missing, a list that is shorter or longer, and numbers that are none are
/// never taken for an answer: the lobe fails, by a law or for want of an answer. Oracle: a right answer, altered in
/// each place.
#[test]
fn each_field_of_an_answer_is_needed() {
    type Change = fn(&Value) -> Value;
    let changes: [(&str, Change); 9] = [
        ("null", |_| Value::Null),
        ("text", |_| json!("yes")),
        ("a truth value", |_| json!(true)),
        ("an object", |_| json!({})),
        ("an empty list", |_| json!([])),
        ("NaN", |_| json!("nan")),
        ("infinite", |_| json!("inf")),
        ("negative", |value| match value {
            Value::Number(_) => json!(-1.0),
            _ => json!([-1.0, -1.0, -1.0]),
        }),
        ("one more", |value| match value {
            Value::Array(items) => items.iter().chain(items.last()).cloned().collect(),
            other => json!([other, other]),
        }),
    ];
    let places = [
        ("eval", ""),
        ("eval", "/f"),
        ("eval", "/f/0"),
        ("eval", "/f/0/1"),
        ("eval", "/pdf"),
        ("eval", "/pdf/0"),
        ("sample", ""),
        ("sample", "/0"),
        ("sample", "/0/wi"),
        ("sample", "/0/wi/2"),
        ("sample", "/0/weight"),
        ("sample", "/0/weight/1"),
        ("sample", "/0/pdf"),
    ];
    for (question, path) in places {
        for (what, by) in &changes {
            // a sample may scatter nothing, and have no density
            if *what == "null" && ["/0", "/0/pdf"].contains(&path) {
                continue;
            }
            let change = |asked: &Value, mut answer: Value| {
                if asked.get(question).is_some() {
                    let slot = answer.pointer_mut(path).expect("it is there");
                    let after = by(slot);
                    *slot = after;
                }
                answer
            };
            let mut subject = Lambert::new(json!({}), json!({}), change);
            let found = card(&mut subject, 1);
            assert!(found.is_failed(), "{question}{path} is {what}, and nothing fails\n{found}");
        }
    }
    for (question, field) in
        [("eval", "f"), ("eval", "pdf"), ("sample", "wi"), ("sample", "weight")]
    {
        let change = |asked: &Value, mut answer: Value| {
            if asked.get(question).is_some() {
                match &mut answer {
                    Value::Array(items) => {
                        items[0].as_object_mut().map(|fields| fields.remove(field));
                    }
                    other => {
                        other.as_object_mut().map(|fields| fields.remove(field));
                    }
                }
            }
            answer
        };
        let found = card(&mut Lambert::new(json!({}), json!({}), change), 1);
        assert!(found.is_failed(), "{field} of {question} is missing, and nothing fails\n{found}");
    }
}

/// Law: points of a map lie in its domain to rounding, also those of the corners of the square. Oracle: a disk and a
/// sphere that are larger by 10⁻⁶, and by less than the rounding.
#[test]
fn points_lie_in_their_domain_to_rounding() {
    for map in [&["disk"], &["sphere"]] {
        for (by, expected) in [(1e-6, Some("inside")), (1e-15, None)] {
            let change = |question: &Value, answer: &mut Value| {
                if question.get("map").is_some() {
                    times(answer, 1.0 + by);
                }
            };
            let right = Squares::new(map, "", false);
            let found = card(&mut Changed { right, change }, 1);
            assert_eq!(first(&found), expected, "{map:?} larger by {by:e}\n{found}");
        }
    }
}
