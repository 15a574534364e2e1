//! Which directions and points a program is asked for, and where numbers stop to be possible.

use ask::{Subject, numbers};
use serde_json::{Value, json};

use super::counted::{Lambert, card, data};
use super::lamps::Lamps;
use super::named::Changed;
use super::squares::Squares;

type Vector = [f64; 3];

fn vector(value: &Value) -> Vector {
    let mut all = numbers(value).expect("numbers");
    all.resize(3, 0.0);
    [all[0], all[1], all[2]]
}

fn minus(a: Vector, b: Vector) -> Vector {
    [0, 1, 2].map(|k| a[k] - b[k])
}

fn dot(a: Vector, b: Vector) -> f64 {
    (0..3).map(|k| a[k] * b[k]).sum()
}

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

/// Whether a subject breaks the law that numbers are possible.
fn is_impossible(subject: &mut dyn Subject) -> bool {
    let card = card(subject, 1);
    card.rows[0].broken().any(|(law, _)| law.name == "positive")
}

/// The smallest step below 0.
const BELOW: f64 = -1e-300;

fn set(value: &mut Value, number: f64) {
    match value {
        Value::Array(all) => all.iter_mut().for_each(|it| set(it, number)),
        value => *value = json!(number),
    }
}

/// Law: a density of a map may be 0 and not less, wherever in the domain a point is. Oracle: numbers on both sides, in a quarter of
/// the disk, and on both sides of the sphere.
#[test]
fn densities_of_maps_may_be_nothing_and_not_less() {
    type Part<'a> = (&'static [&'static str], &'a dyn Fn(Vector) -> bool);
    let parts: [Part<'_>; 3] = [
        (&["disk"], &|x| x[0] < -0.2 && x[1] > 0.2),
        (&["sphere"], &|x| x[2] > 0.7),
        (&["sphere"], &|x| x[2] < -0.7),
    ];
    for (maps, holds) in parts {
        for (number, expected) in [(0.0, false), (BELOW, true)] {
            let change = |question: &Value, answer: &mut Value| {
                let Some(asked) = question.get("pdf") else { return };
                let points = asked["x"].as_array().into_iter().flatten();
                for (pdf, x) in answer.as_array_mut().into_iter().flatten().zip(points) {
                    if holds(vector(x)) {
                        set(pdf, number);
                    }
                }
            };
            let found =
                is_impossible(&mut Changed { right: Squares::new(maps, "", false), change });
            assert_eq!(
                found, expected,
                "whether a density of {number:e} of {maps:?} is impossible"
            );
        }
    }
}

/// Law: radiance and densities of lights may be 0 and not less, but the density of a sample must be more. Oracle: numbers on both
/// sides of each answer.
#[test]
fn answers_of_lights_may_be_nothing_and_not_less() {
    for (name, key, number, expected) in [
        ("sample", "radiance", 0.0, false),
        ("sample", "radiance", BELOW, true),
        ("sample", "pdf", 0.0, true),
        ("sample", "pdf", BELOW, true),
        ("eval", "pdf", 0.0, false),
        ("eval", "pdf", BELOW, true),
        ("eval", "radiance", BELOW, true),
    ] {
        let change = |question: &Value, answer: &mut Value| {
            if question.get(name).is_none() {
                return;
            }
            match answer {
                Value::Array(samples) => {
                    let some = samples.iter_mut().filter(|it| !it.is_null());
                    some.for_each(|sample| set(&mut sample[key], number));
                }
                eval => set(&mut eval[key], number),
            }
        };
        let right = Lamps::new(&["rectangle"], "", false);
        let found = is_impossible(&mut Changed { right, change });
        assert_eq!(found, expected, "whether {key} = {number:e} of {name} is impossible");
    }
}

/// Law: values of a lobe may be 0 and not less, where light or viewer graze the surface, too. Oracle: numbers on both sides, in
/// directions whose cosine is below 0.002 only.
#[test]
fn values_of_lobes_may_be_nothing_and_not_less() {
    let low = |z: f64| z.abs() < 2e-3;
    for (of_viewer, key, number, expected) in [
        (false, "f", 0.0, false),
        (false, "f", BELOW, true),
        (true, "f", BELOW, true),
        (false, "pdf", BELOW, true),
    ] {
        let change = |question: &Value, mut answer: Value| {
            if question.get("eval").is_some() {
                let wo = vector(&data(question)["wo"]);
                let all = data(question)["wi"].as_array().into_iter().flatten();
                for (value, wi) in answer[key].as_array_mut().into_iter().flatten().zip(all) {
                    if low(if of_viewer { wo[2] } else { vector(wi)[2] }) {
                        set(value, number);
                    }
                }
            }
            answer
        };
        let found = is_impossible(&mut Lambert::new(json!({}), json!({}), change));
        assert_eq!(
            found, expected,
            "whether {key} = {number:e} of a grazing direction is impossible"
        );
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
