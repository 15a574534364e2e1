//! Laws of samples and their maps.

use ask::{Asking, numbers};
use std::cmp::Ordering;

use serde_json::{Value, json};

use super::super::judgement::{Judgement, Profile};
use super::super::mistakes::PIXELS_ALIKE;
use super::{LEVEL, LawOutcome, TESTS, missing, relative, within};
use statistics::chi_square::goodness_of_fit;
use statistics::correlation::pearson;
use statistics::significance::sidak;

/// Law: the map and its inverse lead back (Suffern, ch. 6, 7). The case is a `map` with `u`.
pub fn map_and_back(ask: &mut Asking<'_>, case: &Value, profile: Profile) -> LawOutcome {
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

/// The strata of the sampler that is asked for.
fn strata_asked(asked: &Value) -> Strata {
    let tag = asked["sampler"].as_object().and_then(|kind| kind.keys().next());
    strata_of(tag.map_or("", String::as_str))
}

/// Pixels whose first draws are looked at.
const PIXELS: u64 = 400;
/// Cells of the square along an axis.
const CELLS: usize = 4;
/// The fewest points of a set, and the fewest different ones among the first draws: the book has 83 sets, each with one
/// order of its points, so that its pixels begin with one of 83 points.
const FEWEST: u64 = 64;

/// Law: what a renderer draws is as good as its sets: the draws of one pixel use up a stratified set, the first draws
/// of all pixels are many points that fill the square evenly (χ²), and those of neighbouring pixels are not correlated
/// (Pearson). Points are not all at one place of their cells, and within those of jittered points x and y are not correlated.
/// So one sample set in every pixel shows, and so do a shuffle that favours some points, a jitter that is left out, and one
/// random number for both coordinates (Suffern, ch. 5). The case is a
/// `samples` with `n` and a `draw`, of a sampler with random numbers.
pub fn stream(ask: &mut Asking<'_>, case: &Value, _: Profile) -> LawOutcome {
    let asked = &case["samples"];
    let Some(n) = asked["n"].as_u64().filter(|n| *n >= FEWEST) else {
        return Ok(Judgement::Undecided);
    };
    let at = |x: u64, y: u64, index: u64| {
        let mut question = case.clone();
        question["samples"]["draw"] = json!({"pixel": [x, y], "index": index});
        question
    };
    let side = 20;
    let of_pixel: Vec<Value> = (0..n).map(|index| at(3, 5, index)).collect();
    let of_pixels: Vec<Value> = (0..PIXELS).map(|i| at(i % side, i / side, 0)).collect();
    // one answer tells whether hundreds are worth asking for
    if numbers(&ask.ask(&of_pixel[0])?).is_none_or(|point| point.len() != 2) {
        return missing("point");
    }
    let set = ask.ask_all(&of_pixel)?;
    let first = ask.ask_all(&of_pixels)?;
    // hundreds of answers are not shown
    ask.asked.truncate(3);
    let judgement = judge_sets(&json!([set]), asked, 1);
    if let Judgement::Wrong(_) = judgement {
        return Ok(judgement);
    }
    let Some(points) = first.iter().map(numbers).collect::<Option<Vec<Vec<f64>>>>() else {
        return missing("point");
    };
    if !points.iter().all(|point| point.len() == 2 && point.iter().all(|x| (0.0..1.0).contains(x)))
    {
        return Ok(Judgement::wrong(
            "outside",
            f64::INFINITY,
            "two numbers of at least 0 and below 1",
        ));
    }
    let level = sidak(LEVEL, 4 * TESTS);
    if let Some(text) = unevenness(&points, level) {
        let are_alike = points.iter().all(|point| *point == points[0]);
        let judged = Judgement::wrong("uneven", f64::INFINITY, text);
        return Ok(judged.with(are_alike.then_some(&PIXELS_ALIKE)));
    }
    for axis in [0, 1] {
        let along: Vec<f64> = points.iter().map(|point| point[axis]).collect();
        let beside = pearson(&along[..along.len() - 1], &along[1..]);
        let text = match beside {
            None => "draws that differ from pixel to pixel".to_owned(),
            Some(correlation) if correlation.p <= level => {
                format!(
                    "independent draws of neighbouring pixels: their correlation is {:.2}",
                    correlation.r
                )
            }
            Some(_) => continue,
        };
        return Ok(Judgement::wrong("pixels", f64::INFINITY, text));
    }
    // the place in one of n columns; larger cells are some of them. The bound is far above rounding in single precision, and 400
    // random places are never so near to each other
    let place = |point: &Vec<f64>| (point[0] * n as f64).fract();
    let is_first = |point: &Vec<f64>| {
        let away = (place(point) - place(&points[0])).abs();
        away.min(1.0 - away) < 1e-3
    };
    if points.iter().all(is_first) {
        let text = "points anywhere in their cells";
        return Ok(Judgement::wrong("cells", f64::INFINITY, text));
    }
    let side = (n as f64).sqrt();
    if strata_asked(asked) == Strata::Cells {
        let [x, y] = [0, 1].map(|axis| {
            points.iter().map(|point| (point[axis] * side).fract()).collect::<Vec<f64>>()
        });
        if let Some(correlation) = pearson(&x, &y).filter(|it| it.p <= level) {
            let r = correlation.r;
            let text = format!("x and y independent within a cell: their correlation is {r:.2}");
            return Ok(Judgement::wrong("cells", f64::INFINITY, text));
        }
    }
    Ok(Judgement::Right(0.0))
}

/// What is expected of the first draws of pixels, if they are few points or do not fill the square evenly. Pixels that
/// share a set may begin with the same point, which counts once: only different points are independent.
fn unevenness(points: &[Vec<f64>], level: f64) -> Option<String> {
    let mut different = points.to_vec();
    different.sort_by(|a, b| in_order(a, b));
    different.dedup();
    let n = different.len();
    if n < FEWEST as usize {
        return Some(format!(
            "at least {FEWEST} different first draws of {PIXELS} pixels, not {n}"
        ));
    }
    let mut counts = vec![0_u64; CELLS * CELLS];
    for point in &different {
        let [x, y] = [point[0], point[1]].map(|x| (x * CELLS as f64) as usize);
        counts[y * CELLS + x] += 1;
    }
    let expected = vec![n as f64 / counts.len() as f64; counts.len()];
    let p = goodness_of_fit(&counts, &expected);
    let text = format!("first draws of {PIXELS} pixels all over the square: χ² has p = {p:.1e}");
    (p <= level).then_some(text)
}

/// By the first number that differs: an order of all numbers, NaN too.
fn in_order(a: &[f64], b: &[f64]) -> Ordering {
    let first = a.iter().zip(b).map(|(a, b)| a.total_cmp(b)).find(|order| order.is_ne());
    first.unwrap_or(a.len().cmp(&b.len()))
}

/// Law: the points of each set are in the unit square, are as many as were asked for, and are stratified as the
/// sampler's name says (Suffern, ch. 5). The case is a `samples` with a square `n`.
pub fn stratified(ask: &mut Asking<'_>, case: &Value, _: Profile) -> LawOutcome {
    let answer = ask.ask(case)?;
    let asked = &case["samples"];
    Ok(judge_sets(&answer, asked, asked["sets"].as_u64().unwrap_or(1)))
}

/// Sets of points, as many as expected.
fn judge_sets(answer: &Value, asked: &Value, expected: u64) -> Judgement {
    let Some(n) = asked["n"].as_u64() else { return Judgement::Undecided };
    let strata = strata_asked(asked);
    let side = (n as f64).sqrt().round() as usize;
    let Some(sets) = answer.as_array() else {
        return Judgement::wrong("no list of sets", f64::INFINITY, "a list of sets of points");
    };
    if sets.len() as u64 != expected {
        let text = format!("{expected} sets");
        return Judgement::wrong("number of sets", f64::INFINITY, text);
    }
    for set in sets {
        let points = set.as_array().map(|points| points.iter().map(numbers).collect::<Vec<_>>());
        let points: Option<Vec<Vec<f64>>> = points.and_then(|points| points.into_iter().collect());
        let Some(points) = points.filter(|points| points.iter().all(|point| point.len() == 2))
        else {
            return Judgement::wrong("no list of points", f64::INFINITY, "points [x, y]");
        };
        if points.len() as u64 != n {
            let text = format!("{n} points in each set");
            return Judgement::wrong("number of points", f64::INFINITY, text);
        }
        if !points.iter().flatten().all(|x| (0.0..1.0).contains(x)) {
            return Judgement::wrong("outside", f64::INFINITY, "numbers of at least 0 and below 1");
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
            return Judgement::wrong("cells", f64::INFINITY, text);
        }
        for (axis, name) in [(0, "columns"), (1, "rows")] {
            if rooks && !each_once(points.iter().map(|point| row(point[axis])).collect()) {
                let text = format!("one point in each of {n} {name}");
                return Judgement::wrong(name, f64::INFINITY, text);
            }
        }
    }
    Judgement::Right(0.0)
}
