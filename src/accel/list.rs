//! The list: every primitive is tested. Slow, obviously right, and so the reference.

use super::search::{Any, Nearest};
use super::{Counter, Primitives};
use crate::shapes::Candidate;

/// The numbers of the bounded primitives, in order.
#[derive(Debug)]
pub struct List {
    all: Vec<u32>,
}

impl List {
    pub(super) fn new(all: Vec<u32>) -> Self {
        Self { all }
    }

    pub(super) fn nearest<P: Primitives, C: Counter>(&self, search: &mut Nearest<'_, P, C>) {
        self.all.iter().for_each(|&index| search.consider(index));
    }

    pub(super) fn any<P: Primitives>(&self, search: &Any<'_, P>) -> Option<(u32, Candidate)> {
        self.all.iter().find_map(|&index| search.consider(index))
    }

    pub(super) fn memory_bytes(&self) -> usize {
        size_of_val(&*self.all)
    }
}
