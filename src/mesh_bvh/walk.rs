//! Traversal of the tree from the root to the leaves, the nearest first.
//!
//! The traversal is compiled once for each [`Kernel`], because only then are the kernels inlined.
//! (A closure would not be compiled for the kernel's instructions.)

use super::MeshBvh;
use super::block::Found;
use super::kernel::{Instructions, Kernel, prefetch};
use super::node::{Crossed, LEAF, Node, Ray32, WIDTH, rounded_up};
use super::space::SpaceRay;
use super::stack::{Room, Stack};
use crate::accel::Counter;
use crate::candidate::Candidate;
use crate::math::watertight::ShearedRay;
use crate::math::{Ray, Span};

/// A search along a ray for the nearest hit, or for any hit if `ANY`.
pub struct Walk<'a, C, const ANY: bool> {
    ray: &'a Ray,
    sheared: ShearedRay,
    /// Hits inside it can still replace the one found.
    span: Span,
    /// The `t` of the hit found, or the end of the span: available sooner than `span.max`, which is
    /// the next larger number.
    end: f64,
    pub found: Option<Candidate>,
    counter: &'a mut C,
}

impl<'a, C: Counter, const ANY: bool> Walk<'a, C, ANY> {
    #[inline(always)]
    pub fn new(ray: &'a Ray, span: Span, counter: &'a mut C) -> Self {
        let sheared = ShearedRay::new(ray);
        Self { ray, sheared, span, end: span.max, found: None, counter }
    }

    /// Keeps a hit inside the span if it is the nearest; of equally near hits, that of the first
    /// triangle. Returns whether the search is finished.
    #[inline(always)]
    fn keep_if_first(&mut self, hit: Candidate) -> bool {
        let comes_after = |best: Candidate| hit.t == best.t && hit.part > best.part;
        if ANY || !self.found.is_some_and(comes_after) {
            self.found = Some(hit);
            self.end = hit.t;
            self.span = self.span.through(hit.t); // a hit with equal `t` must still be found
        }
        ANY
    }

    /// The largest distance of a useful hit in the tree's space, rounded up; if it is negative, no
    /// hit is useful.
    #[inline(always)]
    fn last(&self, ray: &SpaceRay) -> f32 {
        rounded_up(ray.last(self.end))
    }
}

/// Why a walk stops. (Eight bytes, returned in a register: a return through memory would stall,
/// because it is read whole just after it was written in pieces.)
enum Stop {
    /// The search is finished, or the stack is empty.
    Ended,
    /// Some triangles of a block are undecided; `waiting` children are on the stack.
    Undecided { leaf: u32, slots: u8, waiting: u16 },
}

impl MeshBvh {
    /// Tests every triangle that may have a hit in the search's span, until the search is finished.
    #[inline(always)]
    pub(super) fn search<C: Counter, const ANY: bool>(&self, search: &mut Walk<'_, C, ANY>) {
        let mut room = Stack::ROOM;
        let stack = Stack { room: &mut room, len: 0 };
        if let Stop::Undecided { leaf, slots, waiting } = self.walk_by_kernel(search, 0, stack) {
            self.go_on(search, (leaf, slots, waiting), &mut room);
        }
    }

    /// Tests the undecided triangles, then continues the walk. (A call inside the walk would force
    /// its registers into memory; for the same reason each walk prepares the ray again.)
    #[cold]
    fn go_on<C: Counter, const ANY: bool>(
        &self,
        search: &mut Walk<'_, C, ANY>,
        (mut leaf, mut slots, mut waiting): (u32, u8, u16),
        room: &mut Room,
    ) {
        loop {
            if self.decide(search, leaf, slots) {
                return;
            }
            let mut stack = Stack { room, len: waiting as usize };
            let Some(next) = stack.pop() else { return };
            match self.walk_by_kernel(search, next as u32, stack) {
                Stop::Ended => return,
                Stop::Undecided { leaf: l, slots: s, waiting: w } => {
                    (leaf, slots, waiting) = (l, s, w);
                }
            }
        }
    }

    #[inline(always)]
    #[allow(unsafe_code, reason = "calls what not every processor can run")]
    fn walk_by_kernel<C: Counter, const ANY: bool>(
        &self,
        search: &mut Walk<'_, C, ANY>,
        from: u32,
        stack: Stack,
    ) -> Stop {
        match self.kernel.instructions() {
            Instructions::Plain => self.walk_plain(search, from, stack),
            // SAFETY: a kernel is made only where the processor has its instructions
            #[cfg(target_arch = "x86_64")]
            Instructions::Avx2 => unsafe { self.walk_avx2(search, from, stack) },
            #[cfg(target_arch = "x86_64")]
            Instructions::Avx512 => unsafe { self.walk_avx512(search, from, stack) },
        }
    }

    #[inline(never)]
    fn walk_plain<C: Counter, const ANY: bool>(
        &self,
        search: &mut Walk<'_, C, ANY>,
        from: u32,
        stack: Stack,
    ) -> Stop {
        self.walk(search, from, stack, Kernel::PLAIN)
    }

    #[cfg(target_arch = "x86_64")]
    #[target_feature(enable = "avx2,fma,bmi1")]
    fn walk_avx2<C: Counter, const ANY: bool>(
        &self,
        search: &mut Walk<'_, C, ANY>,
        from: u32,
        stack: Stack,
    ) -> Stop {
        self.walk(search, from, stack, Kernel::AVX2)
    }

    #[cfg(target_arch = "x86_64")]
    #[target_feature(enable = "avx2,fma,bmi1,avx512f,avx512vl")]
    fn walk_avx512<C: Counter, const ANY: bool>(
        &self,
        search: &mut Walk<'_, C, ANY>,
        from: u32,
        stack: Stack,
    ) -> Stop {
        self.walk(search, from, stack, Kernel::AVX512)
    }

    /// Visits the subtree of a node, then the children on the stack, the nearest first.
    #[inline(always)]
    fn walk<C: Counter, const ANY: bool>(
        &self,
        search: &mut Walk<'_, C, ANY>,
        from: u32,
        mut stack: Stack,
        kernel: Kernel,
    ) -> Stop {
        let Some(ray) = self.space.ray(search.ray, search.span) else { return Stop::Ended };
        let ray32 = Ray32::new(&ray, search.span);
        let mut last = search.last(&ray);
        let mut found = Found::default();
        let mut next = from;
        loop {
            if let Some(leaf) = self.descend(search.counter, next, kernel, &ray32, last, &mut stack)
            {
                let (leaf, end) = (leaf ^ LEAF, search.end);
                self.blocks[leaf as usize].test(kernel, &search.sheared, search.span, &mut found);
                while found.certain != 0 {
                    let hit = found.hit(found.certain.trailing_zeros() as usize);
                    found.certain &= found.certain - 1;
                    search.counter.test();
                    if search.span.contains(hit.t) && search.keep_if_first(hit) {
                        return Stop::Ended;
                    }
                }
                if found.undecided != 0 {
                    let slots = found.undecided;
                    if kernel != Kernel::PLAIN {
                        return Stop::Undecided { leaf, slots, waiting: stack.len as u16 };
                    }
                    if self.decide(search, leaf, slots) {
                        return Stop::Ended;
                    }
                }
                if search.end < end {
                    last = search.last(&ray);
                }
            }
            // a child at equal distance is visited: ties are settled by the order of triangles
            next = loop {
                let Some(waiting) = stack.pop() else { return Stop::Ended };
                if f32::from_bits((waiting >> 32) as u32) <= last {
                    break waiting as u32;
                }
            };
        }
    }

    /// Descends from a node by its nearest crossed children to a leaf.
    #[inline(always)]
    fn descend(
        &self,
        counter: &mut impl Counter,
        mut next: u32,
        kernel: Kernel,
        ray: &Ray32,
        last: f32,
        stack: &mut Stack,
    ) -> Option<u32> {
        while next & LEAF == 0 {
            counter.step();
            let node = &self.nodes[next as usize];
            let crossed = node.crossed(kernel, ray, last);
            next = self.push_all_but_nearest(node, crossed, stack)?;
        }
        Some(next)
    }

    /// The nearest of the children that are crossed; the others go to the stack, the nearest on
    /// top. All are fetched from memory ahead of their use.
    #[inline(always)]
    fn push_all_but_nearest(
        &self,
        node: &Node,
        (mut mask, near): Crossed,
        stack: &mut Stack,
    ) -> Option<u32> {
        if mask == 0 {
            return None;
        }
        let others = mask & (mask - 1);
        if others == 0 {
            // without its distance: the next node would have to wait for it
            return Some(node.children[mask.trailing_zeros() as usize % WIDTH]);
        }
        let bottom = stack.len;
        let mut nearest = first_child(node, mask, &near);
        self.fetch(nearest as u32);
        mask = others;
        while mask != 0 {
            let child = first_child(node, mask, &near);
            mask &= mask - 1;
            self.fetch(child as u32);
            stack.insert(bottom, nearest.max(child));
            nearest = nearest.min(child);
        }
        Some(nearest as u32)
    }

    /// Prefetches a node or block. Both addresses are computed: a branch between them is hard to
    /// predict.
    #[inline(always)]
    fn fetch(&self, child: u32) {
        let node = self.nodes.as_ptr().wrapping_add(child as usize).cast();
        let block = self.blocks.as_ptr().wrapping_add((child & !LEAF) as usize).cast();
        prefetch(if child & LEAF == 0 { node } else { block });
    }

    /// Tests these triangles of a block one by one; returns whether the search is finished.
    #[inline(always)]
    fn decide<C: Counter, const ANY: bool>(
        &self,
        search: &mut Walk<'_, C, ANY>,
        leaf: u32,
        mut slots: u8,
    ) -> bool {
        let block = &self.blocks[leaf as usize];
        while slots != 0 {
            let slot = slots.trailing_zeros() as usize;
            slots &= slots - 1;
            search.counter.test();
            if let Some(hit) = block.hit(slot, &search.sheared, search.span)
                && search.keep_if_first(hit)
            {
                return true;
            }
        }
        false
    }
}

/// The first child of a mask as one number: its distance, which is not negative, in the upper bits
/// and its index in the lower. So the numbers are ordered by distance.
#[inline(always)]
fn first_child(node: &Node, mask: u32, near: &[f32; WIDTH]) -> u64 {
    let slot = mask.trailing_zeros() as usize % WIDTH;
    u64::from(near[slot].to_bits()) << 32 | u64::from(node.children[slot])
}
