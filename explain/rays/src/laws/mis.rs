use std::collections::{HashMap, HashSet};
use std::f64::consts::PI;
use std::sync::Arc;

use super::geometry::{Leaving, leaving};
use super::{LawReport, lamps};
use crate::conventions::Normals;
use crate::log::{Purpose, Ray};
use crate::traced::Traced;
use text::digits::short;

/// A MIS weight with the two densities that it is made of.
struct Weighed {
    index: usize,
    mis: f64,
    own: f64,
    other: f64,
    /// The choice of the lamp, within `other`.
    choice: f64,
    is_hit: bool,
}

/// A lamp that mirrors do not show is told by so many rays.
const SEEN: usize = 3;
/// Matte objects are told by so many rays.
const FEW: usize = 8;

fn balance(own: f64, other: f64) -> f64 {
    own / (own + other)
}

fn power(own: f64, other: f64) -> f64 {
    balance(own * own, other * other)
}

pub fn check(traced: &Traced, asked: &mut LawReport) {
    let tolerance = 64.0 * traced.tolerance() + 2e-4;
    let near = |a: f64, b: f64| (a - b).abs() <= tolerance;
    let all = weighed(traced);
    let fits = |heuristic: &dyn Fn(f64, f64) -> f64| {
        all.iter().filter(|it| near(it.mis, heuristic(it.own, it.other))).count()
    };
    let is_power = fits(&power) > fits(&balance);
    // lamps may be sampled alone: then their samples count in full, and what is hit by chance not at all
    let samples = || all.iter().filter(|it| !it.is_hit);
    let full = samples().filter(|it| near(it.mis, 1.0)).count();
    let is_alone = full > 0
        && 2 * full > samples().count()
        && 2 * fits(&power).max(fits(&balance)) < all.len();
    for it in &all {
        let [expected, unlike] = match (is_alone, is_power) {
            (true, _) => [if it.is_hit && it.other > 0.0 { 0.0 } else { 1.0 }; 2],
            (_, true) => [power(it.own, it.other), balance(it.own, it.other)],
            _ => [balance(it.own, it.other), power(it.own, it.other)],
        };
        asked.count(it.index, near(it.mis, expected), || {
            let without = it.other / it.choice;
            let unchosen = if is_power { power(it.own, without) } else { balance(it.own, without) };
            let causes = [
                ("hit-counts-in-full", it.is_hit && near(it.mis, 1.0) && !near(expected, 1.0)),
                ("mirror-shows-no-lamp", it.mis == 0.0 && it.other == 0.0 && !is_alone),
                ("hit-left-out", it.is_hit && near(it.mis, 0.0)),
                ("parts-exchanged", near(it.mis, 1.0 - expected) && !is_alone),
                ("one-way-weighted", it.other == 0.0),
                ("always-half", near(it.mis, 0.5)),
                ("choice-left-out", it.choice != 1.0 && near(it.mis, unchosen)),
                ("other-heuristic", near(it.mis, unlike)),
            ];
            let [mis, expected] = [it.mis, expected].map(short);
            let name = match (is_alone, is_power) {
                (true, _) => "samples of lamps count in full",
                (_, true) => "power heuristic",
                _ => "balance heuristic",
            };
            let has = match traced.ray(it.index).factors.mis {
                Some(_) => format!("has the MIS weight {mis}"),
                None if it.mis == 0.0 => "does not count at the lamp that it hits".to_owned(),
                None => "counts in full".to_owned(),
            };
            (format!("{has}, where its densities give {expected} ({name})"), causes)
        });
    }
}

/// All weights whose densities are known: as logged, or by the lamp and the surface. In a log without any, what is emitted at a
/// hit and brought back counts in full, as samples of lamps do.
fn weighed(traced: &Traced) -> Vec<Weighed> {
    let (matte, lamps) = (matte(traced), lamps::drawn(traced));
    let unweighed = traced.log.rays.iter().all(|ray| ray.factors.mis.is_none());
    let unmirrored = unmirrored(traced);
    let of = |it: Leaving<'_>| {
        let factors = &it.ray.factors;
        let counts = || {
            let [emitted, brought] = [it.ray.emitted, it.ray.radiance].map(|it| Some(it?.max()));
            let is_brought = brought? >= (1.0 - 1e-3) * emitted.unwrap_or(0.0);
            (unweighed && is_brought).then_some(1.0)
        };
        let (index, mis) = (it.index, factors.mis.or_else(counts).filter(|mis| mis.is_finite())?);
        let is_hit = !it.ray.is_shadow();
        let weighed = |own, other, choice| Weighed { index, mis, own, other, choice, is_hit };
        if is_mirrored(it.ray) && factors.pdf.is_none() {
            let is_left_out = lamp_side(traced, it.ray).is_some_and(|it| unmirrored.contains(&it));
            let mis = if is_left_out && it.ray.emitted.is_some() { 0.0 } else { mis };
            return Some(Weighed { mis, ..weighed(1.0, 0.0, 1.0) });
        }
        let own = factors.pdf.filter(|pdf| pdf.is_finite() && *pdf > 0.0)?;
        if let Some(other) = factors.other_pdf.filter(|pdf| pdf.is_finite()) {
            return Some(weighed(own, other, 1.0));
        }
        if !is_hit {
            let choice = factors.choice.unwrap_or(1.0);
            let is_matte = matte.get(&it.parent.object.as_ref()).is_some_and(|is_matte| *is_matte);
            let other = it.facing()?.dot(it.leaving).max(0.0) / PI;
            return is_matte.then_some(weighed(own * choice, other, 1.0));
        }
        let is_lit = it.ray.emitted.is_some_and(|light| light.max() > 0.0);
        let lamp = lamps.get(it.ray.object.as_ref()?).filter(|_| is_lit)?;
        let far = traced.end_point(index)?.distance(it.ray.origin);
        let other = lamp.choice * lamp.density(it.ray.origin, it.leaving, far);
        Some(weighed(own, other, lamp.choice))
    };
    leaving(traced).filter_map(of).collect()
}

fn is_mirrored(ray: &Ray) -> bool {
    matches!(ray.kind, Some(Purpose::Reflected | Purpose::Transmitted))
}

/// What a ray hits, and whether it hits the outside of it, if the log says so.
fn lamp_side<'a>(traced: &Traced, ray: &'a Ray) -> Option<(Option<&'a Arc<str>>, bool)> {
    let is_outward = traced.conventions.normals == Normals::Outward;
    let outside = || Some(ray.normal.filter(|_| is_outward)?.dot(ray.direction) < 0.0);
    Some((ray.object.as_ref(), ray.front.or_else(outside)?))
}

/// The sides of lamps that shine on all camera rays, and on none that mirrors alone send there.
fn unmirrored(traced: &Traced) -> HashSet<(Option<&Arc<str>>, bool)> {
    let mut sides: HashMap<_, [Vec<bool>; 2]> = HashMap::new();
    let is_sampled = |it: usize| traced.children[it].iter().any(|it| traced.ray(*it).is_shadow());
    for (index, ray) in traced.rays() {
        let mut before = traced.way_up(index).skip(1);
        let is_camera = ray.is(&Purpose::Camera);
        let is_seen = is_mirrored(ray)
            && before.all(|it| {
                (is_mirrored(traced.ray(it)) || traced.parents[it].is_none()) && !is_sampled(it)
            });
        let side = lamp_side(traced, ray).filter(|_| is_camera || is_seen);
        if let (Some(light), Some(side)) = (ray.emitted, side) {
            sides.entry(side).or_default()[usize::from(is_seen)].push(light.max() > 0.0);
        }
    }
    sides.retain(|_, seen| {
        let [camera, mirrored] = seen;
        let is_told = camera.len() >= SEEN && mirrored.len() >= SEEN;
        is_told && camera.iter().all(|it| *it) && !mirrored.contains(&true)
    });
    sides.into_keys().collect()
}

/// Whether all rays that an object scatters have the density cos/π.
fn matte(traced: &Traced) -> HashMap<Option<&Arc<str>>, bool> {
    let mut objects: HashMap<_, (usize, bool)> = HashMap::new();
    for it in leaving(traced).filter(|it| !it.ray.is_shadow()) {
        let cosine = it.facing().map(|facing| facing.dot(it.leaving) / PI);
        let is_near = |(pdf, cosine): (f64, f64)| (pdf - cosine).abs() <= 1e-3 * pdf;
        let is_cosine = it.ray.factors.pdf.zip(cosine).is_some_and(is_near);
        let (count, is_matte) = objects.entry(it.parent.object.as_ref()).or_insert((0, true));
        (*count, *is_matte) = (*count + 1, *is_matte && is_cosine);
    }
    objects.into_iter().map(|(name, (count, is_matte))| (name, is_matte && count >= FEW)).collect()
}
