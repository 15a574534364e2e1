//! The verdict as data.

use serde_json::{Value, json};

use crate::laws::{BrokenRay, LawReport, RayLaw};
use crate::log::Damaged;
use crate::verdict::RayVerdict;

impl RayVerdict {
    /// All of it: each law with its outcome, each finding with its line.
    pub fn json(&self) -> Value {
        let line = |index: usize| self.traced.ray(index).line;
        let found = |finding: &BrokenRay| {
            let ray = self.traced.ray(finding.ray);
            json!({
                "line": ray.line, "pixel": ray.pixel, "sample": ray.sample,
                "ray": ray.id.as_ref().map(ToString::to_string),
                "found": finding.words, "follows": finding.follows.map(line),
            })
        };
        let law = |(law, asked): &(&RayLaw, LawReport)| {
            let findings: Vec<Value> = asked.findings.iter().map(found).collect();
            json!({
                "law": law.name, "says": law.says, "outcome": asked.outcome().name(), "rays": asked.rays,
                "cause": law.cause(asked.roots()), "findings": findings, "notes": asked.notes,
                "needs": law.needs,
            })
        };
        let damaged = |it: &Damaged| json!({"line": it.line, "problem": it.problem});
        let log = &self.traced.log;
        json!({
            "mistakes": self.mistakes.iter().map(|it| it[0]).collect::<Vec<_>>(),
            "sentence": self.sentence(), "rays": log.rays.len(),
            "laws": self.asked.iter().map(law).collect::<Vec<_>>(),
            "conventions": self.traced.conventions.sentences(),
            "damaged": log.damaged.iter().map(damaged).collect::<Vec<_>>(),
        })
    }
}
