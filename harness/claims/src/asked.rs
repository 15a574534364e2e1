//! A subject under questions: its name and parameters, as they stand in each question, and why there is no answer.

use ask::{Reply, Stop, Subject, number, numbers};
use serde_json::{Map, Value, json};

use crate::description::Kind;

/// Directions, points or lists of random numbers in one question.
pub const BATCH: usize = 1000;

/// Random numbers that a sample may use: two for the direction, two more to choose and to terminate.
pub type Numbers = [f64; 4];

/// A subject of the program, with parameters.
pub struct Asked<'a> {
    subject: &'a mut dyn Subject,
    /// The name and the parameters.
    of: Value,
}

/// A subject whose questions are counted.
pub struct Counted<'a> {
    /// The subject.
    pub subject: &'a mut dyn Subject,
    /// How many there were.
    pub asked: usize,
}

impl Subject for Counted<'_> {
    fn ask(&mut self, questions: &[Value]) -> Vec<Reply> {
        self.asked += questions.len();
        self.subject.ask(questions)
    }
}

impl<'a> Asked<'a> {
    /// The subject of this kind and name, with these parameters.
    pub fn new(
        subject: &'a mut dyn Subject,
        (kind, name): (Kind, &str),
        parameters: &Map<String, Value>,
    ) -> Self {
        Self { subject, of: json!({kind.word(): name, "parameters": parameters}) }
    }

    /// The question of this name about these data.
    pub fn question<const N: usize>(&self, name: &str, data: [(&str, Value); N]) -> Value {
        let mut fields = self.of.clone();
        for (key, value) in data {
            fields[key] = value;
        }
        json!({name: fields})
    }

    /// The answers, in the order of the questions.
    ///
    /// # Errors
    /// Says why there are none.
    pub fn answers(&mut self, questions: &[Value]) -> Result<Vec<Value>, Stop> {
        self.subject.ask(questions).into_iter().collect()
    }
}

/// A list of so many values, which is the answer, or a field of it.
///
/// # Errors
/// Says what is there instead.
pub fn list<'v>(value: &'v Value, name: &str, count: usize) -> Result<&'v [Value], Stop> {
    let found = value.as_array().filter(|list| list.len() == count);
    let problem = || Stop::Refused(format!("{name} is no list of {count} values"));
    Ok(found.ok_or_else(problem)?.as_slice())
}

/// Three channels, or one number for all of them.
pub fn color(value: &Value) -> Option<[f64; 3]> {
    number(value).map(|x| [x; 3]).or_else(|| numbers(value)?.try_into().ok())
}

/// What was read of a value, or the words that it is none.
///
/// # Errors
/// Names the field and what stands there.
pub fn needed<T>(found: Option<T>, key: &str, value: &Value) -> Result<T, Stop> {
    found
        .ok_or_else(|| Stop::Refused(format!("`{key}` is {value}, which is no number of its form")))
}
