//! Radiance in whole scenes: for what each chapter adds to a picture, a family of its own (Suffern, ch. 3 to 31), so
//! that what a program lacks hides nothing else.

mod changes;
mod estimate;
mod images;
mod lamps;
mod naming;
mod paths;
mod pixels;
mod stage;
mod surfaces;
mod textures;

use serde_json::Value;

pub use estimate::mean_agrees;
pub use naming::NAMER;

use super::family::{Family, Judge};
use super::judgement::{Judgement, Profile};
use super::questions;
use super::values::{self, Rules};
use stage::Exact;

/// All families: those without random numbers, and those that are judged by their mean.
pub fn families() -> Vec<Family> {
    let exact = [surfaces::ALL, textures::ALL, images::ALL, pixels::ALL];
    let exact = exact.into_iter().flatten();
    let exact = exact.map(|one| family(one, "values", 0.25, Judge::Answer(judge)));
    let means = [lamps::ALL, images::MEANS, paths::ALL].into_iter().flatten();
    let means = means.map(|one| Family {
        // making one smaller would take thousands of samples for each step; their scenes are small
        is_shrunk: false,
        ..family(one, "mean", 0.125, Judge::Law(estimate::mean_agrees))
    });
    exact.chain(means).collect()
}

fn family((name, chapter, case): &Exact, kind: &str, share: f64, judge: Judge) -> Family {
    let about = format!("scenes/{}", name.split('.').next().unwrap_or(name));
    let named = format!("radiance.{name}.{kind}");
    Family { share, namer: Some(NAMER), ..questions::family(&named, &about, chapter, judge, *case) }
}

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
