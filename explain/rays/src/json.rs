//! The verdict as data.

use serde_json::{Value, json};

use crate::verdict::RayVerdict;

impl RayVerdict {
    /// All of it: each law with its outcome, each finding with its line.
    pub fn json(&self) -> Value {
        let laws: Vec<Value> = self
            .asked
            .iter()
            .map(|(law, asked)| {
                let findings: Vec<Value> = asked
                    .findings
                    .iter()
                    .map(|finding| {
                        let ray = self.traced.ray(finding.ray);
                        let line = |index: usize| self.traced.ray(index).line;
                        let id = ray.id.as_ref().map(ToString::to_string);
                        json!({
                            "line": ray.line, "pixel": ray.pixel, "sample": ray.sample, "ray": id,
                            "found": finding.words, "follows": finding.follows.map(line),
                        })
                    })
                    .collect();
                json!({
                    "law": law.name, "says": law.says, "outcome": asked.outcome().name(), "rays": asked.rays,
                    "cause": law.cause(asked.roots()), "findings": findings, "notes": asked.notes,
                    "needs": law.needs,
                })
            })
            .collect();
        let damaged: Vec<Value> = self
            .traced
            .log
            .damaged
            .iter()
            .map(|it| json!({"line": it.line, "problem": it.problem}))
            .collect();
        let mistakes: Vec<&str> = self.mistakes.iter().map(|it| it[0]).collect();
        json!({
            "mistakes": mistakes,
            "sentence": self.sentence(), "rays": self.traced.log.rays.len(), "laws": laws,
            "conventions": self.traced.conventions.sentences(), "damaged": damaged,
        })
    }
}
