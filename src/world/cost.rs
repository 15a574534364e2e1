//! The cost of a search for the first hit.

use super::World;
use crate::accel::Counts;
use crate::math::{Ray, Span};

impl World {
    /// The objects that the search of [`World::hit`] tests along the ray, and the nodes or cells that it visits. What a
    /// mesh or another composite object searches inside itself is not counted.
    pub fn search_cost(&self, ray: &Ray, span: Span) -> Counts {
        let mut counts = Counts::default();
        let hit = |index: u32, span| self.objects[index as usize].shape.hit(ray, span);
        self.accel.nearest_counted(ray, span, &mut counts, hit);
        counts
    }
}
