//! Laws of noise, whose tables are a program's own.

use ask::{Asking, number, triple};
use serde_json::{Value, json};

use super::super::judgement::{Judgement, Profile};
use super::{LEVEL, LawOutcome, TESTS, color, missing, within};
use statistics::chi_square::goodness_of_fit;
use statistics::significance::sidak;

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

/// The case at these points, which `moved` gives from its own.
fn at_points(case: &Value, count: u32, moved: fn(u32) -> [f64; 3]) -> Option<Vec<Value>> {
    let point = triple(&case["noise"]["point"])?;
    let at = |i: u32| {
        let mut other = case.clone();
        let by = moved(i);
        other["noise"]["point"] = json!(std::array::from_fn::<f64, 3, _>(|k| point[k] + by[k]));
        other
    };
    Some((0..count).map(at).collect())
}

/// Law: another seed gives other tables, and the same seed the same (Suffern, ch. 31). The case is a `noise` with a `seed`.
pub fn seeds_differ(ask: &mut Asking<'_>, case: &Value, _: Profile) -> LawOutcome {
    let moved = |i: u32| [0.71, 0.43, 0.59].map(|step| step * f64::from(i));
    let Some(first) = at_points(case, 8, moved) else { return Ok(Judgement::Undecided) };
    let mut questions = first.clone();
    for question in &first {
        let mut other = question.clone();
        let seed = other["noise"]["noise"]["seed"].as_u64().unwrap_or(0);
        other["noise"]["noise"]["seed"] = json!(seed + 1);
        questions.push(other);
    }
    questions.extend(first);
    let answers = ask.ask_all(&questions)?;
    // a point with both seeds is shown
    ask.asked.truncate(9);
    ask.asked.drain(1..8);
    let values = answers.iter().map(|answer| number(&answer["value"]));
    let Some(values) = values.collect::<Option<Vec<f64>>>() else { return missing("value") };
    let of_seed: Vec<&[f64]> = values.chunks(8).collect();
    Ok(if of_seed[0] != of_seed[2] {
        Judgement::wrong("another answer", f64::INFINITY, "the same noise for the same seed")
    } else if of_seed[0] == of_seed[1] {
        Judgement::wrong("seed", f64::INFINITY, "other noise for another seed")
    } else {
        Judgement::Right(0.0)
    })
}

/// Law: the vectors at the points of the lattice are unit, and in all directions alike (a χ² test; Suffern, ch. 31). The case
/// is a `noise` of one octave at a point of the lattice.
pub fn vectors_are_even(ask: &mut Asking<'_>, case: &Value, profile: Profile) -> LawOutcome {
    /// The fewest different vectors that are tested, and cells of directions.
    const FEWEST: usize = 100;
    const CELLS: usize = 16;
    let moved = |i: u32| [i % 8, i / 8 % 8, i / 64].map(f64::from);
    let Some(questions) = at_points(case, 512, moved) else { return Ok(Judgement::Undecided) };
    let answers = ask.ask_all(&questions)?;
    ask.asked.truncate(1);
    let vectors = answers.iter().map(|answer| triple(&answer["vector"]));
    // vectors are for bumps alone
    let Some(mut vectors) = vectors.collect::<Option<Vec<[f64; 3]>>>() else {
        let has_values = number(&answers[0]["value"]).is_some();
        return if has_values { Ok(Judgement::Undecided) } else { missing("value") };
    };
    let off = |v: &[f64; 3]| (v.iter().map(|x| x * x).sum::<f64>().sqrt() - 1.0).abs();
    let most = vectors.iter().map(off).fold(0.0, f64::max);
    let unit = within(profile, "vector is not unit", most, || "unit vectors".to_owned());
    if !unit.is_right() {
        return Ok(unit);
    }
    vectors.sort_by(|a, b| a.partial_cmp(b).unwrap_or(std::cmp::Ordering::Equal));
    vectors.dedup();
    let mut counts = vec![0_u64; CELLS];
    for [x, y, z] in &vectors {
        let height = ((0.5 + 0.5 * z) * 4.0).clamp(0.0, 3.0) as usize;
        counts[4 * height + 2 * usize::from(*x < 0.0) + usize::from(*y < 0.0)] += 1;
    }
    let expected = vec![vectors.len() as f64 / CELLS as f64; CELLS];
    let p = goodness_of_fit(&counts, &expected);
    Ok(match vectors.len() >= FEWEST && p > sidak(LEVEL, TESTS) {
        true => Judgement::Right(0.0),
        false => {
            let text = format!(
                "{FEWEST} different vectors or more, in all directions alike, not {}: χ² has p = {p:.1e}",
                vectors.len()
            );
            Judgement::wrong("vectors", f64::INFINITY, text)
        }
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
