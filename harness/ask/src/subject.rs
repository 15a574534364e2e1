//! Who is asked, and what came back.

use serde_json::Value;

use super::program::WINDOW;

/// What came back for a question: the value of `"answer"`, or why there is none.
pub type Reply = Result<Value, Stop>;

/// Why a question has no answer.
#[derive(Clone, Debug, PartialEq)]
pub enum Stop {
    /// The text of `"error"`.
    Refused(String),
    /// The text of `"unsupported"`.
    Unsupported(String),
    /// Nothing that can be read.
    Fault(Fault),
    /// The run was interrupted before the question was answered, or too many before it had no reply.
    NotAsked,
    /// The judge of the answer failed: a fault of ours.
    Ours(String),
}

impl Stop {
    /// The program's words, or what happened.
    pub fn text(&self) -> &str {
        match self {
            Self::Unsupported(text) | Self::Refused(text) | Self::Ours(text) => text,
            Self::Fault(fault) => fault.text(),
            Self::NotAsked => "interrupted",
        }
    }
}

/// Why there is no reply that can be read.
#[derive(Clone, Debug, PartialEq)]
pub enum Fault {
    /// No reply within the time limit.
    Hung(String),
    /// The program ended, or closed its output.
    Died(String),
    /// A line that is no reply to a question under way.
    Garbled(String),
}

impl Fault {
    /// What happened.
    pub fn text(&self) -> &str {
        let (Self::Hung(text) | Self::Died(text) | Self::Garbled(text)) = self;
        text
    }
}

/// Something that answers the questions of the probe (`docs/probe.md`).
pub trait Subject {
    /// The replies to these questions, in their order.
    fn ask(&mut self, questions: &[Value]) -> Vec<Reply>;
}

/// Values in an answer to a law; those of a lattice are the most.
const MOST_ITEMS: usize = 1 << 14;

/// The values in an answer, of lists and fields, too.
fn items(answer: &Value) -> usize {
    match answer {
        Value::Array(all) => all.len() + all.iter().map(items).sum::<usize>(),
        Value::Object(fields) => fields.len() + fields.values().map(items).sum::<usize>(),
        _ => 0,
    }
}

/// A law's way to ask: remembers what was asked, so that a broken law can be shown.
pub struct Asking<'a> {
    subject: &'a mut dyn Subject,
    /// Questions and answers, in their order.
    pub asked: Vec<(Value, Value)>,
}

impl<'a> Asking<'a> {
    /// Asks this subject.
    pub fn new(subject: &'a mut dyn Subject) -> Self {
        Self { subject, asked: Vec::new() }
    }

    /// The answer to one question.
    ///
    /// # Errors
    /// [`Stop`] if there is none.
    pub fn ask(&mut self, question: &Value) -> Result<Value, Stop> {
        Ok(self.ask_all(std::slice::from_ref(question))?.remove(0))
    }

    /// The answers to questions, in their order.
    ///
    /// # Errors
    /// [`Stop`] if one has none.
    pub fn ask_all(&mut self, questions: &[Value]) -> Result<Vec<Value>, Stop> {
        let mut answers = Vec::with_capacity(questions.len());
        for questions in questions.chunks(WINDOW) {
            for (question, reply) in questions.iter().zip(self.subject.ask(questions)) {
                let answer = reply?;
                // no right answer is so long, and a law may ask a thousand questions
                let answer = if items(&answer) > MOST_ITEMS { Value::Null } else { answer };
                self.asked.push((question.clone(), answer.clone()));
                answers.push(answer);
            }
        }
        Ok(answers)
    }
}
