//! The stack of children that a walk visits later.

use std::mem::MaybeUninit;

use super::node::WIDTH;
use crate::accel::build::MAX_DEPTH;

/// Children to visit, each as one number: its distance in the upper bits, its index in the lower.
pub struct Stack<'a> {
    pub room: &'a mut Room,
    /// The first `len` are written.
    pub len: usize,
}

/// Room for the stack: at most fifteen children for each node above the present one.
pub type Room = [MaybeUninit<u64>; (WIDTH - 1) * MAX_DEPTH];

// `Stop::Undecided` stores the length in a `u16`
const _: () = assert!((WIDTH - 1) * MAX_DEPTH <= u16::MAX as usize);

impl Stack<'_> {
    /// An empty stack's.
    pub const ROOM: Room = [const { MaybeUninit::uninit() }; (WIDTH - 1) * MAX_DEPTH];

    /// Inserts a child below the nearer ones, but not below `bottom`.
    #[inline(always)]
    pub fn insert(&mut self, bottom: usize, child: u64) {
        let mut index = self.len;
        while index > bottom && self.get(index - 1) < child {
            self.room[index].write(self.get(index - 1));
            index -= 1;
        }
        self.room[index].write(child);
        self.len += 1;
    }

    /// Removes the top of the stack, the nearest.
    #[inline(always)]
    pub fn pop(&mut self) -> Option<u64> {
        self.len = self.len.checked_sub(1)?;
        Some(self.get(self.len))
    }

    #[inline(always)]
    #[allow(unsafe_code, reason = "clearing the stack for each ray would take a tenth of its time")]
    fn get(&self, index: usize) -> u64 {
        // SAFETY: the entries below `len` are written, and no other is read
        unsafe { self.room[index].assume_init() }
    }
}
