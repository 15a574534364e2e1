use std::cell::LazyCell;
use std::collections::HashSet;
use std::sync::Arc;

use super::LawReport;
use super::geometry::quoted;
use crate::log::{Purpose, Ray};
use crate::traced::{Traced, size};
use groundtruth::math::{self, Span, Vector};
use groundtruth::world::{Hit, World};
use text::digits::short;

/// The part of a distance within which it is the same root.
const SAME: f64 = 1e-6;
/// Below this cosine a small error of the ray decides whether it hits.
const GRAZING: f64 = 0.03;

pub fn check(traced: &Traced, asked: &mut LawReport) {
    let Some(world) = &traced.world else { return };
    let objects = || traced.log.rays.iter().filter_map(|ray| ray.object.as_ref());
    let hit: LazyCell<HashSet<_>, _> = LazyCell::new(|| objects().collect());
    for (index, ray) in traced.rays() {
        if ray.is_shadow() || !(ray.origin.is_finite() && ray.direction.is_finite()) {
            continue;
        }
        let Some(seen) = Seen::of(traced, index, world) else { continue };
        asked.count(index, seen.holds, || {
            let ours = seen.ours.as_ref();
            let is_same = ours.is_some_and(|hit| ray.object.as_ref() == Some(&hit.object.name));
            let is_beyond = |his: f64, t: f64| his - t > SAME * t.abs();
            let is_nearer =
                ours.is_some_and(|hit| seen.his.is_none_or(|his| is_beyond(his, hit.t)));
            let never = ours.is_some_and(|ours| !hit.contains(&ours.object.name));
            let is_early =
                ours.is_some_and(|hit| hit.t * ray.direction.length() < 1e-2 * traced.scale);
            let is_behind = seen.his.is_some_and(|his| his < 0.0);
            let causes = [
                ("never-hit", is_nearer && never),
                ("farther-root", is_nearer && is_same && seen.his.is_some()),
                ("farther-object", is_nearer && !is_same && seen.his.is_some() && !never),
                ("behind-origin", is_behind),
                ("large-smallest-t", is_nearer && is_early && !never),
                ("nothing-there", !is_nearer && !is_behind),
            ];
            (seen.words(ray), causes)
        });
    }
}

/// What a ray hits, by the log and by the tracer.
struct Seen<'a> {
    his: Option<f64>,
    ours: Option<Hit<'a>>,
    holds: bool,
}

impl<'a> Seen<'a> {
    /// `None` if rounding decides.
    fn of(traced: &Traced, index: usize, world: &'a World) -> Option<Self> {
        let ray = traced.ray(index);
        // one that nobody sent starts on a surface that is not known
        if traced.parents[index].is_none()
            && ray.kind.as_ref().is_some_and(|kind| *kind != Purpose::Camera)
        {
            return None;
        }
        let length = ray.direction.length();
        let start = start(traced, index) / length;
        let ours = world.hit(
            &math::Ray::new(ray.origin, ray.direction),
            Span { min: start, max: f64::INFINITY },
        );
        // in units of the direction, whatever the log's are
        let his = match (ray.point, ray.t.filter(|t| t.is_finite())) {
            (_, Some(t)) => Some(if traced.conventions.t_is_length { t / length } else { t }),
            (Some(point), None) => {
                Some((point - ray.origin).dot(ray.direction) / (length * length))
            }
            (None, None) => None,
        };
        // a hit nearer than where ours are looked for is another law's
        if his.is_some_and(|t| t >= 0.0 && t <= 2.0 * start) {
            return None;
        }
        // the log may name some of the objects only
        let is_unknown =
            ray.object.as_ref().is_some_and(|name| !world.names.objects.contains(name));
        if is_unknown && ours.as_ref().is_none_or(|hit| his.is_some_and(|his| his <= hit.t)) {
            return None;
        }
        let cosine =
            |hit: &Hit<'_>| Vector::from(hit.surface.normal).dot(ray.direction).abs() / length;
        let grazes =
            |n: Vector| n.unit().is_some_and(|n| n.dot(ray.direction).abs() < GRAZING * length);
        let is_nearer = his.is_some_and(|t| ours.as_ref().is_none_or(|hit| t < hit.t));
        let is_grazing = ours.as_ref().is_some_and(|hit| cosine(hit) < GRAZING)
            || is_nearer && ray.normal.is_some_and(grazes);
        let holds = match (his, &ours) {
            (None, None) => true,
            (Some(t), Some(hit)) => {
                let sizes = size(ray.origin)
                    + size(hit.surface.point)
                    + traced.object_size(Some(&hit.object.name));
                // a program that takes a direction for a unit vector errs by what it is not: at a ball of radius r by
                // ε t²/(2 r cosine), so that it counts with the object's size
                let off_unit = (length - 1.0).abs();
                let bounds = hit.object.shape.bounds();
                let radius = 0.5 * (bounds.max - bounds.min).max_abs();
                let reach = t.abs() * (1.0 + t.abs() / radius.max(f64::MIN_POSITIVE));
                let off_unit = if off_unit <= 1e-3 { 4.0 * off_unit * reach } else { 0.0 };
                let off = (t - hit.t).abs() * length - traced.slack_along(ray);
                let rounding = 8.0 * traced.slack(sizes) + traced.hits_are_off + off_unit;
                off * cosine(hit).max(GRAZING) <= rounding
            }
            _ => false,
        };
        (holds || !is_grazing).then_some(Self { his, ours, holds })
    }

    fn words(&self, ray: &Ray) -> String {
        let object = |object: Option<&Arc<str>>| quoted(object, "a surface");
        let his = match self.his {
            Some(t) => format!("hits {} at t {}", object(ray.object.as_ref()), short(t)),
            None => "hits nothing".to_owned(),
        };
        match &self.ours {
            Some(hit) => format!(
                "{his}, where {} is nearest, at t {}",
                object(Some(&hit.object.name)),
                short(hit.t)
            ),
            None => format!("{his}, where nothing is"),
        }
    }
}

/// How far from its origin a ray's hits are looked for: past the surface that it starts on.
pub fn start(traced: &Traced, index: usize) -> f64 {
    let (ray, Some(parent)) = (traced.ray(index), traced.parents[index]) else { return 0.0 };
    let moved = traced.end_point(parent).map_or(0.0, |end| (ray.origin - end).length());
    let moved = if moved < 0.1 * traced.scale { moved } else { 0.0 };
    let sizes = size(ray.origin) + traced.object_size(traced.ray(parent).object.as_ref());
    // the direction of a shadow ray may be the whole way to the lamp
    let least = (traced.along(ray, traced.least_t) - ray.origin).length().min(traced.small);
    (4.0 * moved).max(1e-4 * traced.scale).max(traced.slack(64.0 * sizes)).max(least)
}

/// How far a ray's hit is from the nearest surface, and how far rounding may move it.
pub fn distance_to_truth(traced: &Traced, index: usize) -> Option<[f64; 2]> {
    let (ray, world) = (traced.ray(index), traced.world.as_ref()?);
    let end = traced.end_point(index).filter(|end| end.is_finite() && !ray.is_shadow())?;
    let seen = Seen::of(traced, index, world)?;
    let hit =
        seen.ours.filter(|hit| ray.object.as_ref().is_none_or(|name| *name == hit.object.name))?;
    let off = (hit.surface.point - end).dot(Vector::from(hit.surface.normal)).abs();
    let sizes = size(ray.origin) + size(end) + traced.object_size(ray.object.as_ref());
    Some([off, traced.slack(sizes) + traced.slack_along(ray)])
}
