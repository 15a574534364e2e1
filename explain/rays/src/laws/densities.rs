use std::collections::HashMap;
use std::f64::consts::PI;
use std::sync::Arc;

use super::LawReport;
use super::geometry::{leaving, spread};
use crate::log::Purpose;
use crate::traced::Traced;
use groundtruth::math::{Frame, Normal, Vector, acos, atan2};
use statistics::ks;
use text::digits::short;

/// The level of all statistical findings of a log together.
const LEVEL: f64 = 1e-3;
/// The tests that a log is put to: the angle and the azimuth.
const TESTS: f64 = 2.0;
/// Fewer directions decide nothing.
const FEW: usize = 200;

/// What a density claims of the cosine to the normal: its distribution function.
#[derive(Clone, Copy, PartialEq)]
enum Claim {
    Cosine,
    Uniform,
}

pub fn check(traced: &Traced, asked: &mut LawReport) {
    let mut cosines = Vec::new();
    let mut azimuths = Vec::new();
    let mut claims: Vec<Claim> = Vec::new();
    let mut first = None;
    let implied_by_weights = implied_by_weights(traced);
    for it in leaving(traced).filter(|it| matches!(it.ray.kind, Some(Purpose::Diffuse))) {
        let Some(normal) = it.facing().and_then(Normal::new) else { continue };
        let cos = it.leaving.dot(normal);
        let factors = &it.ray.factors;
        // the density that the factors imply, if none is logged
        let implied = || {
            let product = factors.f?.max() * factors.cos?;
            Some(product / factors.weight?.max() / factors.choice.unwrap_or(1.0))
        };
        let claim = match factors.pdf.or_else(implied) {
            Some(pdf) => {
                let is = |density: f64| (pdf - density).abs() <= 1e-3 * density;
                either(is(cos / PI), is(0.5 / PI))
            }
            None => implied_by_weights.get(&it.parent.object.as_ref()).copied(),
        };
        let Some(claim) = claim else { continue };
        first.get_or_insert(it.index);
        claims.push(claim);
        cosines.push(cos);
        let local = Frame::around(normal).to_local(it.leaving);
        azimuths.push(turn(local));
    }
    let (Some(first), Some(&claim)) = (first.filter(|_| claims.len() >= FEW), claims.first())
    else {
        let few = format!("{} directions decide nothing; {FEW} are needed", claims.len());
        asked.notes.extend((!claims.is_empty()).then_some(few));
        return;
    };
    if claims.iter().any(|it| *it != claim) {
        return;
    }
    asked.rays = claims.len();
    asked.is_of_all = true;
    let level = LEVEL / TESTS;
    let p = |distribution: fn(f64) -> f64| {
        let shares = cosines.iter().map(|&cos| distribution(cos.clamp(0.0, 1.0)));
        ks::uniform(&shares.collect::<Vec<_>>())
    };
    let cosine: fn(f64) -> f64 = |cos| cos * cos;
    let uniform: fn(f64) -> f64 = |cos| cos;
    let angle: fn(f64) -> f64 = |cos| 1.0 - acos(cos) / (0.5 * PI);
    let square: fn(f64) -> f64 = |cos| cos * cos * cos;
    let claimed = if claim == Claim::Cosine { cosine } else { uniform };
    let [polar, round] = [p(claimed), ks::uniform(&azimuths)];
    if polar >= level && round >= level {
        return;
    }
    let is = |distribution| polar < level && p(distribution) >= level;
    let causes = [
        ("uniform-drawn", claim == Claim::Cosine && is(uniform)),
        ("cosine-drawn", claim == Claim::Uniform && is(cosine)),
        ("angle-drawn", is(angle)),
        ("square-drawn", is(square)),
        ("part-of-circle", round < level && polar >= level),
    ];
    let mean = cosines.iter().sum::<f64>() / cosines.len() as f64;
    let should = if claim == Claim::Cosine { 2.0 / 3.0 } else { 0.5 };
    let [mean, should, p] = [mean, should, polar.min(round)].map(short);
    let words = format!(
        "is one of {} whose cosines to the normal have the mean {mean}, where the density gives {should} (p {p})",
        cosines.len()
    );
    asked.find(first, words, causes);
}

fn either(is_cosine: bool, is_uniform: bool) -> Option<Claim> {
    let claim = if is_cosine { Claim::Cosine } else { Claim::Uniform };
    (is_cosine != is_uniform).then_some(claim)
}

/// What the weights of a matte object's rays claim: all are the same if the density follows the cosine, all are as the cosines if it
/// is uniform.
fn implied_by_weights(traced: &Traced) -> HashMap<Option<&Arc<str>>, Claim> {
    let mut objects: HashMap<_, Vec<[f64; 2]>> = HashMap::new();
    for it in leaving(traced).filter(|it| matches!(it.ray.kind, Some(Purpose::Diffuse))) {
        let weight = it.ray.factors.weight.map(|weight| weight.max()).filter(|it| *it > 0.0);
        if let (Some(weight), Some(facing)) = (weight, it.facing()) {
            let over_cosine = weight / facing.dot(it.leaving);
            objects.entry(it.parent.object.as_ref()).or_default().push([weight, over_cosine]);
        }
    }
    let claim = |weights: &Vec<[f64; 2]>| {
        let is_even = |at: usize| spread(weights.iter().map(|it| it[at])) <= 1e-3;
        either(is_even(0), is_even(1)).filter(|_| weights.len() >= FEW / 10)
    };
    objects.into_iter().filter_map(|(object, weights)| Some((object, claim(&weights)?))).collect()
}

/// The azimuth as a part of the circle.
fn turn(local: Vector) -> f64 {
    let part = atan2(local.y(), local.x()) / (2.0 * PI);
    if part < 0.0 { part + 1.0 } else { part }
}
