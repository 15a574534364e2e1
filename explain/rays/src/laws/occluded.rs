use std::collections::HashSet;

use super::LawReport;
use super::geometry::{glass, quoted};
use super::nearest::start;
use crate::log::Purpose;
use crate::traced::Traced;
use groundtruth::math::{self, Span, Vector};
use groundtruth::world::Hit;

/// The part of the way at its ends where a hit may be the surface itself, or the lamp.
const ENDS: f64 = 1e-3;
/// Below this cosine a small error of the ray decides.
const GRAZING: f64 = 0.03;

pub fn check(traced: &Traced, asked: &mut LawReport) {
    let Some(world) = &traced.world else { return };
    let shadows = traced.log.rays.iter().filter(|ray| ray.is(&Purpose::Shadow));
    let blockers: HashSet<_> = shadows.filter_map(|ray| ray.object.as_ref()).collect();
    let glass = glass(traced);
    for (index, ray) in traced.rays() {
        let Some(parent) = traced.parent(index).filter(|_| ray.is(&Purpose::Shadow)) else {
            continue;
        };
        let length = ray.direction.length();
        if !(ray.origin.is_finite() && length.is_finite() && length > 0.0) {
            continue;
        }
        let way = traced.way_to_lamp(ray).map(|way| way.length() / length);
        let end = way.map_or(f64::INFINITY, |end| end * (1.0 - ENDS));
        let from_lamp =
            way.filter(|_| traced.conventions.shadow_from_lamp).map_or(0.0, |end| ENDS * end);
        let min = (start(traced, index) / length).max(from_lamp);
        let line = math::Ray::new(ray.origin, ray.direction);
        let ours = (min < end).then(|| world.hit(&line, Span { min, max: end })).flatten();
        let is_blocked = ray.t.is_some() || ray.object.is_some();
        let cosine =
            |hit: &Hit<'_>| Vector::from(hit.surface.normal).dot(ray.direction).abs() / length;
        // one that leaves along its surface, or below it, is for rounding to decide
        let normal = parent.normal.and_then(Vector::unit);
        let leaves = normal.map_or(1.0, |n| n.dot(ray.direction).abs() / length);
        let lamp = ray.object.is_some() && ray.object == ray.light;
        let is_told =
            leaves > GRAZING && ours.as_ref().is_none_or(|hit| cosine(hit) > GRAZING) && !lamp;
        let in_lengths =
            |t| (traced.along(ray, t) - ray.origin).dot(ray.direction) / (length * length);
        let t = ray.t.map(in_lengths);
        let near = t.is_some_and(|t| t >= 0.0 && t <= 2.0 * min);
        let far = t.is_some_and(|t| t >= end);
        // the log may name some of the objects only
        let is_unknown =
            ray.object.as_ref().is_some_and(|name| !world.names.objects.contains(name));
        if is_unknown && ours.is_none() {
            continue;
        }
        if !is_told || near || far && ours.is_none() && ray.end.is_some() {
            continue;
        }
        // light passes glass in many programs
        let passes = |hit: &Hit<'_>| {
            let name = &hit.object.name;
            !hit.casts_shadow() || glass.contains(name) && !blockers.contains(name)
        };
        // where its end is not known, it ends at its lamp
        let shines = |hit: &Hit<'_>| {
            let name = hit.object.name.as_ref();
            let lamp = traced.log.lamps.iter().find(|lamp| Some(&lamp.name) == ray.light.as_ref());
            let of_lamp = lamp.and_then(|lamp| lamp.fields.get("object")?.as_str());
            ray.light.as_deref() == Some(name) || of_lamp == Some(name)
        };
        let at_lamp = ours.as_ref().is_some_and(|hit| ray.end.is_none() && shines(hit));
        if (ours.as_ref().is_some_and(passes) || at_lamp) && !is_blocked {
            continue;
        }
        asked.count(index, is_blocked == ours.is_some(), || {
            let ours_name = ours.as_ref().map(|hit| &hit.object.name);
            let by = quoted(ours_name.or(ray.object.as_ref()), "something");
            let words = match ours.is_some() {
                true => format!("reaches its lamp, though {by} is in the way"),
                false => format!("is blocked by {by}, though nothing is in the way"),
            };
            let is_forgotten = ours_name.is_some_and(|name| !blockers.contains(name));
            let causes = [
                ("forgotten-object", is_forgotten),
                ("behind-lamp", far),
                ("behind-start", ray.t.is_some_and(|t| t < 0.0)),
                ("nothing-there", ours.is_none() && !far),
            ];
            (words, causes)
        });
    }
}
