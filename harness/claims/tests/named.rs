//! Factors that people leave out or put in: each is named if numbers are off by it in nearly all cases, and nothing else is.

use ask::{Reply, Subject};
use std::f64::consts::PI;

use serde_json::{Value, json};

use super::counted::{Lambert, Vector, data, dot, vector};
use super::lamps::Lamps;
use super::mistakes::times;
use super::squares::Squares;

/// A right program whose answers are changed.
pub struct Changed<S, F> {
    pub right: S,
    pub change: F,
}

impl<S: Subject, F: FnMut(&Value, &mut Value)> Subject for Changed<S, F> {
    fn ask(&mut self, questions: &[Value]) -> Vec<Reply> {
        let mut replies = self.right.ask(questions);
        for (question, reply) in questions.iter().zip(&mut replies) {
            if let Ok(answer) = reply {
                (self.change)(question, answer);
            }
        }
        replies
    }
}

/// What all breaches of a subject take the mistake to be.
fn named(subject: &mut dyn Subject, cases: usize) -> Vec<String> {
    // the second case may be seen from below
    let card = super::right::card(subject, cases, 3);
    assert!(card.is_failed(), "a factor is found: {card}");
    let broken = card.rows[0].broken();
    broken.filter_map(|(_, broken)| broken.breach.mistake.clone()).collect()
}

fn expect(found: &[String], name: &str, what: &str) {
    let said = format!("what is found is {name} times what is expected");
    assert!(found.contains(&said), "{what} times {name} is named `{said}`: {found:?}");
}

/// Law: a density of a map that is off by a power of the radius or of the height, or by a constant, is named so. Oracle: the factors
/// that were put in.
#[test]
fn factors_of_maps_are_named() {
    let radius = |x: Vector| (x[0] * x[0] + x[1] * x[1]).sqrt();
    type Factor<'a> = (&'static str, &'static str, &'a dyn Fn(Vector) -> f64);
    let factors: [Factor<'_>; 7] = [
        ("disk", "r", &|x| radius(x)),
        ("disk", "1/(2r)", &|x| 0.5 / radius(x)),
        ("sphere", "|z|", &|x| x[2].abs()),
        ("sphere", "1/(2 |z|)", &|x| 0.5 / x[2].abs()),
        ("disk", "π", &|_| PI),
        ("disk", "½", &|_| 0.5),
        ("disk", "1/4π", &|_| 0.25 / PI),
    ];
    for (map, name, factor) in factors {
        let maps: &'static [&'static str] = if map == "disk" { &["disk"] } else { &["sphere"] };
        let change = |question: &Value, answer: &mut Value| {
            let Some(asked) = question.get("pdf") else { return };
            let points = asked["x"].as_array().into_iter().flatten();
            for (pdf, x) in answer.as_array_mut().into_iter().flatten().zip(points) {
                times(pdf, factor(vector(x)));
            }
        };
        let found = named(&mut Changed { right: Squares::new(maps, "", false), change }, 1);
        expect(&found, name, &format!("the pdf of the {map}"));
    }
}

/// Law: a density of a light's samples that is off by a power of the distance or of the cosine there is named so. Oracle: the factors
/// that were put in.
#[test]
fn factors_of_lights_are_named() {
    type Factor<'a> = (&'static str, &'a dyn Fn(f64, f64) -> f64);
    let factors: [Factor<'_>; 4] = [
        ("d²", &|d, _| d * d),
        ("cos θ'", &|_, c| c),
        ("d²/cos θ'", &|d, c| d * d / c),
        ("1/d", &|d, _| 1.0 / d),
    ];
    for (name, factor) in factors {
        let change = |question: &Value, answer: &mut Value| {
            if question.get("sample").is_none() {
                return;
            }
            for sample in answer.as_array_mut().into_iter().flatten().filter(|it| !it.is_null()) {
                let cosine = dot(vector(&sample["normal"]), vector(&sample["wi"])).abs();
                let distance = sample["distance"].as_f64().expect("a distance");
                times(&mut sample["pdf"], factor(distance, cosine));
            }
        };
        let found = named(&mut Changed { right: Lamps::new(&["rectangle"], "", false), change }, 1);
        expect(&found, name, "the pdf of a sample");
    }
}

/// A Lambert lobe whose weights are multiplied by a function of the directions to the viewer and to the light.
fn weighted(factor: impl Fn(Vector, Vector) -> f64, claims: Value) -> Vec<String> {
    let change = |question: &Value, mut answer: Value| {
        if question.get("sample").is_some() {
            let wo = vector(&data(question)["wo"]);
            for sample in answer.as_array_mut().into_iter().flatten() {
                let wi = vector(&sample["wi"]);
                let weights = sample["weight"].as_array_mut().into_iter().flatten();
                weights.for_each(|weight| times(weight, factor(wo, wi)));
            }
        }
        answer
    };
    let cases = if claims["from_below"] == true { 2 } else { 1 };
    named(&mut Lambert::new(claims, json!({}), change), cases)
}

/// Law: a weight of a lobe that is off by cosines to the normal or to the half vector, or by powers of the index of refraction, is
/// named so. Oracle: the factors that were put in.
#[test]
fn factors_of_lobes_are_named() {
    let half = |wo: Vector, wi: Vector| {
        let h = [0, 1, 2].map(|k| wo[k] + wi[k]);
        dot(wo, h).abs() / dot(h, h).sqrt()
    };
    type Factor<'a> = (&'static str, &'a dyn Fn(Vector, Vector) -> f64);
    let factors: [Factor<'_>; 8] = [
        ("|cos θi|", &|_, wi| wi[2].abs()),
        ("1/|cos θi|", &|_, wi| 1.0 / wi[2].abs()),
        ("|cos θo|", &|wo, _| wo[2].abs()),
        ("1/|cos θo|", &|wo, _| 1.0 / wo[2].abs()),
        ("|cos θi|/|cos θo|", &|wo, wi| (wi[2] / wo[2]).abs()),
        ("4 (ωo·h)", &|wo, wi| 4.0 * half(wo, wi)),
        ("1/(4 ωo·h)", &|wo, wi| 0.25 / half(wo, wi)),
        ("ωo·h", &|wo, wi| half(wo, wi)),
    ];
    for (name, factor) in factors {
        expect(&weighted(factor, json!({})), name, "weights");
    }
    // the index is that of the other side over that of the viewer's
    let eta: f64 = 1.3;
    let squared = eta * eta;
    for (name, factor) in [
        ("η²", squared),
        ("1/η²", 1.0 / squared),
        ("η⁴ (1/η² left out on both ways)", squared * squared),
        ("1/η⁴ (η² left out on both ways)", 1.0 / (squared * squared)),
    ] {
        let found = weighted(|_, _| factor, json!({"eta": eta}));
        expect(&found, name, "weights");
    }
    let below = |wo: Vector, _: Vector| if wo[2] < 0.0 { 1.0 / squared } else { 1.0 };
    let found = weighted(below, json!({"eta": eta, "from_below": true}));
    expect(&found, "η²", "weights, seen from below");
}

/// Law: a factor is named if it is that in at least nine tenths of the cases, to a thousandth; one that is none of the list is not
/// named. Oracle: shares and factors on both sides.
#[test]
fn only_a_factor_of_nearly_all_cases_is_named() {
    let sometimes = |share: f64| {
        move |_: Vector, wi: Vector| {
            // of uniform azimuths
            let azimuth = groundtruth::math::atan2(wi[1], wi[0]) / (2.0 * PI) + 0.5;
            if azimuth < share { 2.0 } else { 3.3 }
        }
    };
    expect(&weighted(sometimes(1.0), json!({})), "2", "weights");
    let found = weighted(sometimes(0.6), json!({}));
    assert!(found.is_empty(), "a factor of six tenths of the cases is named: {found:?}");
    expect(&weighted(|_, _| 2.0 * 1.0005, json!({})), "2", "weights, a two-thousandth off,");
    for odd in [2.0 * 1.003, 1.7] {
        let found = weighted(|_, _| odd, json!({}));
        let is_named = found.iter().any(|it| it.contains("what is found is"));
        assert!(!is_named, "the factor {odd} is named: {found:?}");
    }
}
