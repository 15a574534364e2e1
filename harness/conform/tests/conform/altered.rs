//! Our own answers, altered; and families of one's own.

use ask::{Reply, Stop, Subject};
use std::sync::Arc;

use conform::family::{Family, Judge};
use conform::{self, Card, Options, Profile, ours};
use serde_json::{Value, json};

/// Answers by a function.
pub struct Says<F: FnMut(&Value) -> Value>(pub F);

impl<F: FnMut(&Value) -> Value> Subject for Says<F> {
    fn ask(&mut self, questions: &[Value]) -> Vec<Reply> {
        questions.iter().map(|question| Ok((self.0)(question))).collect()
    }
}

/// Answers as we do, then changes the answer.
pub struct Altered<F: FnMut(&Value, Value) -> Value>(pub F);

impl<F: FnMut(&Value, Value) -> Value> Subject for Altered<F> {
    fn ask(&mut self, questions: &[Value]) -> Vec<Reply> {
        let reply = |question: &Value| match ours(question) {
            Ok(answer) => Ok((self.0)(question, answer)),
            Err(error) => Err(Stop::Refused(error)),
        };
        questions.iter().map(reply).collect()
    }
}

/// The families that one of these words selects; all, if there is none.
pub fn families(words: &[&str]) -> Vec<Family> {
    let mut families = conform::suite::all();
    families
        .retain(|family| words.is_empty() || words.iter().any(|word| family.is_selected_by(word)));
    assert!(!families.is_empty(), "nothing is called {words:?}");
    families
}

/// A family of these cases of chapter 3.
pub fn family(
    name: &str,
    judge: Judge,
    cases: impl Fn(usize) -> Vec<Value> + Send + Sync + 'static,
) -> Family {
    Family {
        name: name.to_owned(),
        about: "tests/own".to_owned(),
        chapter: "ch03",
        ordinary: true,
        share: 1.0,
        cases: Box::new(move |_, n| cases(n)),
        judge,
        namer: None,
        is_shrunk: true,
    }
}

/// So many cases with care, none of which is made smaller.
pub fn options(cases: usize) -> Options {
    let (profile, interrupted) = (Profile::Careful, Arc::default());
    Options { profile, seed: 7, cases, shrink: false, interrupted }
}

/// A run over these families.
pub fn card(subject: &mut dyn Subject, words: &[&str], profile: Profile, cases: usize) -> Card {
    card_with(subject, words, profile, cases, true)
}

/// A run over these families; `shrink` says whether failures are made small.
pub fn card_with(
    subject: &mut dyn Subject,
    words: &[&str],
    profile: Profile,
    cases: usize,
    shrink: bool,
) -> Card {
    let options = Options { profile, shrink, ..options(cases) };
    conform::run(subject, &families(words), &options, &mut |_| {}).expect("it answers")
}

/// Our answer to the question changed.
pub fn instead(question: &Value, change: impl FnOnce(&mut Value)) -> Value {
    let mut changed = question.clone();
    let name = changed.as_object().and_then(|it| it.keys().next().cloned()).unwrap_or_default();
    change(&mut changed[&name]);
    ours(&changed).unwrap_or_else(|_| json!(null))
}

/// The data of a question.
pub fn data(question: &Value) -> &Value {
    question.as_object().and_then(|it| it.values().next()).expect("a question has data")
}

/// The kind's own data: `{"sphere": {…}}` without its tag.
pub fn only(kind: &mut Value) -> &mut Value {
    kind.as_object_mut().and_then(|it| it.values_mut().next()).expect("a kind has data")
}

/// Applies a function to a number, or to each number of a list.
pub fn each(value: &mut Value, of: impl Fn(f64) -> f64) {
    let one = |value: &mut Value| {
        if let Some(x) = value.as_f64() {
            *value = json!(of(x));
        }
    };
    match value {
        Value::Array(items) => items.iter_mut().for_each(one),
        other => one(other),
    }
}

/// Applies a function to what is there, if it is.
pub fn at(value: &mut Value, pointer: &str, of: impl Fn(f64) -> f64) {
    if let Some(value) = value.pointer_mut(pointer) {
        each(value, of);
    }
}

/// The answer with a function applied to what is there, if it is.
pub fn with(mut answer: Value, pointer: &str, of: impl Fn(f64) -> f64) -> Value {
    at(&mut answer, pointer, of);
    answer
}

/// A value with a function applied to every number.
pub fn all_numbers(value: Value, of: &impl Fn(f64) -> Value) -> Value {
    match value {
        Value::Number(number) => of(number.as_f64().unwrap_or(0.0)),
        Value::Array(items) => items.into_iter().map(|item| all_numbers(item, of)).collect(),
        Value::Object(fields) => {
            fields.into_iter().map(|(name, item)| (name, all_numbers(item, of))).collect()
        }
        other => other,
    }
}

/// Exchanges two items of a list.
pub fn swap(value: &mut Value, i: usize, j: usize) {
    if let Some(items) = value.as_array_mut() {
        items.swap(i, j);
    }
}

/// Three numbers.
pub fn vector(value: &Value) -> [f64; 3] {
    std::array::from_fn(|i| value[i].as_f64().unwrap_or(0.0))
}

/// The length of three numbers.
pub fn length(value: &Value) -> f64 {
    vector(value).iter().map(|x| x * x).sum::<f64>().sqrt()
}
