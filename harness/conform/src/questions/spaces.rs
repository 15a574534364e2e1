//! Matrices and the cells of grids (Suffern, ch. 20 and 22).

use serde_json::{Value, json};

use super::super::family::{Family, Judge};
use super::super::judgement::{Judgement, Profile};
use super::super::mistakes as m;
use super::super::values::{self, Rules};
use super::{change, data, direction, family, remove, round, vector};
use exact::Draw;

/// What the steps are, and a case of them.
type Steps = (&'static str, fn(&mut Draw) -> Value);

pub fn families() -> Vec<Family> {
    let steps: [Steps; 7] = [
        ("translate", |draw| json!([{"translate": vector(draw, 4.0)}])),
        ("scale", |draw| json!([scale(draw)])),
        ("rotate", |draw| json!([rotation(draw)])),
        ("rotate_about", |draw| {
            let (point, direction) = (vector(draw, 2.0), direction(draw));
            let degrees = round(draw.between(-180.0, 180.0));
            json!([{"rotate_about": {"point": point, "direction": direction, "degrees": degrees}}])
        }),
        ("reflect", |draw| json!([{"reflect": draw.pick(&["x", "y", "z"])}])),
        ("shear", |draw| {
            let six: Vec<f64> = (0..6).map(|_| round(draw.between(-0.4, 0.4))).collect();
            json!([{"shear": six}])
        }),
        ("composed", |draw| {
            let translate = json!({"translate": vector(draw, 4.0)});
            json!([scale(draw), rotation(draw), translate, rotation(draw)])
        }),
    ];
    let mut all: Vec<Family> = steps
        .into_iter()
        .map(|(name, steps)| {
            let case = move |draw: &mut Draw| json!({"transform": {"steps": steps(draw)}});
            let about = format!("transforms/{name}");
            family(
                &format!("transform.{name}.values"),
                &about,
                "ch20",
                Judge::Answer(transform),
                case,
            )
        })
        .collect();
    let cells = Judge::Answer(grid);
    all.push(family(
        "grid.boxes.resolution",
        "accel/grid",
        "ch22",
        cells,
        |draw| json!({"grid": {"boxes": boxes(draw), "multiplier": draw.pick(&[1.0, 2.0, 3.0])}}),
    ));
    all.push(family("grid.boxes.visited", "accel/grid", "ch22", cells, |draw| {
        let (origin, direction) = (vector(draw, 9.0), direction(draw));
        let ray = json!({"origin": origin, "direction": direction});
        json!({"grid": {"boxes": boxes(draw), "ray": ray}})
    }));
    all
}

fn scale(draw: &mut Draw) -> Value {
    let factors: Vec<f64> = (0..3).map(|_| round(draw.between(0.25, 3.0))).collect();
    json!({"scale": factors})
}

fn rotation(draw: &mut Draw) -> Value {
    json!({draw.pick(&["rotate_x", "rotate_y", "rotate_z"]): round(draw.between(-180.0, 180.0))})
}

/// Boxes that together are about as high as wide. To other sets our grids give other cells than the book's formula does
/// (docs/probe.md), which is no mistake of the program that is asked.
fn boxes(draw: &mut Draw) -> Value {
    let one = |draw: &mut Draw| {
        let min = draw.vector(4.0).to_array().map(round);
        (min, min.map(|x| round(x + draw.between(0.25, 2.0))))
    };
    let count = 4 + draw.below(9);
    loop {
        let all: Vec<_> = (0..count).map(|_| one(draw)).collect();
        if is_compact(&all) {
            let boxes = all.iter().map(|(min, max)| json!({"min": min, "max": max}));
            return boxes.collect::<Vec<_>>().into();
        }
    }
}

/// Whether the middle side of all boxes together is at least the longest over their number n, and the shortest at least
/// √(longest · middle / n).
fn is_compact(boxes: &[([f64; 3], [f64; 3])]) -> bool {
    let n = boxes.len() as f64;
    let mut sides: [f64; 3] = std::array::from_fn(|i| {
        let low = boxes.iter().map(|(min, _)| min[i]).fold(f64::INFINITY, f64::min);
        let high = boxes.iter().map(|(_, max)| max[i]).fold(f64::NEG_INFINITY, f64::max);
        high - low
    });
    sides.sort_by(f64::total_cmp);
    let [short, middle, long] = sides;
    middle * n >= long && short * short * n >= long * middle
}

fn transform(question: &Value, answer: &Value, profile: Profile) -> Judgement {
    const RULES: Rules = Rules {
        needed: &["matrix"],
        free: &["condition"],
        questions: &[
            (&m::REVERSED_STEPS, |question| {
                data(question)?["steps"].as_array_mut()?.reverse();
                Some(())
            }),
            (&m::TURNED_BACKWARDS, |question| {
                for step in data(question)?["steps"].as_array_mut()? {
                    for rotation in ["/rotate_x", "/rotate_y", "/rotate_z", "/rotate_about/degrees"]
                    {
                        change(step, rotation, |degrees| -degrees);
                    }
                }
                Some(())
            }),
        ],
        answers: &[
            (&m::INVERSE_FOR_MATRIX, |_, field, right| {
                let row = field.strip_prefix("matrix.")?;
                super::super::judgement::numbers(&right["inverse"][row.parse::<usize>().ok()?])
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
    // the last row of a matrix says nothing, and may be there
    let mut answer = answer.clone();
    for matrix in ["matrix", "inverse"] {
        if let Some(rows) = answer.get_mut(matrix).and_then(Value::as_array_mut)
            && let [_, _, _, last] = &rows[..]
            && super::super::judgement::numbers(last).is_some_and(|row| row == [0.0, 0.0, 0.0, 1.0])
        {
            rows.pop();
        }
    }
    values::judge(question, &answer, profile, &RULES)
}

fn grid(question: &Value, answer: &Value, profile: Profile) -> Judgement {
    const RULES: Rules = Rules {
        needed: &["resolution", "visited"],
        free: &[],
        questions: &[(&m::NO_MULTIPLIER, |question| {
            let data = data(question)?;
            remove(data, "multiplier")?;
            data["multiplier"] = json!(1.0);
            Some(())
        })],
        answers: &[(&m::ONE_CELL_LESS, |_, field, right| {
            let less = super::super::judgement::numbers(&right["resolution"])?;
            (field == "resolution").then(|| less.into_iter().map(|n| n - 1.0).collect())
        })],
    };
    // the objects of the cells that are passed may be left out: of all of them
    const CELLS: Rules = Rules { free: &["objects"], ..RULES };
    let cells = answer["visited"].as_array().into_iter().flatten();
    let has_objects = cells.into_iter().any(|cell| cell.get("objects").is_some());
    values::judge(question, answer, profile, if has_objects { &RULES } else { &CELLS })
}
