//! Noise, its sums, and what textures and bumps make of it (Suffern, ch. 31). Random numbers are everybody's own: laws
//! hold a program's answers against each other; values are asked for tables that the question gives.

use serde_json::Value;

use super::super::judgement::{Judgement, Profile};
use super::super::mistakes as m;
use super::super::values::{self, Rules};
use super::swap;

/// Judges by our own answer.
pub fn still(question: &Value, answer: &Value, profile: Profile) -> Judgement {
    const RULES: Rules = Rules { needed: &[], free: &[], questions: &[], answers: &[] };
    values::judge(question, answer, profile, &RULES)
}

/// Judges by our own answer.
pub fn given(question: &Value, answer: &Value, profile: Profile) -> Judgement {
    // a lattice of permuted coordinates, interpolated, is the noise of permuted coordinates
    const RULES: Rules = Rules {
        needed: &["value"],
        free: &[],
        questions: &[
            (&m::OTHER_PERMUTATION, |question| {
                swap(&mut question["noise"], "/point/0", "/point/1")
            }),
            (&m::OTHER_PERMUTATION, |question| {
                swap(&mut question["noise"], "/point/0", "/point/2")
            }),
            (&m::OTHER_PERMUTATION, |question| {
                swap(&mut question["noise"], "/point/1", "/point/2")
            }),
        ],
        answers: &[],
    };
    values::judge(question, answer, profile, &RULES)
}
