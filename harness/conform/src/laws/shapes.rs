//! Laws of shapes.

use ask::{Asking, number, triple};
use serde_json::{Value, json};

use super::super::judgement::{Judgement, Profile};
use super::super::mistakes;
use super::{LawOutcome, missing, within};
use groundtruth::math::Vector;

/// Law: t counts in the length of the direction: a direction k times as long gives t/k (Suffern, ch. 3). The case is
/// an `intersect`.
pub fn direction_length(ask: &mut Asking<'_>, case: &Value, profile: Profile) -> LawOutcome {
    const FACTOR: f64 = 4.0; // a power of two: no rounding of its own
    let Some(direction) = triple(&case["intersect"]["ray"]["direction"]) else {
        return Ok(Judgement::Undecided);
    };
    let mut longer = case.clone();
    longer["intersect"]["ray"]["direction"] = json!(direction.map(|x| FACTOR * x));
    let answers = ask.ask_all(&[case.clone(), longer])?;
    let (Some(t), Some(shorter)) = (number(&answers[0]["t"]), number(&answers[1]["t"])) else {
        return Ok(match answers.iter().filter(|answer| answer.is_null()).count() {
            // whether a ray hits is judged elsewhere
            2 => Judgement::Undecided,
            1 => Judgement::wrong("hit or miss", f64::INFINITY, "a hit for both directions"),
            _ => return missing("t"),
        });
    };
    let mut judgement = within(profile, "t", (FACTOR * shorter - t).abs() / t.abs(), || {
        format!("t = {:?} for the direction {FACTOR} times as long", t / FACTOR)
    });
    if let Judgement::Wrong(wrong) = &mut judgement
        && (shorter - t).abs() <= 1e-5 * t.abs()
    {
        wrong.clues.push(&mistakes::UNIT_ASSUMED);
    }
    Ok(judgement)
}

/// Law: an acceleration structure changes no hit: the question with `"accelerated": false` has the same answer (Suffern,
/// ch. 22, 23). The case is an `intersect`.
pub fn unaccelerated(ask: &mut Asking<'_>, case: &Value, profile: Profile) -> LawOutcome {
    let mut plain = case.clone();
    plain["intersect"]["accelerated"] = json!(false);
    let answers = ask.ask_all(&[plain, case.clone()])?;
    let wrong = |symptom: &str, expected: String| {
        Judgement::wrong(symptom, f64::INFINITY, expected).with([&mistakes::ACCELERATED])
    };
    let expected = format!("as without acceleration: t = {}", answers[0]["t"]);
    Ok(match (number(&answers[0]["t"]), number(&answers[1]["t"])) {
        (None, None) if answers.iter().all(Value::is_null) => Judgement::Right(0.0),
        (None, None) => return missing("t"),
        (Some(t), Some(other)) if t == other => Judgement::Right(0.0),
        (Some(t), Some(other)) => {
            match within(profile, "t", (t - other).abs() / t.abs(), || expected.clone()) {
                Judgement::Wrong(_) => wrong("t", expected),
                right => right,
            }
        }
        _ => wrong("hit or miss", expected),
    })
}

/// Law: along a line, a closed body is entered and left in turn (Suffern, ch. 3, 19). Where two parts of a body meet,
/// both may be hit in the same point. The case is an `intersect` with `all`; the law asks it for the whole line.
pub fn sides_alternate(ask: &mut Asking<'_>, case: &Value, profile: Profile) -> LawOutcome {
    /// Hits of two parts at their seam are nearer to each other than any two walls of a case.
    const SAME_HIT: f64 = 1e-9;
    let mut line = case.clone();
    line["intersect"]["span"] = json!(["-inf", "inf"]);
    let answer = ask.ask(&line)?;
    let Some(hits) = answer.as_array() else { return missing("list of hits") };
    if hits.is_empty() {
        return Ok(Judgement::Undecided); // whether a ray hits is judged elsewhere
    }
    let Some(direction) = triple(&case["intersect"]["ray"]["direction"]) else {
        return Ok(Judgement::Undecided);
    };
    let mut enters: Vec<bool> = Vec::new();
    let mut before = f64::NEG_INFINITY;
    for hit in hits {
        let Some(t) = number(&hit["t"]).filter(|t| !t.is_nan()) else { return missing("t") };
        let Some(normal) = triple(&hit["normal"]) else { return missing("normal") };
        let cosine =
            Vector::from(normal).dot(Vector::from(direction)) / Vector::from(direction).length();
        if cosine.abs() < 1e-3 {
            return Ok(Judgement::Undecided); // nearly touches
        }
        let is_seam = t - before <= SAME_HIT * t.abs().max(1.0);
        if !is_seam || enters.last() != Some(&(cosine < 0.0)) {
            enters.push(cosine < 0.0);
        }
        before = t;
    }
    let in_turn = enters.windows(2).all(|pair| pair[0] != pair[1]);
    let is_whole = enters.len().is_multiple_of(2) && enters.first() != Some(&false);
    // where it is left, the book turns the normals of some walls to the viewer
    let is_ring = case["intersect"]["shape"].get("thick_ring").is_some();
    let is_turned = enters.iter().enumerate().all(|(i, enters)| *enters || i % 2 == 1);
    Ok(match in_turn && is_whole {
        true => Judgement::Right(0.0),
        false if profile == Profile::Book && is_ring && is_turned => {
            Judgement::ByTheBook(&mistakes::TO_VIEWER_BY_THE_BOOK)
        }
        false => {
            let text = "as many normals against the ray as along it, in turn";
            Judgement::wrong("sides", f64::INFINITY, text)
        }
    })
}
