//! Laws of lobes and of Fresnel's equations.

use ask::{Asking, Draw, number, triple};
use std::f64::consts::PI;

use serde::Deserialize;
use serde_json::{Value, json};

use super::super::judgement::{Judgement, Profile};
use super::super::mistakes as m;
use super::super::probe::ours;
use super::{LEVEL, LawOutcome, TESTS, color, missing, relative, within};
use groundtruth::lobes::Lobe;
use groundtruth::math::{UNIT_ROUNDOFF, Vector, atan2};
use statistics::chi_square::independence;
use statistics::significance::sidak;

/// Law: `f(ω_i, ω_o) = f(ω_o, ω_i)` (Suffern, ch. 13, Helmholtz). The case is a `lobe` with `wo` and `wi`.
pub fn reciprocity(ask: &mut Asking<'_>, case: &Value, profile: Profile) -> LawOutcome {
    let mut back = case.clone();
    back["lobe"]["wo"] = case["lobe"]["wi"].clone();
    back["lobe"]["wi"] = case["lobe"]["wo"].clone();
    let answers = ask.ask_all(&[case.clone(), back])?;
    let [there, back] = [&answers[0]["f"], &answers[1]["f"]];
    if color(there).is_none() || color(back).is_none() {
        return missing("f");
    }
    Ok(within(profile, "f differs", relative(back, there), || {
        format!("the same f with wo and wi exchanged: {there} and {back}")
    }))
}

/// Law: no more light leaves than arrives: the albedo is at most 1 (Suffern, ch. 13). The case is a `lobe`.
pub fn energy(ask: &mut Asking<'_>, case: &Value, profile: Profile) -> LawOutcome {
    let answer = ask.ask(case)?;
    let Some(albedo) = color(&answer["albedo"]) else { return missing("albedo") };
    let most = albedo.into_iter().fold(0.0, f64::max);
    Ok(within(profile, "albedo above 1", most - 1.0, || "an albedo of at most 1".to_owned()))
}

/// Law: a sample is a unit direction, its pdf is `pdf` there, and its weight `f |cos θ_i| / pdf`. The case is a
/// `lobe` with `u`.
pub fn sample_agrees(ask: &mut Asking<'_>, case: &Value, profile: Profile) -> LawOutcome {
    let answer = ask.ask(case)?;
    let Some(sample) = answer.get("sample") else { return missing("sample") };
    if sample.is_null() {
        return never_samples(ask, case);
    }
    let Some(wi) = triple(&sample["wi"]) else { return missing("sample.wi") };
    let length = Vector::from(wi).length();
    let unit = within(profile, "wi is not unit", (length - 1.0).abs(), || "a unit wi".to_owned());
    if let Judgement::Wrong(_) = unit {
        return Ok(unit);
    }
    let mut there = case.clone();
    there["lobe"]["wi"] = json!(wi);
    there["lobe"].as_object_mut().map(|fields| fields.remove("u"));
    let value = ask.ask(&there)?;
    let (Some(pdf), Some(drawn)) = (number(&value["pdf"]), number(&sample["pdf"])) else {
        return missing("pdf");
    };
    if !drawn.is_finite() {
        return Ok(Judgement::Undecided);
    }
    // a direction along the horizon: f and pdf turn to 0 within its rounding
    if wi[2] < 1e-6 || pdf == 0.0 {
        return Ok(Judgement::Undecided);
    }
    // a power of the cosine multiplies the rounding of a direction
    let slack = 1.0 + exponent(case);
    let off = (drawn - pdf).abs() / pdf / slack;
    let density =
        within(profile, "sample.pdf", off, || format!("sample.pdf = {pdf:?}, the pdf at wi"));
    if let Judgement::Wrong(_) = density {
        return Ok(density);
    }
    let Some(f) = color(&value["f"]) else { return missing("f") };
    let weight = f.map(|f| f * wi[2].abs() / pdf);
    let off = |weight: [f64; 3]| relative(&sample["weight"], &json!(weight)) / slack;
    let judgement = within(profile, "sample.weight", off(weight), || {
        format!("sample.weight = {weight:?}, f |cos θ| / pdf at wi")
    });
    let without_cos = off(f.map(|f| f / pdf)) <= profile.allowed() * UNIT_ROUNDOFF;
    Ok(judgement.with(without_cos.then_some(&m::WITHOUT_COS)))
}

/// A sample that is none: another map may lead below the horizon. But if ours are some, so are some of theirs.
fn never_samples(ask: &mut Asking<'_>, case: &Value) -> LawOutcome {
    const SIDE: usize = 4;
    let others = (0..SIDE * SIDE).map(|i| {
        let mut other = case.clone();
        let share = |at: usize| (at as f64 + 0.5) / SIDE as f64;
        other["lobe"]["u"] = json!([share(i % SIDE), share(i / SIDE)]);
        other
    });
    let others: Vec<Value> = others.collect();
    let is_none = |answer: &Value| answer["sample"].is_null();
    let ours_are_none = others.iter().filter_map(|it| ours(it).ok()).all(|it| is_none(&it));
    let theirs = ask.ask_all(&others)?;
    // sixteen answers are not shown
    ask.asked.truncate(3);
    match theirs.iter().all(is_none) && !ours_are_none {
        true => missing("sample"),
        false => Ok(Judgement::Undecided),
    }
}

fn exponent(case: &Value) -> f64 {
    let lobe = case["lobe"]["lobe"].as_object().and_then(|lobe| lobe.values().next());
    lobe.and_then(|lobe| lobe["exponent"].as_f64()).unwrap_or(0.0)
}

/// Directions drawn for one test.
const DRAWN: usize = 1500;
/// Directions of our own that they are compared with.
const OURS: usize = 8 * DRAWN;
/// Classes of directions: levels of the density, of equal shares, and sectors around the normal.
const LEVELS: usize = 6;
const SECTORS: usize = 4;

/// Law: the directions of `sample` have the density of the lobe. Oracle: χ² for independence against directions of our
/// own, which the contract of lobes holds against the integral of `pdf`; the classes are levels of our density times
/// sectors, so that a lobe that is too narrow shows however narrow it is. The case is a `lobe` with `wo` and `u`, from
/// which the draws are seeded.
pub fn density(ask: &mut Asking<'_>, case: &Value, _: Profile) -> LawOutcome {
    let asked = &case["lobe"];
    let lobe = Lobe::deserialize(&asked["lobe"]).ok();
    let (Some(lobe), Some(wo)) = (lobe, triple(&asked["wo"]).map(Vector::from)) else {
        return Ok(Judgement::Undecided);
    };
    let mut draw = Draw::new(asked["u"][0].as_f64().unwrap_or(0.0).to_bits());
    let mut pair = || [draw.between(0.0, 1.0), draw.between(0.0, 1.0)];
    let ours: Vec<Vector> = (0..OURS).filter_map(|_| Some(lobe.sample(wo, pair())?.wi)).collect();
    let questions: Vec<Value> = (0..DRAWN)
        .map(|_| {
            let mut question = case.clone();
            question["lobe"]["u"] = json!(pair());
            question
        })
        .collect();
    let answers = ask.ask_all(&questions)?;
    // 1500 answers are not shown
    ask.asked.truncate(3);
    let direction = |answer: &Value| triple(&answer["sample"]["wi"]).map(Vector::from);
    let theirs: Vec<Vector> = answers.iter().filter_map(direction).collect();
    let mut levels: Vec<f64> = ours.iter().map(|wi| lobe.pdf(wo, *wi)).collect();
    levels.sort_by(f64::total_cmp);
    let borders: Vec<f64> =
        (1..LEVELS).filter_map(|i| levels.get(i * levels.len() / LEVELS).copied()).collect();
    let class = |wi: &Vector| {
        let level = borders.partition_point(|border| *border <= lobe.pdf(wo, *wi));
        let turn = atan2(wi.y(), wi.x()) / (2.0 * PI) + 0.5;
        level * SECTORS + ((turn * SECTORS as f64) as usize).min(SECTORS - 1)
    };
    // a row for each class, and one for no direction
    let mut table = vec![0_u64; 2 * (LEVELS * SECTORS + 1)];
    for (column, directions, drawn) in [(0, &theirs, DRAWN), (1, &ours, OURS)] {
        directions.iter().for_each(|wi| table[2 * class(wi) + column] += 1);
        table[2 * LEVELS * SECTORS + column] += (drawn - directions.len()) as u64;
    }
    let p = independence(&table, 2);
    if p > sidak(LEVEL, TESTS) {
        return Ok(Judgement::Right(0.0));
    }
    let text = format!("directions of density `pdf`: χ² of {DRAWN} samples has p = {p:.1e}");
    Ok(Judgement::wrong("density", f64::INFINITY, text))
}

/// Law: what is reflected and what is transmitted add up to 1, in the mean and for each polarisation (Suffern,
/// ch. 27, 28). The case is a `fresnel`.
pub fn shares_add_up(ask: &mut Asking<'_>, case: &Value, profile: Profile) -> LawOutcome {
    let answer = ask.ask(case)?;
    if number(&answer["reflected"]).is_none() {
        return missing("reflected");
    }
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
