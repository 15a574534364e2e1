//! Answers held against our own, for what has no exact oracle.
//!
//! How much an answer depends on rounding is measured: each number of the question is moved a little, and our own
//! function asked again. An error is judged in u·cond like those of intersections, where `cond` is the sum of all
//! these changes over the relative move; an answer that jumps is not judged.

use serde_json::Value;

use super::judgement::{Judgement, Profile, Wrong, first_wrong, number};
use super::mistakes::{self, Mistake, clues, same};
use super::subject::ours;
use groundtruth::math::UNIT_ROUNDOFF;

/// A mistake that is another question: turns the question into it, if it applies.
pub type AsQuestion = (&'static Mistake, fn(&mut Value) -> Option<()>);
/// A mistake that is another value of a field: from question, field name and our answer.
pub type AsAnswer = (&'static Mistake, fn(&Value, &str, &Value) -> Option<Vec<f64>>);

/// How answers of one question are compared.
#[derive(Clone, Copy)]
pub struct Rules {
    /// Fields of an answer of which at least these must be there; others are judged if they are.
    pub needed: &'static [&'static str],
    /// Fields that are not judged.
    pub free: &'static [&'static str],
    /// Mistakes that are another question: what our function answers to it is what they would.
    pub questions: &'static [AsQuestion],
    /// Mistakes that are another value of a field.
    pub answers: &'static [AsAnswer],
}

/// The relative move of each number; derivatives are right to half of the digits.
const MOVE: f64 = 1e-9;
/// An answer that changes by more than this share of itself has jumped.
const JUMP: f64 = 1e-3;
/// Below this size, errors are absolute: values are shares of 1, and colours.
const UNIT: f64 = 1.0;

/// A number, a list of numbers, or something else, at a path of an answer.
#[derive(Clone, Debug)]
struct Leaf {
    field: String,
    value: Option<Vec<f64>>,
    other: Value,
}

/// The leaves of an answer that are judged: lists of numbers are one.
fn leaves(answer: &Value, rules: &Rules) -> Vec<Leaf> {
    let mut all = Vec::new();
    collect(answer, "", &mut all);
    let is_free = |leaf: &Leaf| leaf.field.split('.').any(|part| rules.free.contains(&part));
    all.retain(|leaf| !is_free(leaf));
    all
}

fn collect(value: &Value, field: &str, all: &mut Vec<Leaf>) {
    let inside =
        |key: &str| if field.is_empty() { key.to_owned() } else { format!("{field}.{key}") };
    let leaf =
        |value: Option<Vec<f64>>, other: Value| Leaf { field: field.to_owned(), value, other };
    match value {
        Value::Object(fields) => {
            fields.iter().for_each(|(key, value)| collect(value, &inside(key), all));
        }
        Value::Array(items) => match items.iter().map(number).collect::<Option<Vec<f64>>>() {
            Some(numbers) if !numbers.is_empty() => all.push(leaf(Some(numbers), Value::Null)),
            Some(_) => all.push(leaf(None, value.clone())),
            None => {
                let items = items.iter().enumerate();
                items.for_each(|(i, item)| collect(item, &inside(&i.to_string()), all));
            }
        },
        other => match number(other) {
            Some(x) => all.push(leaf(Some(vec![x]), Value::Null)),
            None => all.push(leaf(None, other.clone())),
        },
    }
}

/// Judges by our own answer.
pub fn judge(question: &Value, theirs: &Value, profile: Profile, rules: &Rules) -> Judgement {
    let Ok(right) = ours(question) else { return Judgement::Undecided };
    let theirs = leaves(theirs, rules);
    let ours = leaves(&right, rules);
    let check = |(leaf, cond): (&Leaf, f64)| match theirs.iter().find(|it| it.field == leaf.field) {
        Some(their) => judge_leaf(question, &right, leaf, their, cond, profile, rules),
        None => missing(leaf, &theirs, rules),
    };
    // what is right for a condition of 1 needs no other: measuring it takes a call for each number
    if let found @ Judgement::Right(_) = first_wrong(ours.iter().map(|leaf| check((leaf, 0.0)))) {
        return found;
    }
    let Some(conditions) = conditions(question, &right, profile, rules) else {
        return Judgement::Undecided;
    };
    first_wrong(ours.iter().zip(conditions).map(check))
}

/// Fields that are not needed may be left out; of what is needed, something may be there in its place.
fn missing(leaf: &Leaf, theirs: &[Leaf], rules: &Rules) -> Judgement {
    let first = leaf.field.split('.').next().unwrap_or_default();
    let is_needed =
        leaf.field.is_empty() || rules.needed.contains(&first) || rules.needed.is_empty();
    let expected = shown(leaf);
    match is_needed {
        false => Judgement::Right(0.0),
        // null, or nothing at all
        true if theirs.iter().all(|leaf| leaf.other.is_null() && leaf.value.is_none()) => {
            Judgement::wrong("null", f64::INFINITY, expected)
        }
        true => {
            let what = if leaf.field.is_empty() { "value" } else { &leaf.field };
            Judgement::wrong(&format!("{what} is missing"), f64::INFINITY, expected)
        }
    }
}

fn shown(leaf: &Leaf) -> String {
    let value = match &leaf.value {
        Some(numbers) if numbers.len() == 1 => format!("{:?}", numbers[0]),
        Some(numbers) => format!("{numbers:?}"),
        None => leaf.other.to_string(),
    };
    if leaf.field.is_empty() { value } else { format!("{} = {value}", leaf.field) }
}

fn judge_leaf(
    question: &Value,
    answer: &Value,
    right: &Leaf,
    their: &Leaf,
    cond: f64,
    profile: Profile,
    rules: &Rules,
) -> Judgement {
    let symptom = if right.field.is_empty() { "value" } else { &right.field };
    let (Some(theirs), Some(numbers)) = (&their.value, &right.value) else {
        let is_same = their.value.is_none() && right.value.is_none() && their.other == right.other;
        return match is_same {
            true => Judgement::Right(0.0),
            false => Judgement::wrong(symptom, f64::INFINITY, shown(right)),
        };
    };
    let size = largest(numbers).max(UNIT);
    let error = distance(theirs, numbers) / (UNIT_ROUNDOFF * cond.max(size));
    if error <= profile.allowed() {
        return Judgement::Right(error);
    }
    let mut found = clues(theirs, numbers);
    for (mistake, change) in rules.questions {
        let mut changed = question.clone();
        if change(&mut changed).is_none() {
            continue;
        }
        let Ok(other) = ours(&changed) else { continue };
        let other = leaves(&other, rules).into_iter().find(|leaf| leaf.field == right.field);
        let Some(other) = other.and_then(|leaf| leaf.value) else { continue };
        if same(theirs, &other) && !same(numbers, &other) {
            found.push(mistake);
        }
    }
    for (mistake, alternative) in rules.answers {
        let Some(other) = alternative(question, &right.field, answer) else { continue };
        if same(theirs, &other) && !same(numbers, &other) {
            found.push(mistake);
        }
    }
    let ratio = mistakes::ratio(theirs, numbers);
    let (symptom, expected) = (symptom.to_owned(), shown(right));
    Judgement::Wrong(Box::new(Wrong { symptom, error, expected, clues: found, ratio }))
}

fn largest(numbers: &[f64]) -> f64 {
    numbers.iter().filter(|x| x.is_finite()).fold(0.0, |most, x| most.max(x.abs()))
}

/// The largest difference; infinite if one is no number, or if the lists have different lengths.
fn distance(a: &[f64], b: &[f64]) -> f64 {
    if a.len() != b.len() {
        return f64::INFINITY;
    }
    let difference = |(a, b): (&f64, &f64)| if a == b { 0.0 } else { (a - b).abs() };
    let all = a.iter().zip(b).map(difference);
    all.fold(0.0, |most: f64, x| if x.is_nan() { f64::INFINITY } else { most.max(x) })
}

/// The condition of each leaf: the sum of its changes over the relative move, for each number of the question.
/// `None` if a leaf jumps.
fn conditions(
    question: &Value,
    right: &Value,
    profile: Profile,
    rules: &Rules,
) -> Option<Vec<f64>> {
    let step = if profile == Profile::Book { profile.margin() } else { MOVE };
    let right = leaves(right, rules);
    let mut conditions = vec![0.0; right.len()];
    for moved in moved(question, step) {
        // where there is no answer beside it, the number is at the end of its range
        let Ok(other) = ours(&moved) else { continue };
        let other = leaves(&other, rules);
        if other.len() != right.len() {
            return None;
        }
        for ((a, b), condition) in right.iter().zip(&other).zip(&mut conditions) {
            match (&a.value, &b.value) {
                (Some(a), Some(b)) => {
                    let change = distance(a, b);
                    // a jump does not shrink with the move
                    if change > JUMP.max(step * 1e3) * largest(a).max(UNIT) {
                        return None;
                    }
                    *condition += change / step;
                }
                _ if a.other != b.other || a.value.is_some() != b.value.is_some() => return None,
                _ => {}
            }
        }
    }
    Some(conditions)
}

/// The question with one of its numbers moved, for each of them: in a list of numbers by a share of the largest.
fn moved(question: &Value, step: f64) -> Vec<Value> {
    let mut paths = Vec::new();
    numbers_in(question, String::new(), 0.0, &mut paths);
    let change = |(path, size): (String, f64)| {
        let mut changed = question.clone();
        let slot = changed.pointer_mut(&path)?;
        let number = slot.as_f64()?;
        *slot = Value::from(number + step * size);
        Some(changed)
    };
    paths.into_iter().filter_map(change).collect()
}

fn numbers_in(value: &Value, path: String, size: f64, paths: &mut Vec<(String, f64)>) {
    match value {
        Value::Object(fields) => {
            fields
                .iter()
                .for_each(|(key, value)| numbers_in(value, format!("{path}/{key}"), 0.0, paths));
        }
        Value::Array(items) => {
            let size =
                items.iter().filter_map(Value::as_f64).fold(0.0, |most: f64, x| most.max(x.abs()));
            let items = items.iter().enumerate();
            items.for_each(|(i, value)| numbers_in(value, format!("{path}/{i}"), size, paths));
        }
        Value::Number(number) => {
            let size = size.max(number.as_f64().unwrap_or(0.0).abs());
            if size > 0.0 {
                paths.push((path, size));
            }
        }
        _ => {}
    }
}
