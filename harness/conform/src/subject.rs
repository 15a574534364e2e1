//! The subject that we are ourselves.

use ask::{Reply, Stop, Subject};
use serde_json::Value;

use crate::probe::ours;

/// The functions of the library, without a process.
#[derive(Clone, Copy, Debug, Default)]
pub struct Ours;

impl Subject for Ours {
    fn ask(&mut self, questions: &[Value]) -> Vec<Reply> {
        let reply = |question: &Value| ours(question).map_err(Stop::Refused);
        questions.iter().map(reply).collect()
    }
}
