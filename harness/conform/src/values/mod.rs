//! Answers held against our own, for what has no exact oracle.
//!
//! How much an answer depends on rounding is measured: each number of the question is moved a little, and our own
//! function asked again. An error is judged in u·cond like those of intersections, where `cond` is the sum of all
//! these changes over the relative move; an answer that jumps is not judged.

mod clues;

use ask::{nan_in, number, numbers};
use serde_json::Value;

use super::family::Namer;
use super::judgement::{Judgement, Profile, Wrong, first_wrong};
use super::mistakes;
use super::probe::ours;
use groundtruth::math::UNIT_ROUNDOFF;

/// How answers of one family are compared. Fields that ours do not have are not judged; a list has as many items as
/// ours.
#[derive(Clone, Debug)]
pub struct Rules {
    /// Fields of an answer of which at least these must be there; others are judged if they are.
    pub needed: Vec<String>,
    /// Fields that are not judged.
    pub free: Vec<String>,
}

/// All fields are needed, none is free.
pub static WHOLE: Rules = Rules { needed: Vec::new(), free: Vec::new() };

impl Rules {
    fn is_free(&self, field: &str) -> bool {
        self.free.iter().any(|it| it == field)
    }
}

/// Judges know mistakes themselves; right answers say which of them the program has not made.
pub const NAMER: Namer = Namer { explain: |_| Vec::new(), refutes: clues::refutes };

/// The relative move of each number; derivatives are right to half of the digits.
const MOVE: f64 = 1e-9;
/// An answer that changes by more than this share of itself has jumped.
const JUMP: f64 = 1e-3;
/// Longer lists are not moved.
const LONGEST: usize = 100;
/// Below this size, errors are absolute: values are shares of 1, and colours.
const UNIT: f64 = 1.0;

/// A part of an answer that is judged.
#[derive(Clone, Debug)]
pub(super) struct Leaf {
    /// The path with dots, as `sample.wi`.
    pub(super) field: String,
    right: Part,
}

#[derive(Clone, Debug, PartialEq)]
enum Part {
    Number(f64),
    Numbers(Vec<f64>),
    /// The number of items of a list, which are parts of their own.
    Items(usize),
    Other(Value),
}

impl Part {
    /// The numbers of a number or of a list of them.
    fn numbers(&self) -> Option<&[f64]> {
        match self {
            Self::Number(x) => Some(std::slice::from_ref(x)),
            Self::Numbers(all) => Some(all),
            _ => None,
        }
    }
}

impl Leaf {
    /// What stands in another answer in its place.
    pub(super) fn of<'a>(&self, answer: &'a Value) -> Option<&'a Value> {
        let step = |value: &'a Value, key: &str| match value {
            Value::Array(items) => items.get(key.parse::<usize>().ok()?),
            other => other.get(key),
        };
        let mut path = self.field.split('.').filter(|key| !key.is_empty());
        path.try_fold(answer, step)
    }

    /// Whether its place is in something that is not there: `null` or a missing item, and not an object without the field.
    fn is_of_nothing(&self, answer: &Value) -> bool {
        let mut value = Some(answer);
        for key in self.field.split('.') {
            match value {
                Some(Value::Null) => return true,
                Some(it @ Value::Object(_)) => value = it.get(key),
                Some(Value::Array(items)) => {
                    match key.parse().ok().and_then(|at: usize| items.get(at)) {
                        // of a shorter list: its length is judged
                        None => return true,
                        item => value = item,
                    }
                }
                _ => return false,
            }
        }
        false
    }

    /// The numbers that stand in its place, where they are as many as ours: one, or a list.
    fn numbers_in(&self, theirs: &Value) -> Option<Vec<f64>> {
        match self.right {
            Part::Numbers(_) => numbers(theirs),
            _ => number(theirs).map(|x| vec![x]),
        }
    }

    /// Whether what stands in its place is not a number, or a list with one that is none.
    fn is_nan_in(&self, theirs: &Value) -> bool {
        nan_in(theirs) && matches!(self.right, Part::Numbers(_)) == theirs.is_array()
    }

    /// Its name in messages.
    fn name(&self) -> &str {
        if self.field.is_empty() { "value" } else { &self.field }
    }

    /// What is right, for messages.
    fn shown(&self) -> String {
        let value = match &self.right {
            Part::Number(x) => format!("{x:?}"),
            Part::Numbers(all) => format!("{all:?}"),
            Part::Items(n) => format!("a list of {n}"),
            Part::Other(value) => value.to_string(),
        };
        if self.field.is_empty() { value } else { format!("{} = {value}", self.field) }
    }
}

/// The leaves of an answer that are judged: lists of numbers are one.
fn leaves(answer: &Value, rules: &Rules) -> Vec<Leaf> {
    let mut all = Vec::new();
    collect(answer, "", &mut all);
    let is_free = |leaf: &Leaf| leaf.field.split('.').any(|part| rules.is_free(part));
    all.retain(|leaf| !is_free(leaf));
    all
}

fn collect(value: &Value, field: &str, all: &mut Vec<Leaf>) {
    let inside =
        |key: &str| if field.is_empty() { key.to_owned() } else { format!("{field}.{key}") };
    let leaf = |right: Part| Leaf { field: field.to_owned(), right };
    match value {
        Value::Object(fields) => {
            fields.iter().for_each(|(key, value)| collect(value, &inside(key), all));
        }
        Value::Array(items) => match numbers(value) {
            Some(numbers) if !numbers.is_empty() => all.push(leaf(Part::Numbers(numbers))),
            _ => {
                all.push(leaf(Part::Items(items.len())));
                let items = items.iter().enumerate();
                items.for_each(|(i, item)| collect(item, &inside(&i.to_string()), all));
            }
        },
        other => match number(other) {
            Some(x) => all.push(leaf(Part::Number(x))),
            None => all.push(leaf(Part::Other(other.clone()))),
        },
    }
}

/// A judgement, and whether it holds however much the right answer depends on rounding: another type of JSON, a field
/// that is left out, a number that is none.
type Found = (Judgement, bool);

/// Judges by our own answer.
pub fn judge(question: &Value, theirs: &Value, profile: Profile, rules: &Rules) -> Judgement {
    let Ok(right) = ours(question) else { return Judgement::Undecided };
    let (mut judgement, leaf) = compare((question, &right), theirs, profile, rules);
    let Judgement::Wrong(wrong) = &mut judgement else { return judgement };
    wrong.clues = leaf.map_or(Vec::new(), |leaf| clues::of_leaf(question, &leaf, &right, theirs));
    wrong.clues.retain(|it| !clues::is_contradicted((question, &right), theirs, it));
    // where there is something and should be nothing, or the other way round, no numbers are compared
    let is_answer = theirs.is_null() || theirs.is_object();
    match is_answer && wrong.theirs.is_empty() && wrong.clues.is_empty() {
        true if theirs.is_null() => judgement.beside(clues::of_answer(question, &right, theirs)),
        true => judgement.with(clues::of_answer(question, &right, theirs)),
        false => judgement,
    }
}

/// Judges by the right answer: what is wrong first, and where.
fn compare(
    (question, right): (&Value, &Value),
    theirs: &Value,
    profile: Profile,
    rules: &Rules,
) -> (Judgement, Option<Leaf>) {
    let ours = leaves(right, rules);
    let check = |(leaf, cond): (&Leaf, f64)| match leaf.of(theirs) {
        Some(their) => judge_leaf(leaf, their, cond, profile),
        None => missing(leaf, right, theirs, rules),
    };
    // what is right for a condition of 1 needs no other: measuring it takes a call for each number
    let found: Vec<Found> = ours.iter().map(|leaf| check((leaf, 0.0))).collect();
    let is_certain = |(judgement, certain): &Found| *certain && !judgement.is_right();
    if let Some(at) = found.iter().position(is_certain) {
        return (found[at].0.clone(), Some(ours[at].clone()));
    }
    if let found @ (Judgement::Right(_) | Judgement::Lacks(_)) =
        first_wrong(found.into_iter().map(|(it, _)| it))
    {
        return (found, None);
    }
    let Some(conditions) = conditions(question, right, profile, rules) else {
        return (Judgement::Undecided, None);
    };
    let judged: Vec<_> = ours.iter().zip(conditions).map(|leaf| check(leaf).0).collect();
    let first = judged.iter().position(|it| !it.is_right()).map(|at| ours[at].clone());
    (first_wrong(judged), first)
}

/// A field that is not needed may be left out, but not replaced by something else.
fn missing(leaf: &Leaf, right: &Value, theirs: &Value, rules: &Rules) -> Found {
    let first = leaf.field.split('.').next().unwrap_or_default();
    let is_needed = rules.needed.is_empty() || rules.needed.iter().any(|it| it == first);
    if right.is_object() && theirs.is_object() && theirs.get(first).is_none() {
        // what is left out is named, if there is something else to judge
        let is_judged = |field: &str| !rules.is_free(field) && theirs.get(field).is_some();
        match right.as_object().is_some_and(|all| all.keys().any(|field| is_judged(field))) {
            _ if !is_needed => return (Judgement::Right(0.0), true),
            true => return (Judgement::Lacks(first.to_owned()), true),
            false => {}
        }
    }
    let (symptom, certain) = match theirs {
        Value::Null => ("null".to_owned(), false),
        _ => (format!("{} is missing", leaf.name()), !leaf.is_of_nothing(theirs)),
    };
    (Judgement::wrong(&symptom, f64::INFINITY, leaf.shown()), certain)
}

fn judge_leaf(leaf: &Leaf, their: &Value, cond: f64, profile: Profile) -> Found {
    let wrong = |symptom: String| Judgement::wrong(&symptom, f64::INFINITY, leaf.shown());
    let of_other_type = || (wrong(leaf.name().to_owned()), !their.is_null());
    let right = match &leaf.right {
        Part::Number(_) | Part::Numbers(_) => leaf.right.numbers().unwrap_or_default(),
        Part::Items(n) => {
            return match their.as_array() {
                Some(items) if items.len() == *n => (Judgement::Right(0.0), true),
                Some(items) => (wrong(format!("{}: {} items", leaf.name(), items.len())), false),
                None => of_other_type(),
            };
        }
        Part::Other(value) if value == their => return (Judgement::Right(0.0), true),
        Part::Other(value) => {
            let is_other = std::mem::discriminant(value) != std::mem::discriminant(their);
            return (wrong(leaf.name().to_owned()), is_other && !value.is_null());
        }
    };
    if right.iter().any(|x| x.is_nan()) {
        return (Judgement::Undecided, false);
    }
    if leaf.is_nan_in(their) {
        return (wrong(format!("{} is not a number", leaf.name())), true);
    }
    let Some(theirs) = leaf.numbers_in(their) else { return of_other_type() };
    let size = largest(right).max(UNIT);
    let error = distance(&theirs, right) / (UNIT_ROUNDOFF * cond.max(size));
    if error <= profile.allowed() {
        return (Judgement::Right(error), false);
    }
    let is_too_large =
        theirs.iter().zip(right).any(|(their, right)| their.is_infinite() && right.is_finite());
    let symptom = match (theirs.len() == right.len(), is_too_large) {
        (false, _) => format!("{}: {} numbers", leaf.name(), theirs.len()),
        (true, true) => format!("{} is infinite", leaf.name()),
        (true, false) => leaf.name().to_owned(),
    };
    let wrong = Wrong {
        symptom,
        error,
        expected: leaf.shown(),
        clues: Vec::new(),
        beside: Vec::new(),
        ratio: mistakes::ratio(&theirs, right),
        // a list of another length has no meaning, and may be long
        theirs: if theirs.len() == right.len() { theirs } else { Vec::new() },
    };
    (Judgement::Wrong(Box::new(wrong)), false)
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
            if a.field != b.field {
                return None;
            }
            match (a.right.numbers(), b.right.numbers()) {
                (Some(a), Some(b)) => {
                    let change = distance(a, b);
                    // a jump does not shrink with the move
                    if change > JUMP.max(step * 1e3) * largest(a).max(UNIT) {
                        return None;
                    }
                    *condition += change / step;
                }
                _ if a.right != b.right => return None,
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
        // a table, as of a lattice: the answer depends on it as on the formula
        Value::Array(items) if items.len() > LONGEST => {}
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
