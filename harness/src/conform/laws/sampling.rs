//! Laws of samples and their maps.

use serde_json::Value;

use super::super::family::Asking;
use super::super::judgement::{Judgement, Profile, numbers};
use super::{Found, relative, within};

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
    let expected = asked["sets"].as_u64().unwrap_or(1);
    if sets.len() as u64 != expected {
        let text = format!("{expected} sets");
        return Ok(Judgement::wrong("number of sets", f64::INFINITY, text));
    }
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
