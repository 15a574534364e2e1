//! Which mistake gives their radiance: our tracer is asked the same question with each known mistake.
//!
//! Known are those of [`judge::mistakes`], whose pictures `verify` compares, too, and those that are another scene
//! or pixel, by its edits ([`CHANGES`]).

use std::sync::LazyLock;

use serde_json::{Value, json};

use super::super::family::Namer;
use super::super::mistakes::{self as m, CHANGES, Mistake};
use super::super::probe::ours;
use super::estimate::Estimate;
use crate::probe::mistaken::mistaken;
use judge::mistakes;

/// Standard errors that an explained mean may be away.
const NEAR: f64 = 3.5;
/// How closely a mistake has to explain an answer without noise, as for all values.
const CLOSE: f64 = 1e-5;
/// Samples of one seed for a first look at all mistakes; those that fit are asked in full.
const FIRST_SAMPLES: u64 = 36;

/// Those of which a picture can be made.
static PICTURES: LazyLock<Vec<(&'static mistakes::Mistake, Mistake)>> = LazyLock::new(|| {
    mistakes::all()
        .into_iter()
        .map(|mistake| (mistake, Mistake::of_scene(mistake.known())))
        .collect()
});

/// Names answers to `radiance` and `trace`.
pub const NAMER: Namer = Namer { explain, refutes };

/// Standard errors by which the mean of a mistake is another than theirs.
const FAR: f64 = 6.0;

/// The mistakes that explain an answer to `radiance` or `trace`: the last of what was asked.
fn explain(asked: &[(Value, Value)]) -> Vec<&'static Mistake> {
    let Some((question, answer)) = asked.last() else { return Vec::new() };
    let (question, answer) = as_radiance(question, answer);
    let right = ours(&question).ok().and_then(|answer| Estimate::answered(&answer));
    let (Some(theirs), Some(right)) = (Estimate::answered(&answer), right) else {
        return Vec::new();
    };
    let mut found = fitting(&question, &theirs, &right);
    if !right.is_exact() {
        let scaled = |factor: f64, numbers: [f64; 3]| numbers.map(|x| factor * x);
        let factors = m::FACTORS.iter().filter(|(_, factor)| {
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

/// Whether all that a mistake may give here is another answer than theirs, which is right. That one of the factors applies to
/// some answers and not to others is no contradiction.
fn refutes((question, answer): &(Value, Value), mistake: &'static Mistake) -> bool {
    let (question, answer) = as_radiance(question, answer);
    let Some(theirs) = Estimate::answered(&answer) else { return false };
    let catalogue = PICTURES.iter().filter(|(_, told)| told == mistake).map(|(known, _)| *known);
    let by_terms = mistaken(&question, &catalogue.collect::<Vec<_>>());
    let by_terms = by_terms.into_iter().map(|one| Estimate {
        mean: one.mean,
        error: one.standard_error,
        ..theirs
    });
    let changes = CHANGES.iter().filter(|it| *it == mistake);
    let by_scene = changes.filter_map(|change| changed(&question, change));
    let by_color = m::other_colors(&theirs.mean).into_iter().filter(|(other, _)| *other == mistake);
    let by_color =
        by_color.filter_map(|(_, mean)| Some(Estimate { mean: mean.try_into().ok()?, ..theirs }));
    let others: Vec<Estimate> = by_terms.chain(by_scene).chain(by_color).collect();
    let differs = |other: &Estimate| match other.is_exact() && theirs.is_exact() {
        true => !m::same(&theirs.mean, &other.mean),
        false => other.distance(&theirs, CLOSE) > FAR,
    };
    !others.is_empty() && others.iter().all(differs)
}

/// What our tracer answers to the changed question; `None` if the change does not apply.
fn changed(question: &Value, mistake: &Mistake) -> Option<Estimate> {
    let mut other = question.clone();
    mistake.known().change(&mut other["radiance"])?;
    Estimate::answered(&ours(&other).ok()?)
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
        PICTURES.iter().find(|(known, _)| known == mistake).map(|(_, told)| told)
    };
    let mut found: Vec<&'static Mistake> = by_terms.iter().filter_map(known).collect();
    for mistake in CHANGES.iter() {
        let explains = |question: &Value| {
            changed(question, mistake).is_some_and(|other| explains(&other, theirs, right))
        };
        if explains(&first) && (!again || explains(question)) {
            found.push(mistake);
        }
    }
    found
}

/// Whether theirs may be the answer of a mistake, which is another than ours.
fn explains(other: &Estimate, theirs: &Estimate, right: &Estimate) -> bool {
    if other.is_exact() && theirs.is_exact() {
        return m::tells(&other.mean, &theirs.mean, &right.mean);
    }
    // of what ours is, theirs is none: it was judged wrong
    other.distance(theirs, CLOSE) <= NEAR && right.distance(theirs, CLOSE) > NEAR
}
