//! The rays of a tree as straight pieces between points of the world.

use explain::RecordedRay;
use groundtruth::lights::{LightContext, MAX_DRAWS, Segment as Way};
use groundtruth::math::{Point, Ray, Span};
use groundtruth::trace::{Outcome, RayKind};
use groundtruth::world::World;

/// One straight piece of a ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Segment {
    /// The number of the ray in its tree.
    pub ray: usize,
    /// The point where it begins.
    pub from: Point,
    /// The point where it ends.
    pub to: Point,
    /// What is at its end.
    pub end: End,
}

/// What is at the end of a piece.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// A surface that the ray hits.
    Hit,
    /// Nothing: the ray leaves the scene, or goes to a light that is infinitely far away.
    Leaves,
    /// The point of a light to which a shadow ray is unblocked.
    Light,
    /// The object that blocks a shadow ray.
    Occluder,
    /// The light, on the dark way behind the object that blocks the shadow ray.
    Dark,
}

impl Segment {
    pub(crate) fn middle(&self) -> Point {
        self.from + 0.5 * (self.to - self.from)
    }
}

/// The pieces of all rays of a tree, in the order of their numbers; a ray that was not cast has none. A ray
/// that leaves is `reach` long, in world units.
pub fn segments(world: &World, root: &RecordedRay, reach: f64) -> Vec<Segment> {
    let mut found = Vec::new();
    add(world, root, None, reach, &mut found);
    found
}

fn add(
    world: &World,
    ray: &RecordedRay,
    parent: Option<&RecordedRay>,
    reach: f64,
    found: &mut Vec<Segment>,
) {
    found.extend(pieces(world, ray, parent, reach));
    for child in &ray.children {
        add(world, child, Some(ray), reach, found);
    }
}

/// The pieces of one ray.
pub(crate) fn pieces(
    world: &World,
    ray: &RecordedRay,
    parent: Option<&RecordedRay>,
    reach: f64,
) -> Vec<Segment> {
    let from = ray.ray.origin;
    let piece = |from: Point, to: Point, end: End| Segment { ray: ray.number, from, to, end };
    let far = || from + reach * ray.ray.direction.unit().unwrap_or_default();
    match ray.outcome {
        Outcome::TooDeep | Outcome::OverBudget => Vec::new(),
        Outcome::Hit => {
            let to = ray.hit.as_ref().map_or_else(far, |hit| hit.point);
            vec![piece(from, to, End::Hit)]
        }
        Outcome::Background => vec![piece(from, far(), End::Leaves)],
        Outcome::Unblocked { .. } => vec![match light_point(world, ray, parent) {
            Some(light) => piece(from, light, End::Light),
            None => piece(from, far(), End::Leaves),
        }],
        Outcome::Blocked { blocked_by } => {
            let light = light_point(world, ray, parent).unwrap_or_else(far);
            // a log says itself where the ray was blocked
            let logged = ray.hit.as_ref().map(|hit| hit.point);
            let occluder = logged.or_else(|| meeting(world, &ray.ray, blocked_by)).unwrap_or(light);
            vec![piece(from, occluder, End::Occluder), piece(occluder, light, End::Dark)]
        }
    }
}

/// The point of its light to which a shadow ray goes; `None` if the light is infinitely far away.
pub(crate) fn light_point(
    world: &World,
    ray: &RecordedRay,
    parent: Option<&RecordedRay>,
) -> Option<Point> {
    let RayKind::Shadow { light } = ray.kind else { return None };
    let placed = world.lights.iter().find(|placed| placed.index == light)?;
    let hit = parent?.hit.as_ref()?;
    let normal = if hit.front { hit.shading_normal } else { -hit.shading_normal };
    let context = LightContext { point: hit.point, normal };
    // whether it has a place is the same for all its samples
    let sample = placed.light.sample(&context, &[[0.5; 2]; MAX_DRAWS][..placed.light.draws()]);
    let is_endless = sample.is_some_and(|sample| sample.segment == Some(Way::Infinity));
    (!is_endless).then(|| ray.ray.at(1.0))
}

/// The first point in which a ray meets the object of this index.
fn meeting(world: &World, ray: &Ray, object: u32) -> Option<Point> {
    let mut ray = *ray;
    // surfaces that cast no shadow, or let light through, come before it
    for _ in 0..MAX_SURFACES {
        let hit = world.hit(&ray, Span::AHEAD)?;
        if hit.object.index == object {
            return Some(hit.surface.point);
        }
        ray.origin = hit.surface.leave(ray.direction);
    }
    None
}

/// The most surfaces that are looked through.
const MAX_SURFACES: usize = 64;
