//! What waits while a walk goes down elsewhere.

use std::mem::MaybeUninit;

use super::node::WIDTH;
use crate::accel::build::DEEPEST;

/// Children that wait, each as one number, its distance above its place.
pub struct Stack<'a> {
    pub room: &'a mut Room,
    /// So many have been written.
    pub len: usize,
}

/// Where children wait: at most fifteen for each node above the present one.
pub type Room = [MaybeUninit<u64>; (WIDTH - 1) * DEEPEST];

// so many can be counted where a walk stops
const _: () = assert!((WIDTH - 1) * DEEPEST <= u16::MAX as usize);

impl Stack<'_> {
    /// Nothing waits.
    pub const ROOM: Room = [const { MaybeUninit::uninit() }; (WIDTH - 1) * DEEPEST];

    /// Puts a child below the nearer ones, but above `bottom`.
    #[inline(always)]
    pub fn insert(&mut self, bottom: usize, child: u64) {
        let mut place = self.len;
        while place > bottom && self.get(place - 1) < child {
            self.room[place].write(self.get(place - 1));
            place -= 1;
        }
        self.room[place].write(child);
        self.len += 1;
    }

    /// The last.
    #[inline(always)]
    pub fn pop(&mut self) -> Option<u64> {
        self.len = self.len.checked_sub(1)?;
        Some(self.get(self.len))
    }

    #[inline(always)]
    #[allow(unsafe_code, reason = "clearing the stack for each ray would take a tenth of its time")]
    fn get(&self, place: usize) -> u64 {
        // SAFETY: places below `len` have been written, and no other is read
        unsafe { self.room[place].assume_init() }
    }
}
