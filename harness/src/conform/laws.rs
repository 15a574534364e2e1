//! Laws that need no oracle: functions over a subject that answers questions.
//!
//! The library's own kinds are held to the same laws by `cargo test`, with the subject [`Ours`](super::subject::Ours).

use std::f64::consts::PI;

use serde_json::{Value, json};

use super::family::{Asking, Stop};
use super::judgement::{Judgement, Profile, number, numbers, triple};
use crate::verify::Draw;
use crate::verify::chi_square::goodness_of_fit;
use crate::verify::significance::sidak;
use groundtruth::math::{UNIT_ROUNDOFF, Vector, acos, atan2};

/// What a law finds.
pub type Found = Result<Judgement, Stop>;

/// The probability that any statistical law of a run fails for a right program.
const LEVEL: f64 = 1e-3;
/// At least as many statistical tests as a run has.
const TESTS: usize = 1000;

/// Right, or wrong with this symptom if the relative error is more than the profile allows.
fn within(
    profile: Profile,
    symptom: &str,
    error: f64,
    expected: impl FnOnce() -> String,
) -> Judgement {
    let error = error / UNIT_ROUNDOFF;
    match error <= profile.allowed() {
        true => Judgement::Right(error),
        false => Judgement::wrong(symptom, error, expected()),
    }
}

/// The largest difference of two lists, relative to the largest number; infinite if one is no list of numbers.
fn relative(a: &Value, b: &Value) -> f64 {
    let list = |value: &Value| number(value).map(|x| vec![x]).or_else(|| numbers(value));
    let (Some(a), Some(b)) = (list(a), list(b)) else { return f64::INFINITY };
    if a.len() != b.len() {
        return f64::INFINITY;
    }
    let largest = b.iter().fold(f64::MIN_POSITIVE, |most, x| most.max(x.abs()));
    let off = a.iter().zip(&b).map(|(a, b)| if a == b { 0.0 } else { (a - b).abs() / largest });
    off.fold(0.0, |most: f64, x| if x.is_nan() { f64::INFINITY } else { most.max(x) })
}

/// Law: `f(ω_i, ω_o) = f(ω_o, ω_i)` (Suffern, ch. 13, Helmholtz). The case is a `lobe` with `wo` and `wi`.
pub fn reciprocity(ask: &mut Asking<'_>, case: &Value, profile: Profile) -> Found {
    let mut back = case.clone();
    back["lobe"]["wo"] = case["lobe"]["wi"].clone();
    back["lobe"]["wi"] = case["lobe"]["wo"].clone();
    let answers = ask.ask_all(&[case.clone(), back])?;
    let [there, back] = [&answers[0]["f"], &answers[1]["f"]];
    if there.is_null() {
        return Ok(Judgement::Undecided);
    }
    Ok(within(profile, "f differs", relative(back, there), || {
        format!("the same f with wo and wi exchanged: {there} and {back}")
    }))
}

/// Law: no more light leaves than arrives: the albedo is at most 1 (Suffern, ch. 13). The case is a `lobe`.
pub fn energy(ask: &mut Asking<'_>, case: &Value, profile: Profile) -> Found {
    let answer = ask.ask(case)?;
    let Some(albedo) = numbers(&answer["albedo"]) else { return Ok(Judgement::Undecided) };
    let most = albedo.into_iter().fold(0.0, f64::max);
    Ok(within(profile, "albedo above 1", most - 1.0, || "an albedo of at most 1".to_owned()))
}

/// Law: a sample is a unit direction, its pdf is `pdf` there, and its weight `f |cos θ_i| / pdf`. The case is a
/// `lobe` with `u`.
pub fn sample_agrees(ask: &mut Asking<'_>, case: &Value, profile: Profile) -> Found {
    let sample = ask.ask(case)?["sample"].take();
    if sample.is_null() {
        return Ok(Judgement::Right(0.0));
    }
    let Some(wi) = triple(&sample["wi"]) else {
        return Ok(Judgement::wrong("sample has no wi", f64::INFINITY, "a direction `wi`"));
    };
    let length = Vector::from(wi).length();
    if !((length - 1.0).abs() <= 8.0 * UNIT_ROUNDOFF.max(profile.allowed() * UNIT_ROUNDOFF)) {
        return Ok(Judgement::wrong(
            "wi is not unit",
            (length - 1.0).abs() / UNIT_ROUNDOFF,
            "a unit wi",
        ));
    }
    let mut there = case.clone();
    there["lobe"]["wi"] = json!(wi);
    there["lobe"].as_object_mut().map(|fields| fields.remove("u"));
    let value = ask.ask(&there)?;
    let (Some(pdf), Some(drawn)) = (number(&value["pdf"]), number(&sample["pdf"])) else {
        return Ok(Judgement::wrong("pdf is missing", f64::INFINITY, "`pdf`, and `sample.pdf`"));
    };
    if !drawn.is_finite() {
        return Ok(Judgement::Undecided);
    }
    // a direction along the horizon: f and pdf turn to 0 within its rounding
    if wi[2] < 1e-6 || pdf == 0.0 {
        return Ok(Judgement::Undecided);
    }
    let off = (drawn - pdf).abs() / pdf;
    // a power of the cosine multiplies the rounding of a direction
    let slack = 1.0 + exponent(case);
    if !(off <= slack * profile.allowed() * UNIT_ROUNDOFF) {
        let expected = format!("sample.pdf = {pdf:?}, the pdf at wi");
        return Ok(Judgement::wrong("sample.pdf", off / UNIT_ROUNDOFF, expected));
    }
    let Some(f) = numbers(&value["f"]) else { return Ok(Judgement::Undecided) };
    let weight: Vec<f64> = f.into_iter().map(|f| f * wi[2].abs() / pdf).collect();
    let off = relative(&sample["weight"], &json!(weight));
    if off <= slack * profile.allowed() * UNIT_ROUNDOFF {
        return Ok(Judgement::Right(off / UNIT_ROUNDOFF));
    }
    let expected = format!("sample.weight = {weight:?}, f |cos θ| / pdf at wi");
    Ok(Judgement::wrong("sample.weight", off / UNIT_ROUNDOFF, expected))
}

fn exponent(case: &Value) -> f64 {
    let lobe = case["lobe"]["lobe"].as_object().and_then(|lobe| lobe.values().next());
    lobe.and_then(|lobe| lobe["exponent"].as_f64()).unwrap_or(0.0)
}

/// Cells of the sphere for [`density`]: rows in θ, columns in φ.
const ROWS: usize = 9;
const COLUMNS: usize = 15;
/// Steps of the quadrature across a cell: the narrowest lobe is two or three steps wide.
const FINE: usize = 40;
/// Directions drawn for one test: a density wrong by 30 % on half of the sphere is found almost surely.
const DRAWN: usize = 1500;

/// Law: the directions of `sample` have the density `pdf`. Oracle: χ² against the midpoint rule on *our* pdf, on a
/// grid in θ and φ; cells without enough are put together. The case is a `lobe` with `wo` and `u`, from which the draws
/// are seeded.
pub fn density(ask: &mut Asking<'_>, case: &Value, _: Profile) -> Found {
    let mut draw = Draw::new(case["lobe"]["u"][0].as_f64().unwrap_or(0.0).to_bits());
    let drawn: Vec<Value> = (0..DRAWN)
        .map(|_| {
            let mut one = case.clone();
            one["lobe"]["u"] = json!([draw.between(0.0, 1.0), draw.between(0.0, 1.0)]);
            one
        })
        .collect();
    let answers = ask.ask_all(&drawn)?;
    // 1500 answers are not shown
    ask.asked.truncate(3);
    let mut observed = vec![0_u64; ROWS * COLUMNS];
    for answer in &answers {
        if let Some(wi) = triple(&answer["sample"]["wi"]) {
            observed[cell(wi)] += 1;
        }
    }
    let count = observed.iter().sum::<u64>() as f64;
    let mut expected = masses(case);
    let whole: f64 = expected.iter().sum();
    if whole < 0.05 || count < 0.05 * DRAWN as f64 {
        return Ok(Judgement::Undecided);
    }
    expected.iter_mut().for_each(|mass| *mass *= count / whole);
    let p = goodness_of_fit(&observed, &expected);
    if p > sidak(LEVEL, TESTS) {
        return Ok(Judgement::Right(0.0));
    }
    let text = format!("directions of density `pdf`: χ² of {DRAWN} samples has p = {p:.1e}");
    Ok(Judgement::wrong("density", f64::INFINITY, text))
}

fn cell(w: [f64; 3]) -> usize {
    let row = (acos(w[2].clamp(-1.0, 1.0)) / PI * ROWS as f64) as usize;
    let turn = atan2(w[1], w[0]) / (2.0 * PI) + 0.5;
    let column = (turn * COLUMNS as f64) as usize;
    row.min(ROWS - 1) * COLUMNS + column.min(COLUMNS - 1)
}

/// The integral of our density over each cell.
fn masses(question: &Value) -> Vec<f64> {
    use groundtruth::lobes::Lobe;
    use groundtruth::math::{cos, sin};
    use serde::Deserialize;
    let lobe = Lobe::deserialize(&question["lobe"]["lobe"]).ok();
    let (Some(lobe), Some(wo)) = (lobe, triple(&question["lobe"]["wo"])) else {
        return vec![0.0; ROWS * COLUMNS];
    };
    let (rows, columns) = (ROWS * FINE, COLUMNS * FINE);
    let (d_theta, d_phi) = (PI / rows as f64, 2.0 * PI / columns as f64);
    let mut masses = vec![0.0; ROWS * COLUMNS];
    let turns = (0..columns).map(|j| (j as f64 + 0.5) * d_phi - PI);
    let around: Vec<[f64; 2]> = turns.map(|phi| [cos(phi), sin(phi)]).collect();
    for i in 0..rows {
        let theta = (i as f64 + 0.5) * d_theta;
        let (sine, cosine) = (sin(theta), cos(theta));
        for (j, [x, y]) in around.iter().enumerate() {
            let wi = Vector::new(sine * x, sine * y, cosine);
            let mass = lobe.pdf(wo.into(), wi) * sine * d_theta * d_phi;
            masses[i / FINE * COLUMNS + j / FINE] += mass;
        }
    }
    masses
}

/// Law: what is reflected and what is transmitted add up to 1, in the mean and for each polarisation (Suffern,
/// ch. 27, 28). The case is a `fresnel`.
pub fn shares_add_up(ask: &mut Asking<'_>, case: &Value, profile: Profile) -> Found {
    let answer = ask.ask(case)?;
    for [r, t] in [["reflected", "transmitted"], ["r_s", "t_s"], ["r_p", "t_p"]] {
        let (Some(reflected), Some(transmitted)) = (number(&answer[r]), number(&answer[t])) else {
            continue;
        };
        let off = (reflected + transmitted - 1.0).abs();
        let judgement = within(profile, &format!("{r} + {t}"), off, || format!("{r} + {t} = 1"));
        if let Judgement::Wrong(_) = judgement {
            return Ok(judgement);
        }
    }
    Ok(Judgement::Right(0.0))
}

/// Law: t counts in the length of the direction: a direction k times as long gives t/k (Suffern, ch. 3). The case is
/// an `intersect`.
pub fn direction_length(ask: &mut Asking<'_>, case: &Value, profile: Profile) -> Found {
    const FACTOR: f64 = 4.0; // a power of two: no rounding of its own
    let Some(direction) = triple(&case["intersect"]["ray"]["direction"]) else {
        return Ok(Judgement::Undecided);
    };
    let mut longer = case.clone();
    longer["intersect"]["ray"]["direction"] = json!(direction.map(|x| FACTOR * x));
    let answers = ask.ask_all(&[case.clone(), longer])?;
    let (Some(t), Some(shorter)) = (number(&answers[0]["t"]), number(&answers[1]["t"])) else {
        return Ok(match answers[0].is_null() == answers[1].is_null() {
            true => Judgement::Right(0.0),
            false => Judgement::wrong("hit or miss", f64::INFINITY, "a hit for both directions"),
        });
    };
    let mut judgement = within(profile, "t", (FACTOR * shorter - t).abs() / t.abs(), || {
        format!("t = {:?} for the direction {FACTOR} times as long", t / FACTOR)
    });
    if let Judgement::Wrong(wrong) = &mut judgement
        && (shorter - t).abs() <= 1e-5 * t.abs()
    {
        wrong.clues.push(&super::mistakes::UNIT_ASSUMED);
    }
    Ok(judgement)
}

/// Law: along a line, a closed body is entered and left in turn (Suffern, ch. 3, 19). The case is an `intersect` with
/// `all`.
pub fn sides_alternate(ask: &mut Asking<'_>, case: &Value, _: Profile) -> Found {
    let answer = ask.ask(case)?;
    let Some(hits) = answer.as_array() else { return Ok(Judgement::Undecided) };
    let Some(direction) = triple(&case["intersect"]["ray"]["direction"]) else {
        return Ok(Judgement::Undecided);
    };
    let mut enters = Vec::new();
    for hit in hits {
        let Some(normal) = triple(&hit["normal"]) else { return Ok(Judgement::Undecided) };
        let cosine =
            Vector::from(normal).dot(Vector::from(direction)) / Vector::from(direction).length();
        if cosine.abs() < 1e-3 {
            return Ok(Judgement::Undecided); // nearly touches
        }
        enters.push(cosine < 0.0);
    }
    let in_turn = enters.windows(2).all(|pair| pair[0] != pair[1]);
    let is_whole = enters.len().is_multiple_of(2) && enters.first() != Some(&false);
    Ok(match in_turn && is_whole {
        true => Judgement::Right(0.0),
        false => {
            let text = "as many normals against the ray as along it, in turn";
            Judgement::wrong("sides", f64::INFINITY, text)
        }
    })
}

/// Law: a point on a camera's ray is seen where the ray starts (Suffern, ch. 9 to 11). The case is a `camera_ray`.
pub fn there_and_back(ask: &mut Asking<'_>, case: &Value, profile: Profile) -> Found {
    let ray = ask.ask(case)?;
    let (Some(origin), Some(direction)) = (triple(&ray["origin"]), triple(&ray["direction"]))
    else {
        return Ok(Judgement::Undecided);
    };
    let asked = &case["camera_ray"];
    let point: [f64; 3] = std::array::from_fn(|i| origin[i] + 5.0 * direction[i]);
    let question =
        json!({"project": {"camera": asked["camera"], "image": asked["image"], "point": point}});
    let seen = ask.ask(&question)?;
    let pixel = numbers(&asked["pixel"]).unwrap_or_default();
    let place = numbers(&asked["place"]).unwrap_or_else(|| vec![0.5, 0.5]);
    let [px, py, u, v] = [pixel[0], pixel[1], place[0], place[1]];
    let expected = [px + u, py + 1.0 - v];
    let at_edge = expected
        .iter()
        .zip([&asked["image"]["width"], &asked["image"]["height"]])
        .any(|(x, length)| *x < 1e-3 || *x > length.as_f64().unwrap_or(0.0) - 1e-3);
    if at_edge {
        return Ok(Judgement::Undecided);
    }
    // the film's coordinates are rounded relative to its size, and wide lenses stretch at their rim
    let off = relative(&seen["image"], &json!(expected)) / 64.0;
    Ok(within(profile, "image", off, || format!("image = {expected:?}, where the ray starts")))
}

/// Law: `M M⁻¹ = 1` (Suffern, ch. 20). The case is a `transform`.
pub fn inverse_is_inverse(ask: &mut Asking<'_>, case: &Value, profile: Profile) -> Found {
    let answer = ask.ask(case)?;
    let rows = |name: &str| {
        let rows: Option<Vec<Vec<f64>>> = answer[name].as_array()?.iter().map(numbers).collect();
        rows.filter(|rows| rows.len() >= 3 && rows.iter().all(|row| row.len() == 4))
    };
    let (Some(m), Some(inverse)) = (rows("matrix"), rows("inverse")) else {
        return Ok(Judgement::Undecided);
    };
    let mut off = 0.0_f64;
    for i in 0..3 {
        for j in 0..4 {
            let terms: Vec<f64> = (0..3).map(|k| m[i][k] * inverse[k][j]).collect();
            let moved = if j == 3 { m[i][3] } else { 0.0 };
            let identity = if i == j { 1.0 } else { 0.0 };
            let size: f64 = terms.iter().map(|x| x.abs()).sum::<f64>() + moved.abs() + 1.0;
            off = off.max((terms.iter().sum::<f64>() + moved - identity).abs() / size);
        }
    }
    Ok(within(profile, "M·M⁻¹", off, || "matrix · inverse = 1".to_owned()))
}

/// Law: the map and its inverse lead back (Suffern, ch. 6, 7). The case is a `map` with `u`.
pub fn map_and_back(ask: &mut Asking<'_>, case: &Value, profile: Profile) -> Found {
    let point = ask.ask(case)?;
    let mut back = case.clone();
    back["map"].as_object_mut().map(|fields| fields.remove("u"));
    back["map"]["point"] = point;
    let u = ask.ask(&back)?;
    // near the pole of a narrow lobe, a direction holds fewer digits of u
    let slack = 16.0 * (1.0 + case["map"]["to"]["hemisphere"]["exponent"].as_f64().unwrap_or(0.0));
    let off = relative(&u, &case["map"]["u"]) / slack;
    Ok(within(profile, "u", off, || format!("u = {}, where the map started", case["map"]["u"])))
}

/// Law: a function of its arguments: the same question has the same answer, in whatever order questions come. The
/// case is any question.
pub fn repeats(ask: &mut Asking<'_>, case: &Value, _: Profile) -> Found {
    let answers = ask.ask_all(&[case.clone(), case.clone()])?;
    Ok(match answers[0] == answers[1] {
        true => Judgement::Right(0.0),
        false => Judgement::wrong("another answer", f64::INFINITY, answers[0].to_string()),
    })
}

/// Law: lattice noise is continuous, and its sums stay in their ranges (Suffern, ch. 31): `value` in −1 … 1, the
/// sums in 0 … 1. The case is a `noise`.
pub fn noise_is_smooth(ask: &mut Asking<'_>, case: &Value, _: Profile) -> Found {
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

/// How a sample set is stratified.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Strata {
    /// Not at all.
    None,
    /// One point in each of √n × √n cells.
    Cells,
    /// One point in each of n rows, and of n columns.
    Rooks,
    /// Both.
    Both,
}

/// The strata of the sampler of this tag.
pub fn strata_of(tag: &str) -> Strata {
    match tag {
        "regular" | "jittered" => Strata::Cells,
        "n_rooks" => Strata::Rooks,
        "multi_jittered" | "correlated_multi_jittered" => Strata::Both,
        _ => Strata::None,
    }
}

/// Law: the points of each set are in the unit square, are as many as were asked for, and are stratified as the
/// sampler's name says (Suffern, ch. 5). The case is a `samples` with a square `n`.
pub fn stratified(ask: &mut Asking<'_>, case: &Value, _: Profile) -> Found {
    let answer = ask.ask(case)?;
    let asked = &case["samples"];
    let Some(n) = asked["n"].as_u64() else { return Ok(Judgement::Undecided) };
    let tag = asked["sampler"].as_object().and_then(|kind| kind.keys().next().cloned());
    let strata = strata_of(tag.as_deref().unwrap_or_default());
    let side = (n as f64).sqrt().round() as usize;
    let Some(sets) = answer.as_array() else {
        return Ok(Judgement::wrong("no list of sets", f64::INFINITY, "a list of sets of points"));
    };
    for set in sets {
        let points = set.as_array().map(|points| points.iter().map(numbers).collect::<Vec<_>>());
        let points: Option<Vec<Vec<f64>>> = points.and_then(|points| points.into_iter().collect());
        let Some(points) = points.filter(|points| points.iter().all(|point| point.len() == 2))
        else {
            return Ok(Judgement::wrong("no list of points", f64::INFINITY, "points [x, y]"));
        };
        if points.len() as u64 != n {
            let text = format!("{n} points in each set");
            return Ok(Judgement::wrong("number of points", f64::INFINITY, text));
        }
        if !points.iter().flatten().all(|x| (0.0..1.0).contains(x)) {
            return Ok(Judgement::wrong(
                "outside",
                f64::INFINITY,
                "numbers of at least 0 and below 1",
            ));
        }
        let n = n as usize;
        let row = |x: f64| (x * n as f64) as usize;
        let square = |point: &Vec<f64>| {
            (point[0] * side as f64) as usize * side + (point[1] * side as f64) as usize
        };
        let each_once = |indices: Vec<usize>| {
            let mut seen = vec![false; n];
            indices.into_iter().all(|i| i < n && !std::mem::replace(&mut seen[i], true))
        };
        let (cells, rooks) = match strata {
            Strata::None => (false, false),
            Strata::Cells => (true, false),
            Strata::Rooks => (false, true),
            Strata::Both => (true, true),
        };
        if cells && side * side == n && !each_once(points.iter().map(square).collect()) {
            let text = format!("one point in each of {side} × {side} cells");
            return Ok(Judgement::wrong("cells", f64::INFINITY, text));
        }
        for (axis, name) in [(0, "columns"), (1, "rows")] {
            if rooks && !each_once(points.iter().map(|point| row(point[axis])).collect()) {
                let text = format!("one point in each of {n} {name}");
                return Ok(Judgement::wrong(name, f64::INFINITY, text));
            }
        }
    }
    Ok(Judgement::Right(0.0))
}

/// Law: a sampled light is seen where the sample says: the direction is unit, the distance positive, and the pdf a
/// positive number, that of the solid angle of a small lamp within a factor. The case is a `light` with a `lamp`
/// that is a disk, a rectangle or a sphere, or an environment.
pub fn light_sample(ask: &mut Asking<'_>, case: &Value, profile: Profile) -> Found {
    let sample = ask.ask(case)?;
    if sample.is_null() {
        return Ok(Judgement::Right(0.0));
    }
    let Some(direction) = triple(&sample["direction"]) else {
        return Ok(Judgement::wrong("direction is missing", f64::INFINITY, "a `direction`"));
    };
    let off = (Vector::from(direction).length() - 1.0).abs();
    if let wrong @ Judgement::Wrong(_) =
        within(profile, "direction is not unit", off, || "a unit direction".to_owned())
    {
        return Ok(wrong);
    }
    let asked = &case["light"];
    let (Some(shape), Some(distance)) = (asked["lamp"].get("shape"), number(&sample["distance"]))
    else {
        return Ok(Judgement::Right(0.0));
    };
    let ray = json!({"origin": asked["from"], "direction": direction});
    let hit = super::subject::ours(&json!({"intersect": {"shape": shape, "ray": ray}}));
    let Ok(hit) = hit else { return Ok(Judgement::Undecided) };
    let Some(t) = number(&hit["t"]) else {
        // a point of the rim
        return Ok(Judgement::Undecided);
    };
    // the sample moves its end off the lamp by a few roundings of coordinates
    let off = (t - distance).abs() / (t + 10.0) / 4096.0;
    Ok(within(profile, "distance", off, || {
        format!("distance = {t:?}, to the lamp along the direction")
    }))
}
