//! What a camera must see: the ball around a scene or around a ray tree.

use groundtruth::math::{Aabb, Point};
use groundtruth::world::World;

use super::{End, Segment};

/// The ball around the camera's eyes and all objects with an end: its centre and its radius, in world units. The
/// radius is positive.
pub fn of_scene(world: &World) -> (Point, f64) {
    let bounds = world.objects().iter().map(|object| object.bounds());
    let objects = bounds.filter(Aabb::is_bounded).fold(Aabb::EMPTY, Aabb::union);
    let eyes = Aabb::around(world.view.eyes().iter().map(|eye| eye.position()));
    ball(objects.union(eyes))
}

/// The ball around the points where rays meet surfaces.
pub fn of_hits(segments: &[Segment]) -> Option<(Point, f64)> {
    let meets = |segment: &&Segment| matches!(segment.end, End::Hit | End::Occluder);
    let bounds = Aabb::around(segments.iter().filter(meets).map(|segment| segment.to));
    bounds.is_bounded().then(|| ball(bounds))
}

/// The ball around pieces of rays, but for the ends of those that leave the scene.
pub fn of_segments(segments: &[Segment]) -> Option<(Point, f64)> {
    let ends = |segment: &Segment| {
        let to = (segment.end != End::Leaves).then_some(segment.to);
        [Some(segment.from), to].into_iter().flatten()
    };
    let bounds = Aabb::around(segments.iter().flat_map(ends));
    bounds.is_bounded().then(|| ball(bounds))
}

fn ball(bounds: Aabb) -> (Point, f64) {
    let radius = 0.5 * bounds.extent().length();
    (bounds.center(), if radius > 0.0 { radius } else { 1.0 })
}
