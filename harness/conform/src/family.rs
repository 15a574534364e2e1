//! Families of questions: what is asked, and who judges.

use serde_json::Value;

use super::judgement::{Judgement, Profile};
use super::mistakes::Mistake;
use super::program::WINDOW;
use super::subject::{Stop, Subject};

/// Questions of one kind about one thing, of one difficulty.
pub struct Family {
    /// As `intersect.torus.grazing`: the question, what it is about, and what makes it hard.
    pub name: String,
    /// What it is about, as `shapes/torus`.
    pub about: String,
    /// As `ch19`.
    pub chapter: &'static str,
    /// Whether single precision and a constant ε can answer it: the profile *book* asks only these.
    pub ordinary: bool,
    /// How many cases it has, compared with others.
    pub share: f64,
    /// The first so many cases of a seed.
    pub cases: Box<dyn Fn(u64, usize) -> Vec<Value> + Send + Sync>,
    /// Who judges a case.
    pub judge: Judge,
    /// Where known mistakes are looked for that the judge does not know.
    pub namer: Option<Namer>,
    /// Whether a failure is made smaller.
    pub is_shrunk: bool,
}

/// Looks for known mistakes.
#[derive(Clone, Copy)]
pub struct Namer {
    /// From what was asked for a wrong case, and what came, to the mistakes that explain it.
    pub explain: fn(&[(Value, Value)]) -> Vec<&'static Mistake>,
    /// Whether a program with this mistake would have answered this question, whose answer is right, in another way.
    pub refutes: fn(&(Value, Value), &'static Mistake) -> bool,
}

/// Who judges a case.
#[derive(Clone, Copy)]
pub enum Judge {
    /// From the answer to the question alone.
    Answer(fn(&Value, &Value, Profile) -> Judgement),
    /// A law: asks the question and others, and holds the answers against each other.
    Law(fn(&mut Asking<'_>, &Value, Profile) -> Result<Judgement, Stop>),
}

impl Family {
    /// Whether a word of the command line selects it: a chapter (`ch19`), a thing (`shapes/torus`), or the beginning
    /// of a thing or of a name that ends where a word ends: before `/`, `.` or `_`. So `intersect`, `light.area` (as in
    /// `light.area.sphere.area`), `shapes/solid`; but not `intersect.tor`.
    pub fn is_selected_by(&self, word: &str) -> bool {
        let begins = |name: &str| {
            name.strip_prefix(word)
                .is_some_and(|rest| rest.is_empty() || rest.starts_with(['/', '.', '_']))
        };
        self.chapter == word || (!word.is_empty() && (begins(&self.about) || begins(&self.name)))
    }

    /// The question's name, as `intersect`.
    pub fn question(&self) -> &str {
        self.name.split('.').next().unwrap_or(&self.name)
    }
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
