//! Which directions and points a program is asked for, and where numbers stop to be possible.

use ask::Subject;
use serde_json::{Value, json};

use super::counted::{Lambert, Vector, card, data, dot, minus, vector};
use super::lamps::Lamps;
use super::named::Changed;
use super::squares::Squares;

/// Law: what rounding may do is measured in four directions around each: twice the square root of the rounding away, two and two
/// opposite, at right angles. Oracle: the geometry of the questions, for 2⁻⁵³.
#[test]
fn values_are_asked_for_all_around_a_direction() {
    let step = 2.0 * (0.5 * f64::EPSILON).sqrt();
    let mut subject = Lambert::new(json!({"reciprocal": true}), json!({}), |_, answer| answer);
    card(&mut subject, 1);
    let mut seen = 0;
    for question in subject.heard.iter().filter(|it| it.get("eval").is_some()) {
        let wi: Vec<Vector> =
            data(question)["wi"].as_array().into_iter().flatten().map(vector).collect();
        for five in wi.chunks_exact(5) {
            let ways = [1, 2, 3, 4].map(|k| minus(five[k], five[0]));
            let lengths = ways.map(|it| dot(it, it).sqrt());
            // other laws ask for directions all over the sphere
            if lengths.iter().any(|it| *it > 1e-3) {
                continue;
            }
            // the coordinates of a direction are rounded to 1e-16, a part of 1e-8 of a step
            let is_near = |found: f64, expected: f64| (found - expected).abs() < 1e-6;
            for length in lengths {
                assert!(is_near(length / step, 1.0), "a step of {length:e}, expected {step:e}");
            }
            let product = |a: usize, b: usize| dot(ways[a], ways[b]) / (step * step);
            for (a, b, expected) in [(0, 1, -1.0), (2, 3, -1.0), (0, 2, 0.0), (1, 3, 0.0)] {
                let found = product(a, b);
                assert!(
                    is_near(found, expected),
                    "the cosine {found} of two steps, expected {expected}"
                );
            }
            seen += 1;
        }
    }
    assert!(seen > 20, "directions with four around them: {seen}");
}

/// The smallest step below 0.
const BELOW: f64 = -1e-300;

fn set(value: &mut Value, number: f64) {
    match value {
        Value::Array(all) => all.iter_mut().for_each(|it| set(it, number)),
        value => *value = json!(number),
    }
}

/// Whether a subject breaks the law that numbers are possible, with a number in place of a field: of each sample, or of `eval`
/// and `pdf` in the directions and points that are chosen.
fn is_impossible(
    right: impl Subject,
    (name, field, number): (&str, &str, f64),
    is_chosen: impl Fn(Vector) -> bool,
) -> bool {
    let change = |question: &Value, answer: &mut Value| {
        let Some(asked) = question.get(name) else { return };
        if name == "sample" {
            let some = answer.as_array_mut().into_iter().flatten().filter(|it| !it.is_null());
            return some.for_each(|sample| set(&mut sample[field], number));
        }
        let values = if field.is_empty() { answer } else { &mut answer[field] };
        let at = asked.get("wi").unwrap_or(&asked["x"]).as_array().into_iter().flatten();
        for (value, at) in values.as_array_mut().into_iter().flatten().zip(at) {
            if is_chosen(vector(at)) {
                set(value, number);
            }
        }
    };
    let card = card(&mut Changed { right, change }, 1);
    card.rows[0].broken().any(|(law, _)| law.name == "positive")
}

/// Law: a value or density may be 0 and not less, wherever it is, but the density of a light's sample must be more. Oracle: numbers
/// on both sides, in a quarter of the disk, on both sides of the sphere, and in directions that graze a lobe.
#[test]
fn values_may_be_nothing_and_not_less() {
    type Part<'a> = (&'static [&'static str], &'a dyn Fn(Vector) -> bool);
    let parts: [Part<'_>; 3] = [
        (&["disk"], &|x| x[0] < -0.2 && x[1] > 0.2),
        (&["sphere"], &|x| x[2] > 0.7),
        (&["sphere"], &|x| x[2] < -0.7),
    ];
    for (number, expected) in [(0.0, false), (BELOW, true)] {
        for (maps, holds) in parts {
            let found = is_impossible(Squares::new(maps, "", false), ("pdf", "", number), holds);
            assert_eq!(found, expected, "a density of {number:e} of {maps:?}");
        }
        for field in ["f", "pdf"] {
            let right = Lambert::new(json!({}), json!({}), |_, answer| answer);
            let found = is_impossible(right, ("eval", field, number), |wi| wi[2].abs() < 2e-3);
            assert_eq!(found, expected, "{field} = {number:e} of a grazing direction");
        }
        for (name, field) in
            [("sample", "radiance"), ("sample", "pdf"), ("eval", "pdf"), ("eval", "radiance")]
        {
            let right = Lamps::new(&["rectangle"], "", false);
            let found = is_impossible(right, (name, field, number), |_| true);
            let expected = expected || (name, field) == ("sample", "pdf");
            assert_eq!(found, expected, "{field} = {number:e} of {name}");
        }
    }
}

/// Law: the way back of a map may be off by what rounding of the point does to it: about `1 + e` roundings of single precision
/// for a power `e` of the cosine, and not 2 %. Oracle: the closed form of map and inverse, rounded; and that form, 2 % off.
#[test]
fn the_way_back_of_a_narrow_lobe_is_rounded() {
    let is_broken = |part: f64| {
        let narrow = |question: &Value, answer: &mut Value| {
            if question.get("list").is_some() {
                answer[0]["parameters"]["e"] = json!([2000, 2000]);
            }
            if question.get("inverse").is_some() {
                for u in answer.as_array_mut().into_iter().flatten() {
                    u[0] = json!(u[0].as_f64().expect("a number") * part);
                }
            }
        };
        let mut subject =
            Changed { right: Squares::new(&["hemisphere"], "", true), change: narrow };
        let card = card(&mut subject, 2);
        card.rows[0].broken().any(|(law, _)| law.name == "inverse")
    };
    assert!(!is_broken(1.0), "a rounded way back is no mistake");
    assert!(is_broken(1.02), "expected 2 % of u to be one");
}
