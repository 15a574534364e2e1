use std::collections::BTreeMap;
use std::f64::consts::PI;
use std::sync::Arc;

use super::LawReport;
use super::geometry::{glass, quoted};
use super::nearest::start;
use super::surface::Surface;
use crate::log::Purpose;
use crate::traced::Traced;
use groundtruth::math::{Frame, Normal, Point, Vector, atan2};
use text::digits::short;

/// Fewer hits do not show where a surface is.
const FEW: usize = 20;
/// So many hits of an object are compared with, and so many objects.
const MOST_HITS: usize = 400;
const MOST_OBJECTS: usize = 64;
/// The part of a ray's length at which it is at its end.
const NEARLY: f64 = 0.9;
/// The neighbours that a place has to have on all sides, and the largest angle between two of them.
const NEIGHBOURS: usize = 5;
const GAP: f64 = 2.0 * PI / 3.0;

/// A surface that is known by the rays that hit it.
struct Seen {
    name: Arc<str>,
    surface: Surface,
    /// Where, and whether the ray came along the surface's normal.
    hits: Vec<(Point, bool)>,
    /// How far apart neighbouring hits are.
    spacing: f64,
    /// The corners of a box around all places that have neighbours.
    corners: [Vector; 2],
}

pub fn check(traced: &Traced, asked: &mut LawReport) {
    if traced.world.is_some() {
        return;
    }
    let (seen, glass) = (seen(traced), glass(traced));
    for (index, ray) in traced.rays().filter(|_| !seen.is_empty()) {
        let Some(direction) = ray.direction.unit().filter(|_| ray.origin.is_finite()) else {
            continue;
        };
        if traced.parents[index].is_none() && !ray.is(&Purpose::Camera) {
            continue;
        }
        let is_blocked = ray.is_shadow() && (ray.t.is_some() || ray.object.is_some());
        let lamp = traced.way_to_lamp(ray).map(Vector::length);
        let end = match ray.is_shadow() {
            true if is_blocked || traced.conventions.shadow_from_lamp => continue,
            true => lamp.unwrap_or(f64::INFINITY),
            false => traced.end_point(index).map_or(f64::INFINITY, |end| end.distance(ray.origin)),
        };
        let span = [start(traced, index).max(1e-3 * traced.scale), (1.0 - 1e-3) * end];
        let passed = seen.iter().find_map(|it| {
            let is_open = ray.is_shadow()
                && (glass.contains(&it.name) || ray.light.as_ref() == Some(&it.name));
            let sender = traced.parent(index).and_then(|parent| parent.object.as_ref());
            let enters = ray.is(&Purpose::Transmitted) && sender == Some(&it.name);
            let hits = it.surface.hits(ray.origin, direction).into_iter().filter(|_| !is_open);
            // by rounding it ended on this very surface
            let far = if ray.object.as_ref() == Some(&it.name) { NEARLY * end } else { span[1] };
            let mut hits = hits.filter(|at| (span[0]..span[1].min(far)).contains(at));
            let at =
                hits.find(|at| it.is_there(ray.origin + *at * direction, direction, enters))?;
            Some((it, at, enters))
        });
        asked.count(index, passed.is_none(), || {
            let (it, at, enters) = passed.expect("it breaks the law");
            let words = format!(
                "passes {} {} away from its start, where others hit it",
                quoted(Some(&it.name), ""),
                short(at)
            );
            let causes = [
                ("farther-object", !ray.is_shadow() && !enters && end.is_finite()),
                ("root-not-tried", enters),
                ("shadow-unblocked", ray.is_shadow()),
            ];
            (words, causes)
        });
    }
}

/// The planes and balls on which all hits of an object lie.
fn seen(traced: &Traced) -> Vec<Seen> {
    let mut objects: BTreeMap<&Arc<str>, Vec<(Point, Vector, Vector)>> = BTreeMap::new();
    for (index, ray) in traced.rays().filter(|(_, ray)| !ray.is_shadow()) {
        if let (Some(name), Some(end), Some(normal)) =
            (&ray.object, traced.end_point(index), ray.normal)
        {
            objects.entry(name).or_default().push((end, normal, ray.direction));
        }
    }
    objects.retain(|_, hits| hits.len() >= FEW);
    if objects.len() > MOST_OBJECTS {
        return Vec::new();
    }
    let one = |(name, hits): (&Arc<str>, Vec<(Point, Vector, Vector)>)| {
        let surface = Surface::of_hits(traced, name)?;
        let step = hits.len().div_ceil(MOST_HITS);
        let along = |it: &(Point, Vector, Vector)| surface.normal(it.0).dot(it.2) > 0.0;
        let hits: Vec<(Point, bool)> =
            hits.iter().step_by(step).map(|it| (it.0, along(it))).collect();
        let nearest = |at: usize| {
            let others = hits.iter().enumerate().filter(|other| other.0 != at);
            others.map(|other| other.1.0.distance(hits[at].0)).fold(f64::INFINITY, f64::min)
        };
        let spacing = crate::traced::median((0..hits.len()).map(nearest).collect())?;
        let corner = |of: fn(f64, f64) -> f64, sign: f64| {
            let along = |axis: usize| hits.iter().map(|hit| hit.0.along(axis)).reduce(of);
            Some(
                Vector::new(along(0)?, along(1)?, along(2)?)
                    + 6.0 * sign * spacing * Vector::new(1.0, 1.0, 1.0),
            )
        };
        let corners = [corner(f64::min, -1.0)?, corner(f64::max, 1.0)?];
        Some(Seen { name: Arc::clone(name), surface, hits, spacing, corners })
    };
    objects.into_iter().filter_map(one).collect()
}

impl Seen {
    /// Whether rays hit the surface all around a place, from the same side; those that are in a ball have to leave it anywhere.
    fn is_there(&self, place: Point, direction: Vector, enters: bool) -> bool {
        if enters && matches!(self.surface, Surface::Ball { .. }) {
            return true;
        }
        let [low, high] = self.corners;
        let is_inside = |axis| (low.along(axis)..=high.along(axis)).contains(&place.along(axis));
        let normal = Normal::new(self.surface.normal(place)).filter(|_| (0..3).all(is_inside));
        let Some(normal) = normal else { return false };
        let (frame, along) = (Frame::around(normal), Vector::from(normal).dot(direction) > 0.0);
        let is_near = |(hit, side): &&(Point, bool)| {
            *side == along && hit.distance(place) <= 6.0 * self.spacing
        };
        let turn = |(hit, _): &(Point, bool)| {
            let local = frame.to_local(*hit - place);
            atan2(local.y(), local.x())
        };
        let mut turns: Vec<f64> = self.hits.iter().filter(is_near).map(turn).collect();
        turns.sort_by(f64::total_cmp);
        let gaps = turns.windows(2).map(|pair| pair[1] - pair[0]);
        let last = turns.first().zip(turns.last()).map_or(f64::INFINITY, |(a, b)| a + 2.0 * PI - b);
        turns.len() >= NEIGHBOURS && gaps.fold(last, f64::max) < GAP
    }
}
