//! The smallest question that fails in the same way.
//!
//! A fixed list of changes of the JSON value: instances are unwrapped, fields and list items dropped, directions turned
//! to axes, numbers set to 0, 1, −1, whole numbers, fewer decimals. A change is kept if the answer is still wrong in the
//! same respect, and by at least a quarter of the first error: else a gross mistake turns into something that looks
//! like a tolerance.

use std::time::{Duration, Instant};

use serde_json::{Value, json};

use super::card::Failure;
use super::family::{Asking, Judge};
use super::judgement::{Judgement, Profile, Wrong, triple};
use super::subject::{Reply, Subject, ours};

/// Questions for one failure.
const MOST_QUESTIONS: usize = 500;
/// Time for one failure.
const MOST_TIME: Duration = Duration::from_secs(10);
/// The share of the first error that has to stay.
const SHARE: f64 = 0.25;

/// The failure with a smaller question.
pub fn smaller(
    subject: &mut dyn Subject,
    judge: Judge,
    first: Failure,
    profile: Profile,
) -> Failure {
    let begun = Instant::now();
    let least = SHARE * first.wrong.error;
    let symptom = first.wrong.symptom.clone();
    let mut best = first;
    let mut asked = 0;
    let mut changed = true;
    while changed {
        changed = false;
        for candidate in candidates(&best.question) {
            if asked >= MOST_QUESTIONS || begun.elapsed() > MOST_TIME {
                return best;
            }
            let is_question = keeps_units(&candidate) && ours(&candidate).is_ok();
            if candidate == best.question || !is_question {
                continue;
            }
            asked += 1;
            let found = fails(subject, judge, &candidate, profile);
            let Some(failure) = found else { continue };
            let is_same = failure.wrong.symptom == symptom && failure.wrong.error >= least;
            if is_same {
                best = failure;
                changed = true;
                break;
            }
        }
    }
    best
}

/// The failure of a question, if it fails.
fn fails(
    subject: &mut dyn Subject,
    judge: Judge,
    question: &Value,
    profile: Profile,
) -> Option<Failure> {
    let failure =
        |wrong: Box<Wrong>, asked| Failure { question: question.clone(), wrong: *wrong, asked };
    match judge {
        Judge::Answer(judge) => {
            let Some(Reply::Answer(answer)) = subject.ask(std::slice::from_ref(question)).pop()
            else {
                return None;
            };
            let Judgement::Wrong(wrong) = judge(question, &answer, profile) else { return None };
            Some(failure(wrong, vec![(question.clone(), answer.to_string())]))
        }
        Judge::Law(law) => {
            let mut asking = Asking::new(subject);
            let Ok(Judgement::Wrong(wrong)) = law(&mut asking, question, profile) else {
                return None;
            };
            let asked = asking.asked.into_iter().map(|(q, a)| (q, a.to_string())).collect();
            Some(failure(wrong, asked))
        }
    }
}

/// Whether directions that have to be unit are: another program may rely on it.
fn keeps_units(question: &Value) -> bool {
    let data = question.as_object().and_then(|object| object.values().next());
    let is_unit = |field: &str| {
        let vector = data.and_then(|data| triple(&data[field]));
        vector.is_none_or(|[x, y, z]| (x * x + y * y + z * z - 1.0).abs() < 1e-14)
    };
    ["wo", "wi", "n"].into_iter().all(is_unit)
}

/// Simpler questions, the simplest first.
fn candidates(question: &Value) -> Vec<Value> {
    let mut paths = Vec::new();
    collect(question, String::new(), &mut paths);
    let mut all = Vec::new();
    let mut with = |path: &str, change: &dyn Fn(&mut Value)| {
        let mut changed = question.clone();
        if let Some(slot) = changed.pointer_mut(path) {
            change(slot);
            all.push(changed);
        }
    };
    for (path, value) in &paths {
        if let Some(of) = value.pointer("/instance/of") {
            with(path, &|slot| *slot = of.clone());
        }
    }
    for (path, value) in &paths {
        match value {
            Value::Object(fields) if path.matches('/').count() > 0 => {
                for key in fields.keys() {
                    with(path, &|slot| {
                        slot.as_object_mut().map(|fields| fields.remove(key));
                    });
                }
            }
            Value::Array(items) if triple(value).is_none() => {
                for i in 0..items.len() {
                    with(path, &|slot| {
                        slot.as_array_mut().map(|items| items.remove(i));
                    });
                }
            }
            _ => {}
        }
    }
    const DIRECTIONS: [[f64; 3]; 8] = [
        [0.0, 0.0, 0.0],
        [0.0, 0.0, 1.0],
        [0.0, 1.0, 0.0],
        [1.0, 0.0, 0.0],
        [0.0, 0.0, -1.0],
        [0.6, 0.0, 0.8],
        [0.0, 0.6, 0.8],
        [1.0, 1.0, 1.0],
    ];
    let rank = |v: &[f64; 3]| v.iter().map(|x| weight(*x)).sum::<u32>();
    for (path, value) in &paths {
        let Some(vector) = triple(value) else { continue };
        for simple in DIRECTIONS.iter().filter(|simple| rank(simple) < rank(&vector)) {
            with(path, &|slot| *slot = json!(simple));
        }
    }
    for (path, value) in &paths {
        let Value::Number(number) = value else { continue };
        let is_whole = number.is_u64() || number.is_i64();
        let Some(x) = number.as_f64() else { continue };
        let simple = [0.0, 1.0, -1.0, x.trunc(), x.round()].into_iter();
        let decimals = [10.0, 100.0, 1000.0].into_iter().map(|scale| (x * scale).round() / scale);
        for y in simple.chain(decimals).filter(|y| weight(*y) < weight(x)) {
            with(path, &|slot| *slot = if is_whole { json!(y as i64) } else { json!(y) });
        }
    }
    all
}

/// How much a number has to be read: 0, then ±1, then the number of its digits.
fn weight(x: f64) -> u32 {
    match x {
        0.0 => 0,
        1.0 => 1,
        -1.0 => 2,
        x => 2 + format!("{x}").len() as u32,
    }
}

/// All values with their paths.
fn collect(value: &Value, path: String, paths: &mut Vec<(String, Value)>) {
    paths.push((path.clone(), value.clone()));
    match value {
        Value::Object(fields) => {
            fields.iter().for_each(|(key, value)| collect(value, format!("{path}/{key}"), paths));
        }
        Value::Array(items) => {
            let items = items.iter().enumerate();
            items.for_each(|(i, value)| collect(value, format!("{path}/{i}"), paths));
        }
        _ => {}
    }
}
