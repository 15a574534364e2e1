//! Every ray that a program casts for a ray, held to the laws of rays and to ours.

use std::sync::Arc;

use rays::{RayVerdict, Traced};
use serde_json::{Value, json};

use super::judgement::{Judgement, Profile};
use super::probe::traced_world;
use super::values::{self, Rules};

/// What arrives is judged; where it is wrong, the rays tell why, if the program logs them.
pub fn judge_rays(question: &Value, answer: &Value, profile: Profile, rules: &Rules) -> Judgement {
    let mut judgement = values::judge(question, answer, profile, rules);
    if let Judgement::Wrong(wrong) = &mut judgement
        && let Some(theirs) = answer["rays"].as_array()
        && let Some(told) = told_by(theirs, question)
    {
        wrong.expected += &format!("; {told}");
    }
    judgement
}

/// What the rays of an answer tell: the first that breaks a law, or is other than ours. Their order may be another, so that
/// `parent` says nothing; and shadow rays do not say whether they are blocked.
fn told_by(theirs: &[Value], question: &Value) -> Option<String> {
    let mut text = json!({"rays": 1, "scene": "of the question"}).to_string();
    for (index, ray) in theirs.iter().enumerate().filter(|(_, ray)| ray["kind"] != "shadow") {
        let mut ray = ray.as_object()?.clone();
        ray.remove("parent");
        ray.insert("ray".to_owned(), index.into());
        text += &format!("\n{}", Value::Object(ray));
    }
    let log = rays::read(text.as_bytes()).ok()?;
    let verdict = RayVerdict::of(Traced::of(log, Some(Arc::new(traced_world(question)?))));
    let agree = || "the rays agree with ours as far as they say; the shading differs".to_owned();
    Some(if verdict.is_broken() { verdict.sentence() } else { agree() })
}
