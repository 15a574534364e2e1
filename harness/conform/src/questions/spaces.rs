//! Answers about matrices and the cells of grids (Suffern, ch. 20 and 22).

use serde_json::{Value, json};

use super::super::judgement::{Judgement, Profile};
use super::super::mistakes as m;
use super::super::values::{self, Rules};
use super::{Mistakes, change, data, remove};

/// Those of `transform`.
pub const TRANSFORM: Mistakes = Mistakes {
    questions: &[
        (&m::STEPS_REVERSED, |question| {
            data(question)?["steps"].as_array_mut()?.reverse();
            Some(())
        }),
        (&m::ROTATIONS_REVERSED, |question| {
            for step in data(question)?["steps"].as_array_mut()? {
                for rotation in ["/rotate_x", "/rotate_y", "/rotate_z", "/rotate_about/degrees"] {
                    change(step, rotation, |degrees| -degrees);
                }
            }
            Some(())
        }),
    ],
    answers: &[
        (&m::INVERSE_FOR_MATRIX, |_, field, right| {
            let row = field.strip_prefix("matrix.")?;
            ask::numbers(&right["inverse"][row.parse::<usize>().ok()?])
        }),
        (&m::TRANSPOSED, |_, field, right| {
            let (name, row) = field.split_once('.')?;
            let row: usize = row.parse().ok()?;
            let entry = |column: usize| right[name][column][row].as_f64();
            let last = right[name][row][3].as_f64()?;
            Some(vec![entry(0)?, entry(1)?, entry(2)?, last])
        }),
    ],
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

/// Those of `grid`.
pub const GRID: Mistakes = Mistakes {
    questions: &[(&m::NO_MULTIPLIER, |question| {
        let data = data(question)?;
        remove(data, "multiplier")?;
        data["multiplier"] = json!(1.0);
        Some(())
    })],
    answers: &[(&m::ONE_CELL_LESS, |_, field, right| {
        let less = ask::numbers(&right["resolution"])?;
        (field == "resolution").then(|| less.into_iter().map(|n| n - 1.0).collect())
    })],
};

/// Judges by our own answer. The objects of the cells that are passed may be left out: of all of them.
pub fn grid(question: &Value, answer: &Value, profile: Profile, rules: &Rules) -> Judgement {
    let mut rules = rules.clone();
    let cells = answer["visited"].as_array().into_iter().flatten();
    if !cells.into_iter().any(|cell| cell.get("objects").is_some()) {
        rules.free.push("objects".to_owned());
    }
    values::judge(question, answer, profile, &rules)
}
