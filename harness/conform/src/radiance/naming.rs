//! Which mistake gives their radiance: our tracer is asked the same question with each known mistake.
//!
//! Known are those of [`judge::mistakes`], whose pictures `verify` compares, too, and those that are another scene
//! ([`changes`]).

use std::sync::LazyLock;

use serde_json::{Value, json};

use super::super::mistakes::{self as m, Mistake};
use super::super::subject::ours;
use super::changes;
use super::estimate::Estimate;
use crate::probe::mistaken::mistaken;
use judge::mistakes;

/// Standard errors that an explained mean may be away.
const NEAR: f64 = 3.5;
/// How closely a mistake has to explain an answer without noise, as for all values.
const CLOSE: f64 = 1e-5;
/// Samples of one seed for a first look at all mistakes; those that fit are asked in full.
const FIRST_SAMPLES: u64 = 36;

/// The catalogue, as pictures of whole scenes tell it.
static CATALOGUE: LazyLock<Vec<(&'static mistakes::Mistake, Mistake)>> = LazyLock::new(|| {
    let told = |mistake: &'static mistakes::Mistake| {
        (mistake, Mistake { name: mistake.words, ..Mistake::of_pictures(mistake.known) })
    };
    mistakes::all().into_iter().map(told).collect()
});

/// Factors of all light.
const FACTORS: [(&Mistake, f64); 4] = [
    (&m::TIMES_PI, std::f64::consts::PI),
    (&m::OVER_PI, std::f64::consts::FRAC_1_PI),
    (&m::TIMES_TWO, 2.0),
    (&m::HALF, 0.5),
];

/// The mistakes that explain an answer to `radiance` or `trace`: the last of what was asked.
pub fn name(asked: &[(Value, Value)]) -> Vec<&'static Mistake> {
    let Some((question, answer)) = asked.last() else { return Vec::new() };
    let (question, answer) = as_radiance(question, answer);
    let right = ours(&question).ok().and_then(|answer| Estimate::answered(&answer));
    let (Some(theirs), Some(right)) = (Estimate::answered(&answer), right) else {
        return Vec::new();
    };
    let mut found = fitting(&question, &theirs, &right);
    if !right.is_exact() {
        let scaled = |factor: f64, numbers: [f64; 3]| numbers.map(|x| factor * x);
        let factors = FACTORS.iter().filter(|(_, factor)| {
            let (mean, error) = (scaled(*factor, right.mean), scaled(*factor, right.error));
            explains(&Estimate { mean, error, ..right }, &theirs, &right)
        });
        found.extend(factors.map(|(mistake, _)| *mistake));
    }
    let mut seen: Vec<&'static Mistake> = Vec::new();
    found.retain(|mistake| {
        let is_new = !seen.contains(mistake);
        seen.push(mistake);
        is_new
    });
    found
}

/// A question of `trace` as one of `radiance`.
fn as_radiance(question: &Value, answer: &Value) -> (Value, Value) {
    match question.get("trace") {
        None => (question.clone(), answer.clone()),
        Some(data) => {
            let mut data = data.clone();
            data["replicas"] = json!(1);
            (json!({"radiance": data}), json!({"mean": answer["radiance"]}))
        }
    }
}

/// The mistakes whose answers theirs may be: those of a first look with few samples, asked again with all.
fn fitting(question: &Value, theirs: &Estimate, right: &Estimate) -> Vec<&'static Mistake> {
    let mut first = question.clone();
    let samples = question["radiance"]["samples"].as_u64();
    if samples.is_some_and(|samples| samples > FIRST_SAMPLES) {
        first["radiance"]["samples"] = json!(FIRST_SAMPLES);
    }
    let again = first != *question;
    let fits = |question: &Value, among: &[&'static mistakes::Mistake]| {
        let mut fits = mistaken(question, among);
        fits.retain(|one| {
            let (mean, error) = (one.mean, one.standard_error);
            explains(&Estimate { mean, error, ..*right }, theirs, right)
        });
        fits.into_iter().map(|one| one.mistake).collect::<Vec<_>>()
    };
    let mut by_terms = fits(&first, &mistakes::all());
    if again {
        by_terms = fits(question, &by_terms);
    }
    let known = |mistake: &&'static mistakes::Mistake| {
        CATALOGUE.iter().find(|(known, _)| known == mistake).map(|(_, told)| told)
    };
    let mut found: Vec<&'static Mistake> = by_terms.iter().filter_map(known).collect();
    for change in changes::all() {
        let changed = |question: &Value| {
            let mut other = question.clone();
            (change.apply)(&mut other["radiance"])?;
            Estimate::answered(&ours(&other).ok()?)
        };
        let explains = |question: &Value| {
            changed(question).is_some_and(|other| explains(&other, theirs, right))
        };
        if explains(&first) && (!again || explains(question)) {
            found.push(change.mistake);
        }
    }
    found
}

/// Whether theirs may be the answer of a mistake, which is another than ours.
fn explains(other: &Estimate, theirs: &Estimate, right: &Estimate) -> bool {
    if other.is_exact() && theirs.is_exact() {
        return m::same(&theirs.mean, &other.mean) && !m::same(&right.mean, &other.mean);
    }
    // of what ours is, theirs is none: it was judged wrong
    other.distance(theirs, CLOSE) <= NEAR && right.distance(theirs, CLOSE) > NEAR
}
