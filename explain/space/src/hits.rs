//! The hits of one object along a ray, one after the other.

use groundtruth::math::{Ray, Span};
use groundtruth::world::{Hit, PlacedObject, World};

/// The most hits of a ray.
const MAX_HITS: usize = 64;

/// The hits of an object along a ray in ascending order, each with its t, as if the object were alone; at most 64. Each is the
/// first hit of what is left of the ray, which a shape of many parts finds faster than all at once.
pub fn hits<'a>(
    world: &'a World,
    object: &'a PlacedObject,
    mut ray: Ray,
) -> impl Iterator<Item = (f64, Hit<'a>)> {
    let mut start = 0.0;
    let next = move || {
        let hit = world.hit_of(object, &ray, Span::AHEAD)?;
        start += hit.t;
        ray.origin = hit.surface.leave(ray.direction);
        Some((start, hit))
    };
    std::iter::from_fn(next).take(MAX_HITS)
}
