//! Who is asked: our own functions, or a program.

use serde_json::Value;

use crate::probe;

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

/// The functions of the library, without a process.
#[derive(Clone, Copy, Debug, Default)]
pub struct Ours;

impl Subject for Ours {
    fn ask(&mut self, questions: &[Value]) -> Vec<Reply> {
        let reply = |question: &Value| ours(question).map_err(Stop::Refused);
        questions.iter().map(reply).collect()
    }
}

/// Our own answer.
///
/// # Errors
/// The text of the probe, for a question that has no answer.
pub fn ours(question: &Value) -> Result<Value, String> {
    let line = probe::answer(&question.to_string());
    let mut reply: Value = serde_json::from_str(&line).expect("the probe prints JSON");
    match reply.get_mut("answer") {
        Some(answer) => Ok(answer.take()),
        None => Err(reply["error"].as_str().unwrap_or_default().to_owned()),
    }
}
