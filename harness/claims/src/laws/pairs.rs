//! Numbers that should be equal, to rounding; and answers that should be the same.

use ask::Stop;
use serde_json::Value;

use super::{Breach, Finding, apart};
use crate::asked::{Asked, Numbers};
use crate::naming::{Factor, Given, factor};

/// How two numbers that should be equal were found.
pub struct Equality {
    /// Where.
    pub given: Given,
    /// Of the sample, if there is one.
    pub u: Numbers,
    /// What was found.
    pub found: f64,
    /// What it should be.
    pub expected: f64,
    /// How far apart they may be.
    pub slack: f64,
}

impl Equality {
    /// How far apart they are, in slacks.
    fn off(&self) -> f64 {
        let apart = (self.found - self.expected).abs() / self.slack.max(f64::MIN_POSITIVE);
        if apart.is_nan() { f64::INFINITY } else { apart }
    }
}

/// Broken where a pair differs by more than its slack; the worst is shown, with its questions, and the factor between
/// all of them is named.
pub fn equal(
    pairs: &[Equality],
    factors: &[Factor],
    [found, expected]: [&str; 2],
    shown: impl Fn(&Equality) -> (String, Vec<Value>),
) -> Finding {
    let worst = pairs.iter().max_by(|a, b| a.off().total_cmp(&b.off()));
    let Some(worst) = worst.filter(|pair| pair.off() > 1.0) else { return Finding::Holds };
    let ratio = |pair: &Equality| (pair.found / pair.expected, pair.given);
    let ratios: Vec<_> = pairs.iter().filter(|pair| pair.off() > 1.0).map(ratio).collect();
    let (place, questions) = shown(worst);
    Finding::Broken(Breach {
        found: format!("{found} = {:.6e} at {place}", worst.found),
        expected: format!("{expected} = {:.6e}", worst.expected),
        error: apart(worst.found, worst.expected),
        mistake: factor(&ratios, factors)
            .map(|factor| format!("what is found is {factor} times what is expected")),
        questions,
    })
}

/// Whether these questions have the same answers again, with others asked between.
pub fn repeated(
    asked: &mut Asked<'_>,
    questions: &[Value],
    between: &[Value],
) -> Result<Finding, Stop> {
    let first = asked.answers(questions)?;
    for (question, expected) in questions.iter().zip(&first) {
        asked.answers(between)?;
        let found = &asked.answers(std::slice::from_ref(question))?[0];
        if expected != found {
            return Ok(Finding::Broken(Breach {
                found: format!("asked again: {found}"),
                expected: expected.to_string(),
                error: 1.0,
                mistake: None,
                questions: vec![question.clone()],
            }));
        }
    }
    Ok(Finding::Holds)
}
