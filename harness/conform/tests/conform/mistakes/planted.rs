//! Programs with mistakes, as tables.

use ask::{Reply, Subject};
use conform::mistakes::Mistake;
use serde_json::Value;

use super::super::altered::{Altered, instead, with};

/// A program with a mistake.
#[derive(Clone, Copy)]
pub struct Planted {
    /// The mistake, in words.
    pub what: &'static str,
    /// What is asked: exactly these families fail.
    pub wrong: &'static [&'static str],
    /// What the card has to say for each of them.
    pub name: Option<&'static Mistake>,
    /// What it does.
    pub way: Way,
}

/// What the program does.
#[derive(Clone, Copy)]
pub enum Way {
    /// Answers as we do, but for each number at a pointer.
    Numbers(&'static str, fn(f64) -> f64),
    /// Answers another question.
    Question(fn(&mut Value)),
    /// Makes its answer of the question and ours.
    Answer(fn(&Value, Value) -> Value),
}
pub use Way::{Answer, Numbers, Question};

impl Subject for Way {
    fn ask(&mut self, questions: &[Value]) -> Vec<Reply> {
        let way = *self;
        let alter = |question: &Value, answer: Value| match way {
            Numbers(pointer, of) => with(answer, pointer, of),
            Question(change) => instead(question, change),
            Answer(alter) => alter(question, answer),
        };
        Altered(alter).ask(questions)
    }
}

/// A table of programs: the name that the card has to say, or words for a mistake without a name; the families that fail;
/// and what the program does.
macro_rules! planted {
    (@ $name:ident) => { (m::$name.words(), Some(&m::$name)) };
    (@ $what:literal) => { ($what, None) };
    ($($mistake:tt in $wrong:expr => $way:expr;)*) => {
        /// All of them.
        pub(super) fn planted_here() -> Vec<super::planted::Planted> {
            vec![$({
                let (what, name) = planted!(@ $mistake);
                super::planted::Planted { what, wrong: &$wrong, name, way: $way }
            }),*]
        }
    };
}
pub(super) use planted;
