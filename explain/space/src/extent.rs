//! What a camera must see: the ball around a scene or around a ray tree.

use groundtruth::math::{Aabb, Point};
use groundtruth::world::World;

use super::{End, Segment};

/// The ball around the camera's eyes and all objects with an end: its centre and its radius, in world units. The
/// radius is positive.
pub fn of_scene(world: &World) -> (Point, f64) {
    let bounds = world.objects().iter().map(|object| object.shape.bounds());
    let objects = bounds.filter(Aabb::is_bounded).fold(Aabb::EMPTY, Aabb::union);
    let eyes = Aabb::around(world.view.eyes().iter().map(|eye| eye.position()));
    let bounds = objects.union(eyes);
    let radius = 0.5 * bounds.extent().length();
    (bounds.center(), if radius > 0.0 { radius } else { 1.0 })
}

/// The ball around what the rays of a tree meet: the points that they hit, and the objects there that are not much larger
/// than the tree. The eye and the lights may be far outside. `None` if nothing is hit.
pub fn of_hits(world: &World, segments: &[Segment]) -> Option<(Point, f64)> {
    let is_met = |segment: &&Segment| matches!(segment.end, End::Hit | End::Occluder);
    let met = || segments.iter().filter(is_met);
    let longest = met().map(|it| (it.to - it.from).length()).fold(0.0, f64::max);
    let mut all = Aabb::around(met().map(|segment| segment.to));
    let reach = (0.5 * all.extent().length()).max(OF_RAYS * longest);
    let is_near = |bounds: &Aabb| {
        let touched = met().any(|segment| bounds.padded().contains(segment.to));
        bounds.is_bounded() && touched && bounds.extent().length() < 4.0 * reach
    };
    let boxes = world.objects().iter().map(|object| object.shape.bounds()).filter(is_near);
    all = boxes.fold(all, Aabb::union);
    all.is_bounded().then(|| (all.center(), reach.max(0.5 * all.extent().length())))
}

/// The least radius of the ball around what rays meet, in lengths of the longest of them.
const OF_RAYS: f64 = 0.12;
