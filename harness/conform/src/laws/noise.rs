//! Laws of noise, whose tables are a program's own.

use ask::{Asking, number, triple};
use serde_json::{Value, json};

use super::super::judgement::{Judgement, Profile};
use super::{LawOutcome, color, missing};

/// Law: a function of the point: the same question has the same answer, in whatever order questions come, and other
/// points have others. The case is a question with a `point`: `noise` or `texture`.
pub fn repeats(ask: &mut Asking<'_>, case: &Value, _: Profile) -> LawOutcome {
    const ELSEWHERE: usize = 30;
    let Some((name, Some(point))) = case
        .as_object()
        .and_then(|it| it.iter().next())
        .map(|(name, data)| (name.clone(), triple(&data["point"])))
    else {
        return Ok(Judgement::Undecided);
    };
    let elsewhere = (1..=ELSEWHERE).map(|i| {
        let mut other = case.clone();
        // steps that no lattice has
        let moved = [0.71, 0.43, 0.59].map(|step| step * i as f64);
        other[&name]["point"] =
            json!(std::array::from_fn::<f64, 3, _>(|axis| point[axis] + moved[axis]));
        other
    });
    let questions: Vec<Value> =
        [case.clone()].into_iter().chain(elsewhere).chain([case.clone()]).collect();
    let answers = ask.ask_all(&questions)?;
    // the others are not shown
    ask.asked.drain(1..=ELSEWHERE);
    let (first, last) = (&answers[0], &answers[ELSEWHERE + 1]);
    if name == "texture" && color(first).is_none() {
        return missing("colour");
    }
    let text = |expected: &str| format!("{expected}: {first}");
    Ok(if first != last {
        Judgement::wrong("another answer", f64::INFINITY, text("the same answer again"))
    } else if answers.iter().all(|answer| answer == first) {
        Judgement::wrong("always the same", f64::INFINITY, text("other answers at other points"))
    } else {
        Judgement::Right(0.0)
    })
}

/// Law: lattice noise is continuous, and its sums stay in their ranges (Suffern, ch. 31): `value` in −1 … 1, the
/// sums in 0 … 1. The case is a `noise`.
pub fn noise_is_smooth(ask: &mut Asking<'_>, case: &Value, _: Profile) -> LawOutcome {
    const STEP: f64 = 1e-6;
    /// Slopes of cubic noise stay below 4 per cell, and octaves add up.
    const SLOPE: f64 = 100.0;
    let mut beside = case.clone();
    let Some(point) = triple(&case["noise"]["point"]) else { return Ok(Judgement::Undecided) };
    beside["noise"]["point"] = json!([point[0] + STEP, point[1], point[2]]);
    let answers = ask.ask_all(&[case.clone(), beside])?;
    let [here, there] = ["value", "fractal_sum", "turbulence", "fbm"].iter().fold(
        [Vec::new(), Vec::new()],
        |[mut a, mut b], name| {
            a.push((*name, number(&answers[0][name])));
            b.push((*name, number(&answers[1][name])));
            [a, b]
        },
    );
    if here.iter().all(|(_, number)| number.is_none()) {
        return missing("value");
    }
    for ((name, a), (_, b)) in here.into_iter().zip(there) {
        let (Some(a), Some(b)) = (a, b) else { continue };
        let low = if name == "value" { -1.0 } else { 0.0 };
        // Catmull and Rom's splines overshoot a little
        if !(low - 0.5..=1.5).contains(&a) {
            return Ok(Judgement::wrong(name, f64::INFINITY, format!("{name} from {low} to 1")));
        }
        if (a - b).abs() > SLOPE * STEP {
            let text = format!("{name} = {a:?} and almost the same {STEP:e} beside it, not {b:?}");
            return Ok(Judgement::wrong("jump", f64::INFINITY, text));
        }
    }
    Ok(Judgement::Right(0.0))
}
