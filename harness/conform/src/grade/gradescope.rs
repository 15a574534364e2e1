//! `results.json` as Gradescope reads it from an autograder.
//!
//! Source: Gradescope, "Autograder Specifications", section "Output format".

use serde_json::{Value, json};

use super::points::{Grade, PartGrade};

/// The results: a test for each part. What the autograder prints stays hidden from students.
pub fn results(grade: &Grade) -> Value {
    let is_answered = grade.card.is_ok();
    let test = |part: &PartGrade| {
        let is_full = part.points == part.most;
        let output = match (is_answered, is_full) {
            (false, _) => "Your program answered no question.\n".to_owned(),
            (true, true) => "Everything is right.\n".to_owned(),
            (true, false) => part.hints(),
        };
        json!({
            "name": part.name, "score": part.points, "max_score": part.most,
            "status": if is_full { "passed" } else { "failed" },
            "output": output, "output_format": "text", "visibility": "visible",
        })
    };
    json!({
        "score": grade.points(),
        "output": grade.summary(), "output_format": "text",
        "visibility": "visible", "stdout_visibility": "hidden",
        "tests": grade.parts.iter().map(test).collect::<Vec<_>>(),
    })
}
