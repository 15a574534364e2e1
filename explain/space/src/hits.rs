//! The hits of one object along a ray, one after the other.

use groundtruth::math::{Ray, Span};
use groundtruth::world::{Hit, PlacedObject, World};

/// The most hits of a ray.
const MAX_HITS: usize = 64;

/// The hits of an object along a ray in ascending order, each with its t, as if the object were alone. Each is the first
/// hit of what is left of the ray, which a shape of many parts finds faster than all at once.
pub struct Hits<'a> {
    world: &'a World,
    object: &'a PlacedObject,
    /// What is left of the ray.
    ray: Ray,
    /// Where it begins.
    start: f64,
    left: usize,
}

impl<'a> Hits<'a> {
    /// The hits of a ray, at most 64.
    pub fn of(world: &'a World, object: &'a PlacedObject, ray: Ray) -> Self {
        Self { world, object, ray, start: 0.0, left: MAX_HITS }
    }
}

impl<'a> Iterator for Hits<'a> {
    type Item = (f64, Hit<'a>);

    fn next(&mut self) -> Option<Self::Item> {
        self.left = self.left.checked_sub(1)?;
        let hit = self.world.hit_of(self.object, &self.ray, Span::AHEAD)?;
        self.start += hit.t;
        self.ray.origin = hit.surface.leave(self.ray.direction);
        Some((self.start, hit))
    }
}
