//! Radiance in whole scenes: for what each chapter adds to a picture, a family of its own (Suffern, ch. 3 to 31), so
//! that what a program lacks hides nothing else.

mod estimate;
mod naming;

use serde_json::Value;

pub use estimate::mean_agrees;
pub use naming::NAMER;

use super::judgement::{Judgement, Profile};
use super::values::{self, Rules};

/// Judges by our own answer.
pub fn judge(question: &Value, answer: &Value, profile: Profile) -> Judgement {
    const RULES: Rules = Rules {
        needed: &["mean"],
        free: &["standard_error", "replicas", "samples"],
        questions: &[],
        answers: &[],
    };
    values::judge(question, answer, profile, &RULES)
}
