//! Families of questions: what is asked, and who judges.

use ask::{Asking, Stop};
use serde_json::Value;

use super::judgement::{Judgement, Profile};
use super::mistakes::Mistake;
use super::values::Rules;

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

/// Judges an answer to a question, by the rules of its family.
pub type ByAnswer = fn(&Value, &Value, Profile, &Rules) -> Judgement;

/// Who judges a case.
#[derive(Clone, Copy)]
pub enum Judge {
    /// From the answer to the question alone.
    Answer(ByAnswer, &'static Rules),
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
