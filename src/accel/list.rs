//! The list: every primitive is tested. Slow, obviously right, and so the reference.

use super::search::Search;

/// The numbers of the bounded primitives, in order.
#[derive(Debug)]
pub struct List {
    all: Vec<u32>,
}

impl List {
    pub(super) fn new(all: Vec<u32>) -> Self {
        Self { all }
    }

    /// Tests all.
    #[inline(never)]
    pub(super) fn search(&self, search: &mut impl Search) {
        if search.enter().is_some() {
            self.all.iter().any(|&index| search.consider(index));
        }
    }

    pub(super) fn memory_bytes(&self) -> usize {
        size_of_val(&*self.all)
    }
}
