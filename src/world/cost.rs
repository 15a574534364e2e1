//! The cost of searches along rays.

use std::cell::Cell;

use super::World;
use crate::accel::Counts;
use crate::math::{Ray, Span};

/// What a search looks for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Search {
    /// The first hit, as [`World::hit`] does.
    FirstHit,
    /// Any object that blocks light, as [`World::occluder`] does.
    Occluder,
}

impl World {
    /// The objects that a search tests along the ray, and the nodes or cells that it visits. What a
    /// mesh or another composite object searches inside itself is not counted.
    pub fn search_cost(&self, search: Search, ray: &Ray, span: Span) -> Counts {
        let mut counts = Counts::default();
        match search {
            Search::FirstHit => {
                let hit = |index: u32, span| self.objects[index as usize].shape.hit(ray, span);
                self.accel.nearest(ray, span, &mut counts, hit);
            }
            Search::Occluder => {
                let tested = Cell::new(0);
                let blocked = |index: u32| {
                    let object = &self.objects[index as usize];
                    if !object.casts_shadows {
                        return None;
                    }
                    tested.set(tested.get() + 1);
                    object.shape.shadow_hit(ray, span)
                };
                self.accel.any(ray, span, &mut counts, blocked);
                counts.tests = tested.get();
            }
        }
        counts
    }
}
