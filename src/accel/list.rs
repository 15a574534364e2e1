//! The list: every primitive is tested. Slow, obviously right, and so the reference.

use super::{Nearest, Primitives};
use crate::shapes::Candidate;

/// So many primitives, in order.
#[derive(Debug)]
pub struct List {
    count: u32,
}

impl List {
    pub(super) fn new(count: usize) -> Self {
        Self { count: u32::try_from(count).expect("primitives are numbered by u32") }
    }

    pub(super) fn nearest<P: Primitives>(
        &self,
        mut search: Nearest<'_, P>,
    ) -> Option<(u32, Candidate)> {
        (0..self.count).for_each(|index| search.consider(index));
        search.best
    }

    pub(super) fn any(
        &self,
        test: impl Fn(u32) -> Option<(u32, Candidate)>,
    ) -> Option<(u32, Candidate)> {
        (0..self.count).find_map(test)
    }
}
