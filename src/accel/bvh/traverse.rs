//! From the root to the leaves, the nearest first.
//!
//! One traversal for all searches and all kinds of primitives. It is compiled once for each
//! [`Kernel`]: only then do the kernels become part of it rather than calls.

use arrayvec::ArrayVec;

use super::build::DEEPEST;
use super::node::{Crossed, LEAF, Node, Ray32, WIDTH};
use super::{Bvh, NOTHING};
use crate::accel::kernel::{Instructions, Kernel};
use crate::accel::search::Search;

/// Children that wait: at most seven for each node above the present one.
type Stack = ArrayVec<u64, { (WIDTH - 1) * DEEPEST }>;

impl Bvh {
    /// Shows the search every primitive that it might still want, until it has enough.
    #[allow(unsafe_code, reason = "calls what not every processor can run")]
    pub(in crate::accel) fn search<S: Search>(&self, search: &mut S) {
        if self.nodes.is_empty() {
            return;
        }
        match self.kernel.instructions() {
            Instructions::Plain => self.walk(search, Kernel::PLAIN),
            // SAFETY: a kernel is made only where the processor has its instructions
            #[cfg(target_arch = "x86_64")]
            Instructions::Avx2 => unsafe { self.walk_avx2(search) },
            #[cfg(target_arch = "x86_64")]
            Instructions::Avx512 => unsafe { self.walk_avx512(search) },
        }
    }

    #[cfg(target_arch = "x86_64")]
    #[target_feature(enable = "avx2,fma")]
    fn walk_avx2<S: Search>(&self, search: &mut S) {
        self.walk(search, Kernel::AVX2);
    }

    #[cfg(target_arch = "x86_64")]
    #[target_feature(enable = "avx2,fma,avx512f")]
    fn walk_avx512<S: Search>(&self, search: &mut S) {
        self.walk(search, Kernel::AVX512);
    }

    #[inline(always)]
    fn walk<S: Search>(&self, search: &mut S, kernel: Kernel) {
        let ray = Ray32::new(search.ray(), search.span());
        let mut last = last(search);
        let mut stack = Stack::new();
        let mut next = 0;
        loop {
            if next & LEAF == 0 {
                search.step();
                let node = &self.nodes[next as usize];
                let crossed = node.crossed(kernel, &ray, last);
                if let Some(nearest) = push_all_but_nearest(node, crossed, &mut stack) {
                    next = nearest;
                    continue;
                }
            } else {
                if self.leaf(search, kernel, next & !LEAF) {
                    return;
                }
                last = self::last(search);
            }
            // equal distance is not farther: ties are settled by the order of objects
            next = loop {
                let Some(waiting) = stack.pop() else { return };
                if f32::from_bits((waiting >> 32) as u32) <= last {
                    break waiting as u32;
                }
            };
        }
    }

    /// Shows the search the primitives of a leaf; says whether it has enough.
    #[inline(always)]
    fn leaf<S: Search>(&self, search: &mut S, kernel: Kernel, number: u32) -> bool {
        let mut worth = search.sift(kernel, number);
        while worth != 0 {
            let slot = worth.trailing_zeros() as usize;
            let index = || Some(self.leaves[number as usize][slot]).filter(|&i| i != NOTHING);
            if search.consider_in_leaf(number, slot, index) {
                return true;
            }
            worth &= worth - 1;
        }
        false
    }
}

/// How far away in the frame a hit may still be, rounded up.
#[inline(always)]
fn last(search: &impl Search) -> f32 {
    (search.ray().last(search.span()) as f32).next_up()
}

/// The nearest of the children that are crossed; the others go to the stack, the nearest on top.
///
/// A child waits as one number, its distance (which is not negative) above and its place below, so
/// that numbers are in order as distances are.
#[inline(always)]
fn push_all_but_nearest(node: &Node, (mut mask, near): Crossed, stack: &mut Stack) -> Option<u32> {
    let mut take = || {
        let slot = mask.trailing_zeros() as usize;
        mask &= mask.wrapping_sub(1);
        (slot < WIDTH)
            .then(|| u64::from(near[slot].to_bits()) << 32 | u64::from(node.children[slot]))
    };
    let mut nearest = take()?;
    let bottom = stack.len();
    while let Some(child) = take() {
        let farther = nearest.max(child);
        nearest = nearest.min(child);
        let mut place = stack.len();
        stack.push(farther);
        while place > bottom && stack[place - 1] < farther {
            stack[place] = stack[place - 1];
            place -= 1;
        }
        stack[place] = farther;
    }
    Some(nearest as u32)
}
