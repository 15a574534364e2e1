//! From the root to the leaves, the nearest first.
//!
//! One traversal for all searches and all kinds of primitives. It is compiled once for each
//! [`Kernel`]: only then do the kernels become part of it rather than calls.

use std::mem::MaybeUninit;

use super::build::DEEPEST;
use super::node::{Crossed, LEAF, Node, PART, Ray32, WIDTH, rounded_up};
use super::{Bvh, NOTHING};
use crate::accel::frame::FrameRay;
use crate::accel::kernel::{Instructions, Kernel, prefetch};
use crate::accel::search::Search;

/// Where a walk begins.
struct Way {
    /// The ray in the frame of a part of the tree; as the search has it if `None`.
    within: Option<FrameRay>,
    root: u32,
}

impl Way {
    /// The ray in the frame of the nodes. It is not copied: numbers stored one by one and loaded as
    /// vectors stall the processor.
    #[inline(always)]
    fn ray<'a>(&'a self, search: &'a impl Search) -> &'a FrameRay {
        match &self.within {
            Some(ray) => ray,
            None => search.ray(),
        }
    }
}

impl Bvh {
    /// Shows the search every primitive that it might still want, until it has enough.
    pub(in crate::accel) fn search<S: Search>(&self, search: &mut S) {
        if !self.nodes.is_empty() {
            self.follow(search, &Way { within: None, root: 0 });
        }
    }

    /// Searches below a node; says whether the search has enough.
    #[allow(unsafe_code, reason = "calls what not every processor can run")]
    fn follow<S: Search>(&self, search: &mut S, way: &Way) -> bool {
        match self.kernel.instructions() {
            Instructions::Plain => self.walk(search, way, Kernel::PLAIN),
            // SAFETY: a kernel is made only where the processor has its instructions
            #[cfg(target_arch = "x86_64")]
            Instructions::Avx2 => unsafe { self.walk_avx2(search, way) },
            #[cfg(target_arch = "x86_64")]
            Instructions::Avx512 => unsafe { self.walk_avx512(search, way) },
        }
    }

    #[cfg(target_arch = "x86_64")]
    #[target_feature(enable = "avx2,fma")]
    fn walk_avx2<S: Search>(&self, search: &mut S, way: &Way) -> bool {
        self.walk(search, way, Kernel::AVX2)
    }

    #[cfg(target_arch = "x86_64")]
    #[target_feature(enable = "avx2,fma,avx512f,avx512vl")]
    fn walk_avx512<S: Search>(&self, search: &mut S, way: &Way) -> bool {
        self.walk(search, way, Kernel::AVX512)
    }

    #[inline(always)]
    fn walk<S: Search>(&self, search: &mut S, way: &Way, kernel: Kernel) -> bool {
        let ray = Ray32::new(way.ray(search), search.span());
        let mut last = last(search, way);
        let mut stack = Stack::new();
        let mut next = way.root;
        loop {
            if next & LEAF == 0 {
                search.step();
                let node = &self.nodes[next as usize];
                let crossed = node.crossed(kernel, &ray, last);
                if let Some(nearest) = self.push_all_but_nearest(search, node, crossed, &mut stack)
                {
                    next = nearest;
                    continue;
                }
            } else {
                let enough = match next & PART == PART {
                    true => self.part(search, next ^ PART),
                    false => self.leaf(search, kernel, next ^ LEAF),
                };
                if enough {
                    return true;
                }
                last = self::last(search, way);
            }
            // equal distance is not farther: ties are settled by the order of objects
            next = loop {
                let Some(waiting) = stack.pop() else { return false };
                if f32::from_bits((waiting >> 32) as u32) <= last {
                    break waiting as u32;
                }
            };
        }
    }

    /// Searches a part, in its own frame.
    #[cold]
    fn part<S: Search>(&self, search: &mut S, number: u32) -> bool {
        let part = &self.parts[number as usize];
        let Some(ray) = search.ray_in(&part.frame) else { return false };
        self.follow(search, &Way { within: Some(ray), root: part.root })
    }

    /// The nearest of the children that are crossed; the others go to the stack, the nearest on
    /// top. All are brought nearer in memory.
    #[inline(always)]
    fn push_all_but_nearest<S: Search>(
        &self,
        search: &S,
        node: &Node,
        (mut mask, near): Crossed,
        stack: &mut Stack,
    ) -> Option<u32> {
        if mask == 0 {
            return None;
        }
        let others = mask & (mask - 1);
        if others == 0 {
            // without its distance, for which the next node would have to wait
            return Some(node.children[mask.trailing_zeros() as usize % WIDTH]);
        }
        let bottom = stack.len;
        let mut nearest = self.first_child(node, mask, &near);
        self.expect(search, nearest as u32);
        mask = others;
        while mask != 0 {
            let child = self.first_child(node, mask, &near);
            mask &= mask - 1;
            self.expect(search, child as u32);
            stack.insert(bottom, nearest.max(child));
            nearest = nearest.min(child);
        }
        Some(nearest as u32)
    }

    /// A child as one number, its distance (which is not negative) above and its place below, so
    /// that these numbers are in order as distances are.
    #[inline(always)]
    fn first_child(&self, node: &Node, mask: u32, near: &[f32; WIDTH]) -> u64 {
        let slot = mask.trailing_zeros() as usize % WIDTH;
        u64::from(near[slot].to_bits()) << 32 | u64::from(node.children[slot])
    }

    /// Has what will be visited brought nearer in memory. Both addresses are worked out, because
    /// which of them it is can hardly be predicted.
    #[inline(always)]
    fn expect<S: Search>(&self, search: &S, child: u32) {
        let node = self.nodes.as_ptr().wrapping_add(child as usize).cast();
        let leaf = search.place(child & !LEAF);
        prefetch(if child & LEAF == 0 { node } else { leaf });
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

/// How far away in the frame a hit may still be, rounded up; before all of it where it is negative.
#[inline(always)]
fn last(search: &impl Search, way: &Way) -> f32 {
    rounded_up(way.ray(search).last(search.span()))
}

/// Children that wait: at most seven for each node above the present one.
struct Stack {
    children: [MaybeUninit<u64>; (WIDTH - 1) * DEEPEST],
    /// So many have been written.
    len: usize,
}

impl Stack {
    #[inline(always)]
    fn new() -> Self {
        Self { children: [const { MaybeUninit::uninit() }; (WIDTH - 1) * DEEPEST], len: 0 }
    }

    /// Puts a child below the nearer ones, but above `bottom`.
    #[inline(always)]
    fn insert(&mut self, bottom: usize, child: u64) {
        let mut place = self.len;
        while place > bottom && self.get(place - 1) < child {
            self.children[place].write(self.get(place - 1));
            place -= 1;
        }
        self.children[place].write(child);
        self.len += 1;
    }

    #[inline(always)]
    fn pop(&mut self) -> Option<u64> {
        self.len = self.len.checked_sub(1)?;
        Some(self.get(self.len))
    }

    #[inline(always)]
    #[allow(unsafe_code, reason = "clearing the stack for each ray would take a tenth of its time")]
    fn get(&self, place: usize) -> u64 {
        // SAFETY: places below `len` have been written, and no other is read
        unsafe { self.children[place].assume_init() }
    }
}
