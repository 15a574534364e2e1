//! The laws of each kind: what its functions have to be to each other.

mod directed;
mod integrals;
mod lights;
mod lists;
mod maps;
mod pairs;
mod values;

use ask::Stop;
use serde_json::Value;

use crate::case::LobeCase;
use crate::description::{Claims, Kind};
use crate::light::LightCase;
use crate::map::MapCase;
use crate::setting::Case;

pub use integrals::Integrated;

/// A law.
pub struct Law {
    /// Its name on cards.
    pub name: &'static str,
    /// What it says.
    pub sentence: &'static str,
    /// What has usually been done where it is broken.
    pub cause: &'static str,
    /// Whether a subject of these claims is held to it.
    pub applies: fn(&Claims) -> bool,
    /// Whether it holds in a case.
    check: Check,
}

/// Whether a law holds in a case of a kind; for laws of chance, with so many times the usual samples.
enum Check {
    Lobe(fn(&mut LobeCase<'_>, usize) -> Result<Finding, Stop>),
    Light(fn(&mut LightCase<'_>, usize) -> Result<Finding, Stop>),
    Map(fn(&mut MapCase<'_>, usize) -> Result<Finding, Stop>),
}

impl Law {
    /// All laws of a kind. Those that say what others mean stand before them: the first that is broken names the mistake.
    pub fn of(kind: Kind) -> &'static [Self] {
        match kind {
            Kind::Lobe => &lists::LOBES,
            Kind::Light => &lists::LIGHTS,
            Kind::Map => &lists::MAPS,
        }
    }

    /// Whether nothing else can be held to a case in which it is broken: its values are no numbers, or negative.
    pub fn ends_a_case(&self) -> bool {
        self.name == "positive"
    }

    /// Whether it holds in a case of its kind; for laws of chance, with so many times the usual samples.
    ///
    /// # Errors
    /// Says why the program's answers cannot be judged.
    pub fn check(&self, case: &mut Case<'_>, scale: usize) -> Result<Finding, Stop> {
        match (&self.check, case) {
            (Check::Lobe(check), Case::Lobe(case)) => check(case, scale),
            (Check::Light(check), Case::Light(case)) => check(case, scale),
            (Check::Map(check), Case::Map(case)) => check(case, scale),
            _ => unreachable!("a law is asked for cases of its kind"),
        }
    }
}

/// What a law finds in a case.
#[derive(Clone, Debug)]
pub enum Finding {
    /// It holds, as far as this case tells.
    Holds,
    /// It cannot be told, and why.
    Undecided(String),
    /// It is broken.
    Broken(Breach),
    /// If it holds, numbers at least as far off have this probability.
    Chance(f64, Breach),
}

/// A case in which a law is broken.
#[derive(Clone, Debug)]
pub struct Breach {
    /// What was found.
    pub found: String,
    /// What the law says.
    pub expected: String,
    /// How far off that is, for cases of the same law: of two numbers their difference over the larger one, ∞ of a number
    /// that is none, 1 where nothing is between right and wrong.
    pub error: f64,
    /// The factor that was left out or put in, if it was recognised, in a sentence.
    pub mistake: Option<String>,
    /// The questions that show it.
    pub questions: Vec<Value>,
}

/// The difference of two numbers over the larger one; ∞ if there is none.
fn apart(found: f64, expected: f64) -> f64 {
    if found == expected {
        return 0.0;
    }
    let apart = (found - expected).abs() / found.abs().max(expected.abs());
    if apart.is_nan() { f64::INFINITY } else { apart }
}

/// The error of a number that should be finite and not negative.
fn negative(x: f64) -> f64 {
    if x.is_finite() { 1.0 } else { f64::INFINITY }
}
