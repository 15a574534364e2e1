//! Answers about matrices and the cells of grids (Suffern, ch. 20 and 22).

use serde_json::Value;

use super::super::judgement::{Judgement, Profile};
use super::super::mistakes as m;
use super::super::values::{self, Rules};
use super::Mistakes;

/// Those of `transform`.
pub const TRANSFORM: Mistakes = Mistakes {
    questions: &[],
    answers: &[(&m::TRANSPOSED, |_, field, right| {
        let (name, row) = field.split_once('.')?;
        let row: usize = row.parse().ok()?;
        let entry = |column: usize| right[name][column][row].as_f64();
        let last = right[name][row][3].as_f64()?;
        Some(vec![entry(0)?, entry(1)?, entry(2)?, last])
    })],
};

/// Judges by our own answer. The last row of a matrix says nothing, and may be there.
pub fn transform(question: &Value, answer: &Value, profile: Profile, rules: &Rules) -> Judgement {
    let mut answer = answer.clone();
    for matrix in ["matrix", "inverse"] {
        if let Some(rows) = answer.get_mut(matrix).and_then(Value::as_array_mut)
            && let [_, _, _, last] = &rows[..]
            && ask::numbers(last).is_some_and(|row| row == [0.0, 0.0, 0.0, 1.0])
        {
            rows.pop();
        }
    }
    values::judge(question, &answer, profile, rules)
}

/// Judges by our own answer. The objects of the cells that are passed may be left out: of all of them.
pub fn grid(question: &Value, answer: &Value, profile: Profile, rules: &Rules) -> Judgement {
    let mut rules = rules.clone();
    let cells = answer["visited"].as_array().into_iter().flatten();
    if !cells.into_iter().any(|cell| cell.get("objects").is_some()) {
        rules.free.push("objects".to_owned());
    }
    values::judge(question, answer, profile, &rules)
}
