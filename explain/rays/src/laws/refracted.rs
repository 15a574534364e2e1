use std::collections::{HashMap, HashSet};
use std::sync::Arc;

use super::LawReport;
use super::geometry::{Leaving, angle_between, is_near, leaving, refracted};
use crate::log::Purpose;
use crate::traced::{Traced, median};
use groundtruth::math::{Vector, atan2, to_degrees};
use text::digits::short;

/// Sines below this say nothing of the ratio of indices.
const STEEP: f64 = 1e-2;

/// The index of each object over the one around it.
pub type Ratios = HashMap<Option<Arc<str>>, f64>;

pub fn check(traced: &Traced, asked: &mut LawReport) {
    let usual = usual_ratios(traced);
    for it in leaving(traced).filter(|it| it.ray.is(&Purpose::Transmitted)) {
        let Some(facing) = it.facing() else { continue };
        let Some(ratio) = ratio(traced, &it, &usual) else { continue };
        // the cosine behind is a root: its error grows as it falls
        let sine = (ratio * facing.cross(it.arriving).length()).min(1.0);
        let tolerance = (4.0 * traced.tolerance() + it.off_unit())
            / (1.0 - sine * sine).max(traced.tolerance()).sqrt();
        let expected = refracted(it.arriving, facing, ratio);
        let holds = expected.is_some_and(|expected| is_near(it.leaving, expected, tolerance));
        asked.count(it.index, holds, || {
            let is = |v: Option<Vector>| {
                v.and_then(Vector::unit)
                    .is_some_and(|v| is_near(it.leaving, v, tolerance.max(1e-4)))
            };
            let inverted = is(refracted(it.arriving, facing, 1.0 / ratio));
            let is_inside = it.is_inside(traced) == Some(true);
            let normal = it.normal().unwrap_or(facing);
            let is_away = normal.dot(it.arriving) > 0.0;
            let causes = [
                ("one-ratio", is_inside && inverted),
                ("ratio-inverted", inverted),
                ("normal-not-turned", is_away && is(refracted(it.arriving, normal, ratio))),
                ("straight-on", is(Some(it.arriving))),
                ("total-reflection", expected.is_none()),
            ];
            (words(&it, facing, expected), causes)
        });
        asked.expect(it.index, expected);
    }
}

fn words(it: &Leaving<'_>, facing: Vector, expected: Option<Vector>) -> String {
    let angle = |v: Vector| short(to_degrees(atan2(v.cross(facing).length(), v.dot(facing).abs())));
    let [arriving, leaving] = [angle(it.arriving), angle(it.leaving)];
    match expected {
        Some(expected) if angle(expected) == leaving => {
            let apart = short(to_degrees(angle_between(expected, it.leaving)));
            format!(
                "goes on at Snell's angle, {leaving}°, but {apart}° from there: to another side"
            )
        }
        Some(expected) => format!(
            "arrives at {arriving}° and goes on at {leaving}°, where Snell's law gives {}°",
            angle(expected)
        ),
        None => {
            format!("arrives at {arriving}°, beyond the critical angle, and goes on at {leaving}°")
        }
    }
}

/// The index in front over the one behind, as the log says.
pub fn logged(traced: &Traced, it: &Leaving<'_>) -> Option<f64> {
    let factors = &it.ray.factors;
    let indices = factors.eta_from.zip(factors.eta_to).map(|(from, to)| from / to);
    let is_inverse = traced.conventions.eta_is_front_over_behind;
    indices.or(factors.eta.map(|eta| if is_inverse { eta } else { 1.0 / eta }))
}

/// The index in front over the one behind that a ray should have met. Leaving an object it is the inverse of entering it,
/// whatever the program used.
pub fn ratio(traced: &Traced, it: &Leaving<'_>, usual: &Ratios) -> Option<f64> {
    let usual = usual.get(&it.parent.object).copied();
    match it.is_inside(traced) {
        Some(true) => usual.or_else(|| logged(traced, it)),
        Some(false) => logged(traced, it).or(usual.map(|usual| 1.0 / usual)),
        None => logged(traced, it),
    }
}

/// The index of each object over the one around it, by the rays that enter it: as logged, or else as they are refracted.
pub fn usual_ratios(traced: &Traced) -> Ratios {
    let mut ratios: HashMap<Option<Arc<str>>, Vec<f64>> = HashMap::new();
    let mut media: HashMap<Option<Arc<str>>, HashSet<u64>> = HashMap::new();
    for it in leaving(traced).filter(|it| it.ray.is(&Purpose::Transmitted)) {
        let of_object = media.entry(it.parent.object.clone()).or_default();
        let indices = [it.ray.factors.eta_from, it.ray.factors.eta_to];
        of_object.extend(indices.into_iter().flatten().map(f64::to_bits));
        if it.is_inside(traced) != Some(false) {
            continue;
        }
        let seen = it.normal().and_then(|normal| {
            let [front, behind] = [it.arriving, it.leaving].map(|v| v.cross(normal).length());
            (front > STEEP && behind > STEEP).then(|| front / behind)
        });
        let ratio = logged(traced, &it).map(|ratio| 1.0 / ratio).or(seen);
        ratios.entry(it.parent.object.clone()).or_default().extend(ratio);
    }
    // an object of several media has no ratio of its own
    let one = |ratios: Vec<f64>| {
        let median = median(ratios.clone())?;
        let alike = ratios.iter().filter(|ratio| (**ratio - median).abs() <= 1e-3 * median).count();
        (20 * alike >= 19 * ratios.len()).then_some(median)
    };
    ratios.retain(|object, _| media.get(object).is_none_or(|indices| indices.len() <= 2));
    ratios.into_iter().filter_map(|(object, ratios)| Some((object, one(ratios)?))).collect()
}
