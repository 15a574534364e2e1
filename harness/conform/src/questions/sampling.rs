//! Answers about sample sets without random numbers, and maps of samples (Suffern, ch. 5 to 7).

use ask::number;
use serde_json::Value;

use super::super::judgement::{Judgement, Profile};
use super::super::mistakes as m;
use super::super::probe::ours;
use super::super::values::Rules;
use super::{Mistakes, change, data};
use groundtruth::math::UNIT_ROUNDOFF;

/// Sets are compared as sets: the order of points is a program's own.
pub fn samples(question: &Value, answer: &Value, profile: Profile, _: &Rules) -> Judgement {
    let Ok(right) = ours(question) else { return Judgement::Undecided };
    let Some(right) = sorted(&right) else { return Judgement::Undecided };
    let wrong =
        |symptom: &str, expected: String| Judgement::wrong(symptom, f64::INFINITY, expected);
    let Some(theirs) = sorted(answer) else {
        return wrong("no list of one set", "[[[x, y], …]], one set of points".to_owned());
    };
    if theirs.len() != right.len() {
        return wrong("number of points", format!("{} points", right.len()));
    }
    if theirs.iter().flatten().any(|x| x.is_nan()) {
        return wrong("a point is not a number", format!("{right:?}"));
    }
    let error = farthest(&theirs, &right) / UNIT_ROUNDOFF;
    if error <= profile.allowed() {
        return Judgement::Right(error);
    }
    let swapped = sorted_points(right.iter().map(|&[x, y]| [y, x]).collect());
    let is_swapped = farthest(&theirs, &swapped) <= 1e-6;
    let judgement = Judgement::wrong("points", error, format!("{right:?}"));
    judgement.with(is_swapped.then_some(&m::SWAP_U))
}

/// The largest difference of a coordinate; infinite if one is no number.
fn farthest(a: &[[f64; 2]], b: &[[f64; 2]]) -> f64 {
    let off = |(a, b): (&[f64; 2], &[f64; 2])| [0, 1].map(|axis| (a[axis] - b[axis]).abs());
    let all = a.iter().zip(b).flat_map(off);
    all.fold(0.0, |most: f64, x| if x.is_nan() { f64::INFINITY } else { most.max(x) })
}

/// The points of the only set, by x and y; a `null` among the numbers is how JavaScript writes NaN. `None` for anything
/// else.
fn sorted(answer: &Value) -> Option<Vec<[f64; 2]>> {
    let [set] = &answer.as_array()?[..] else { return None };
    let coordinate = |x: &Value| if x.is_null() { Some(f64::NAN) } else { number(x) };
    let point = |point: &Value| {
        let numbers: Option<Vec<f64>> = point.as_array()?.iter().map(coordinate).collect();
        numbers?.try_into().ok()
    };
    let points: Option<Vec<[f64; 2]>> = set.as_array()?.iter().map(point).collect();
    points.map(sorted_points)
}

fn sorted_points(mut points: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
    // single precision must not change the order
    let key = |point: &[f64; 2]| point.map(|x| (x * 1e5).round() + 0.0); // no −0
    points.sort_by(|a, b| {
        let ([ax, ay], [bx, by]) = (key(a), key(b));
        // an order of all numbers, NaN too
        ax.total_cmp(&bx).then(ay.total_cmp(&by))
    });
    points
}

/// Those of `map`.
pub const MAP: Mistakes = Mistakes {
    questions: &[(&m::ANGLES_EVEN, |question| {
        let data = data(question)?;
        data["to"].get("sphere")?;
        change(data, "/u/0", |u| 0.5 - 0.5 * groundtruth::math::cos(std::f64::consts::PI * u))
    })],
    answers: &[
        (&m::POLAR_DISK, |question, _, _| {
            question["map"]["to"].get("disk")?;
            let [u, v] = [0, 1].map(|i| question["map"]["u"][i].as_f64());
            let (sin, cos) = groundtruth::math::sin_cos(2.0 * std::f64::consts::PI * v?);
            Some(vec![u? * cos, u? * sin])
        }),
        (&m::PLAIN_DISK, |question, _, _| {
            question["map"]["to"].get("disk")?;
            let [u, v] = [0, 1].map(|i| question["map"]["u"][i].as_f64());
            let (r, phi) = (u?.sqrt(), 2.0 * std::f64::consts::PI * v?);
            Some(vec![r * groundtruth::math::cos(phi), r * groundtruth::math::sin(phi)])
        }),
    ],
};
