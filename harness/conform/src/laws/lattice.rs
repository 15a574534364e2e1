//! What follows from a program's own lattice (Suffern, ch. 31): between its points, the values there. So nobody's random
//! numbers have to be ours.

use ask::{Asking, Stop, number, triple};
use serde_json::{Value, json};

use super::super::judgement::{Judgement, Profile};
use super::super::mistakes::{self as m, Mistake};
use super::{LawOutcome, missing, within};
use groundtruth::math::floor;

/// Rounding of some dozens of terms.
pub const TERMS: f64 = 32.0;

/// Numbers of an answer.
type Numbers = fn(&Value) -> Option<[f64; 3]>;

/// Law: the noise at a point is interpolated between its values at the corners of the cell: of 8 linearly, of 64 by
/// Catmull and Rom's splines. Where these overshoot −1 … 1, a program may limit them or not. The case is a `noise`.
pub fn interpolates(ask: &mut Asking<'_>, case: &Value, profile: Profile) -> LawOutcome {
    let Some(point) = triple(&case["noise"]["point"]) else { return Ok(Judgement::Undecided) };
    let is_linear = case["noise"]["noise"]["interpolation"] == "linear";
    let (first, weights): (f64, fn(f64) -> Vec<f64>) =
        if is_linear { (0.0, linear) } else { (-1.0, splines) };
    let cell = point.map(floor);
    let fractions: [f64; 3] = std::array::from_fn(|i| point[i] - cell[i]);
    let steps: Vec<f64> = (0..weights(0.0).len()).map(|i| first + i as f64).collect();
    let knots =
        products(&[&steps, &steps, &steps], |i, j, k| [cell[0] + i, cell[1] + j, cell[2] + k]);
    let at = |knot: [f64; 3]| {
        let mut question = case.clone();
        question["noise"]["point"] = json!(knot);
        question
    };
    let mut questions = vec![case.clone()];
    questions.extend(knots.into_iter().map(at));
    let answers = ask.ask_all(&questions)?;
    ask.asked.truncate(1);
    let weighted = |of: Numbers, fractions: [f64; 3]| -> Option<[f64; 3]> {
        let values = answers[1..].iter().map(of).collect::<Option<Vec<_>>>()?;
        Some(interpolated(&values, fractions, weights))
    };
    if answers[1..].iter().all(|answer| answer == &answers[1]) {
        let text = "other values at other points of the lattice";
        return Ok(Judgement::wrong("always the same", f64::INFINITY, text));
    }
    let value: Numbers = |answer| Some([number(&answer["value"])?, 0.0, 0.0]);
    let vector: Numbers = |answer| triple(&answer["vector"]);
    for (name, of) in [("value", value), ("vector", vector)] {
        let (Some(right), Some(theirs)) = (weighted(of, fractions), of(&answers[0])) else {
            // vectors are for bumps alone
            if name == "value" {
                return missing("value");
            }
            continue;
        };
        if right.iter().any(|x| x.abs() > 1.0) {
            continue;
        }
        let shown = if name == "value" { right[..1].to_vec() } else { right.to_vec() };
        let off = farthest(theirs, right);
        let judged = within(profile, name, off / TERMS, || {
            format!("{name} = {shown:?}, interpolated between {} of its own", answers.len() - 1)
        });
        if !judged.is_right() {
            let gives = |(_, other): &(&'static Mistake, [f64; 3])| {
                weighted(of, *other).is_some_and(|other| m::same(&theirs, &other))
            };
            let mut named: Vec<&Mistake> =
                other_fractions(fractions).into_iter().filter(gives).map(|(it, _)| it).collect();
            if is_truncated(ask, case, (first, weights), of, theirs)? {
                named.push(&m::CHECKER_TRUNCATED);
            }
            return Ok(judged.with(named));
        }
    }
    Ok(Judgement::Right(0.0))
}

/// The largest difference; NaN if there is one.
pub fn farthest(a: [f64; 3], b: [f64; 3]) -> f64 {
    (0..3)
        .map(|i| (a[i] - b[i]).abs())
        .fold(0.0, |most, x| if x > most || x.is_nan() { x } else { most })
}

/// Whether a value is that of cells that are numbered by truncation, with fractions of negative coordinates below 0 or
/// without their sign.
fn is_truncated(
    ask: &mut Asking<'_>,
    case: &Value,
    (first, weights): (f64, fn(f64) -> Vec<f64>),
    of: Numbers,
    theirs: [f64; 3],
) -> Result<bool, Stop> {
    let Some(point) = triple(&case["noise"]["point"]) else { return Ok(false) };
    let cell = point.map(f64::trunc);
    let count = weights(0.0).len();
    let steps: Vec<f64> = (0..count).map(|i| first + i as f64).collect();
    let questions = products(&[&steps, &steps, &steps], |i, j, k| {
        let mut question = case.clone();
        question["noise"]["point"] = json!([cell[0] + i, cell[1] + j, cell[2] + k]);
        question
    });
    let asked = ask.asked.len();
    let answers = ask.ask_all(&questions)?;
    ask.asked.truncate(asked);
    let Some(values) = answers.iter().map(of).collect::<Option<Vec<_>>>() else { return Ok(false) };
    let signed: [f64; 3] = std::array::from_fn(|i| point[i] - cell[i]);
    let ways = [signed, signed.map(f64::abs)];
    Ok(ways.into_iter().any(|way| m::same(&theirs, &interpolated(&values, way, weights))))
}

/// The mean of the values at the corners of a cell, with the weights of a place in it.
fn interpolated(
    values: &[[f64; 3]],
    fractions: [f64; 3],
    weights: fn(f64) -> Vec<f64>,
) -> [f64; 3] {
    let [x, y, z] = fractions.map(weights);
    let mut sum = [0.0; 3];
    for (weight, value) in products(&[&x, &y, &z], |a, b, c| a * b * c).iter().zip(values) {
        (0..3).for_each(|i| sum[i] += weight * value[i]);
    }
    sum
}

/// What is made of each item of a list with each of two others, the last one running fastest.
fn products<T>(lists: &[&[f64]; 3], of: impl Fn(f64, f64, f64) -> T) -> Vec<T> {
    let mut all = Vec::new();
    for i in lists[0] {
        for j in lists[1] {
            all.extend(lists[2].iter().map(|k| of(*i, *j, *k)));
        }
    }
    all
}

/// Mistakes that interpolate with other fractions.
fn other_fractions([x, y, z]: [f64; 3]) -> Vec<(&'static Mistake, [f64; 3])> {
    let exchanged = [[y, x, z], [z, y, x], [x, z, y]];
    let mut all: Vec<_> = exchanged.map(|other| (&m::OTHER_FRACTIONS, other)).into();
    all.push((&m::REVERSED_FRACTIONS, [x, y, z].map(|f| 1.0 - f)));
    all.push((&m::SMOOTHED_FRACTIONS, [x, y, z].map(|f| f * f * (3.0 - 2.0 * f))));
    all.push((&m::NOT_INTERPOLATED, [0.0; 3]));
    all
}

/// The weights of the two points of the lattice around a coordinate, from its fraction.
fn linear(f: f64) -> Vec<f64> {
    vec![1.0 - f, f]
}

/// The weights of the four points around it by Catmull and Rom.
fn splines(f: f64) -> Vec<f64> {
    let (f2, f3) = (f * f, f * f * f);
    vec![
        0.5 * (-f + 2.0 * f2 - f3),
        0.5 * (2.0 - 5.0 * f2 + 3.0 * f3),
        0.5 * (f + 4.0 * f2 - 3.0 * f3),
        0.5 * (f3 - f2),
    ]
}

/// Law: the values at the points of the lattice change along each axis, and differ if coordinates are exchanged. The case
/// is a `noise`.
pub fn knots_differ(ask: &mut Asking<'_>, case: &Value, _: Profile) -> LawOutcome {
    const STEPS: usize = 12;
    let Some(point) = triple(&case["noise"]["point"]) else { return Ok(Judgement::Undecided) };
    let from = point.map(floor);
    let at = |knot: [f64; 3]| {
        let mut question = case.clone();
        question["noise"]["point"] = json!(knot);
        question
    };
    let mut questions = Vec::new();
    for axis in 0..3 {
        questions.extend((0..STEPS).map(|i| {
            let mut knot = from;
            knot[axis] += i as f64;
            at(knot)
        }));
    }
    // the same three coordinates in the six orders
    let [a, b, c] = [from[0], from[0] + 3.0, from[0] + 7.0];
    let orders = [[a, b, c], [b, a, c], [a, c, b], [c, b, a], [b, c, a], [c, a, b]];
    questions.extend(orders.map(at));
    let answers = ask.ask_all(&questions)?;
    ask.asked.truncate(2);
    let values: Option<Vec<f64>> = answers.iter().map(|answer| number(&answer["value"])).collect();
    let Some(values) = values.filter(|all| all.iter().all(|x| x.is_finite())) else {
        return missing("value");
    };
    let is_one = |values: &[f64]| values.iter().all(|x| *x == values[0]);
    let wrong = |symptom: String, expected: &str| {
        Ok(Judgement::wrong(&symptom, f64::INFINITY, expected.to_owned()))
    };
    for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
        if is_one(&values[axis * STEPS..(axis + 1) * STEPS]) {
            return wrong(
                format!("constant along {name}"),
                "other values at other points of the lattice",
            );
        }
    }
    if is_one(&values[3 * STEPS..]) {
        return wrong(
            "the order of coordinates is nothing".to_owned(),
            "PERM(ix + PERM(iy + PERM(iz)))",
        );
    }
    Ok(Judgement::Right(0.0))
}
