//! Programs that answer the same to every question, nothing, too much, or something else in one place of a right answer.

use ask::{Asking, Subject};

use conform::family::{Family, Judge};
use conform::{Judgement, Ours, Profile, ours, suite};
use serde_json::{Value, json};

use super::altered::{Altered, Says, card};
use testkit::as_many;

/// Cases of a family: enough that not all of them have the same answer.
const CASES: usize = 6;
/// Statistical laws ask up to 1500 questions a case; the hard families have the judges of the ordinary ones.
pub fn is_cheap(family: &Family) -> bool {
    family.ordinary && !family.name.ends_with(".density") && !family.name.ends_with(".stream")
}

/// The judge's word on a case.
fn judged(family: &Family, subject: &mut dyn Subject, case: &Value) -> Option<Judgement> {
    match family.judge {
        Judge::Answer(judge, rules) => match subject.ask(std::slice::from_ref(case)).pop() {
            Some(Ok(answer)) => Some(judge(case, &answer, Profile::Careful, rules)),
            _ => None,
        },
        Judge::Law(law) => law(&mut Asking::new(subject), case, Profile::Careful).ok(),
    }
}

/// The families whose first cases all pass with this answer, or else with the right one to the first of them.
fn blind(families: &[Family], cases: usize, constant: Option<&Value>) -> Vec<String> {
    let passes = |family: &&Family| {
        let cases = (family.cases)(7, cases);
        // that nothing is there is another constant
        let first = || cases.iter().filter_map(|case| ours(case).ok()).find(|it| !it.is_null());
        let answer = constant.cloned().or_else(first).unwrap_or_default();
        let mut subject = Says(|_: &Value| answer.clone());
        !cases.iter().any(|case| {
            judged(family, &mut subject, case).is_some_and(|judgement| judgement.is_wrong())
        })
    };
    families.iter().filter(passes).map(|family| family.name.clone()).collect()
}

/// Law: no family is passed by one answer to everything, and no answer stops the judge. Oracle: nothing, a truth
/// value, a number, an empty list, NaN, and the right answer to the family's first case.
#[test]
fn no_constant_passes() {
    let families: Vec<Family> = suite::all().into_iter().filter(is_cheap).collect();
    for constant in [json!(null), json!(false), json!(42), json!([]), json!("nan")] {
        let names = blind(&families, CASES, Some(&constant));
        // some shapes are hit by no ray of a few, or by each
        let is_guess = |name: &String| {
            let half = name.starts_with("occluded.") && constant == json!(false);
            let misses = name.starts_with("intersect.") && constant.is_null();
            let sides = name.ends_with(".sides") && constant == json!([]);
            half || misses || sides || name.starts_with("project.") && constant.is_null()
        };
        let names: Vec<String> = names.into_iter().filter(|name| !is_guess(name)).collect();
        assert!(names.is_empty(), "{constant} passes {names:?}");
    }
    let names = blind(&families, as_many(16, 48), None);
    // laws that a right answer keeps, whatever the question: another family of the same question tells it
    let kept = "accelerated energy reciprocity shares inverse sides smooth strata sample";
    let is_kept = |name: &String| kept.split(' ').any(|it| name.rsplit('.').next() == Some(it));
    let names: Vec<String> = names.into_iter().filter(|name| !is_kept(name)).collect();
    assert!(names.is_empty(), "the first right answer passes {names:?}");
}

/// Law: a part that a law reads has to be a number, and there. Oracle: our answers to all questions, altered in one
/// field of those that the law holds against each other.
#[test]
fn laws_are_broken_by_what_is_no_number() {
    let mut problems = Vec::new();
    for family in suite::all().iter().filter(|family| is_cheap(family)) {
        let Judge::Law(_) = family.judge else { continue };
        let is_right = |subject: &mut dyn Subject, case: &Value| {
            judged(family, subject, case).is_some_and(|judgement| judgement.is_right())
        };
        let mut cases = (family.cases)(7, 3);
        cases.retain(|case| is_right(&mut Ours, case));
        for field in read(&family.name) {
            for what in ["NaN", "text"] {
                let mut broken = Altered(|_, answer| spoilt(answer, field, what));
                if cases.iter().any(|case| is_right(&mut broken, case)) {
                    problems.push(format!("{}: {field} is {what}", family.name));
                }
            }
        }
    }
    assert!(problems.is_empty(), "{problems:#?}");
}

/// The fields that the law of a family needs.
fn read(family: &str) -> &'static [&'static str] {
    match family.rsplit('.').next().unwrap_or_default() {
        "direction_length" | "accelerated" => &["t"],
        "vectors" => &["vector"],
        "sides" if family.starts_with("intersect.") => &["t", "normal"],
        "reciprocity" => &["f"],
        "energy" => &["albedo"],
        "there_and_back" if family.starts_with("camera_ray.") => &["image"],
        "inverse" => &["matrix"],
        "shares" => &["reflected"],
        "linear" | "cubic" | "knots" | "seeds" => &["value"],
        "sums" => &["value", "fractal_sum", "turbulence", "fbm", "vector_fbm"],
        _ => &[],
    }
}

/// An answer with one field that is no number, wherever it is.
fn spoilt(value: Value, field: &str, what: &str) -> Value {
    match value {
        Value::Object(fields) => {
            let one = |(key, value): (String, Value)| match key == field {
                true => (key, json!(if what == "NaN" { "nan" } else { "yes" })),
                false => (key, spoilt(value, field, what)),
            };
            fields.into_iter().map(one).collect()
        }
        Value::Array(items) => items.into_iter().map(|item| spoilt(item, field, what)).collect(),
        other => other,
    }
}

/// Law: a question about an algebraic surface shrinks without end of the judge, though it may have no normal where it
/// is hit any more. Oracle: a program that says of every surface that it is missed.
#[test]
fn surfaces_without_a_normal_do_not_stop_the_judge() {
    let card =
        card(&mut Says(|_| json!(null)), &["intersect.algebraic.ordinary"], Profile::Careful, 4);
    assert!(card.is_failed());
}
