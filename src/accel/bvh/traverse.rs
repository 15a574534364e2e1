//! From the root to the leaves, the nearest first.
//!
//! One traversal for all searches and all kinds of primitives. It is compiled once for each
//! [`Kernel`]: only then do the kernels become part of it rather than calls.

use super::node::{Crossed, LEAF, Node, PART, Ray32, WIDTH, rounded_up};
use super::stack::{Room, Stack};
use super::{Bvh, NOTHING};
use crate::accel::Sifted;
use crate::accel::frame::{Frame, FrameRay};
use crate::accel::kernel::{Instructions, Kernel, prefetch};
use crate::accel::search::Search;

/// Makes the ray of a search. (A closure would be called, and not compiled for the kernel's
/// instructions.)
trait Enter<S>: Copy {
    fn enter(self, search: &mut S) -> Option<FrameRay>;
}

/// In the frame of all boxes, of an ordinary ray.
#[derive(Clone, Copy)]
struct Ordinary;

impl<S: Search> Enter<S> for Ordinary {
    #[inline(always)]
    fn enter(self, search: &mut S) -> Option<FrameRay> {
        search.ordinary_ray()
    }
}

/// In this frame, of any ray.
#[derive(Clone, Copy)]
struct Within<'a>(&'a Frame);

impl<S: Search> Enter<S> for Within<'_> {
    fn enter(self, search: &mut S) -> Option<FrameRay> {
        search.ray_in(self.0)
    }
}

/// Why a walk stops, and how many children still wait. (Together eight bytes, which are returned in a
/// register: read from memory just after they were written piece by piece, they would stall.)
enum Stop {
    /// The search has enough, or nothing waits any more.
    Ended(bool),
    /// Before those primitives of a leaf that its block leaves open.
    Open { leaf: u32, open: u8, waiting: u16 },
    /// Before a part.
    Part { number: u32, waiting: u16 },
}

impl Bvh {
    /// Shows the search every primitive that it might still want, until it has enough.
    pub(in crate::accel) fn search<S: Search>(&self, search: &mut S) {
        if self.nodes.is_empty() || self.follow(search, 0, Ordinary).is_some() {
            return;
        }
        if search.enter().is_some() {
            let frame = *search.frame();
            self.follow(search, 0, Within(&frame));
        }
    }

    /// Searches below a node; says whether the search has enough, `None` if it has no such ray.
    #[inline(always)]
    fn follow<S: Search>(&self, search: &mut S, root: u32, enter: impl Enter<S>) -> Option<bool> {
        let mut room = Stack::ROOM;
        let stack = Stack { room: &mut room, len: 0 };
        match self.walk_by_kernel(search, enter, root, stack)? {
            Stop::Ended(enough) => Some(enough),
            stop => self.go_on(search, enter, stop, &mut room),
        }
    }

    /// Does what a walk stopped before, and walks on. (Calls in the walk itself would have it keep its
    /// numbers in memory; for the same reason it makes the ray anew.)
    #[cold]
    fn go_on<S: Search>(
        &self,
        search: &mut S,
        enter: impl Enter<S>,
        mut stop: Stop,
        room: &mut Room,
    ) -> Option<bool> {
        loop {
            let (enough, waiting) = match stop {
                Stop::Ended(enough) => return Some(enough),
                Stop::Open { leaf, open, waiting } => (self.open(search, leaf, open), waiting),
                Stop::Part { number, waiting } => (self.part(search, number), waiting),
            };
            let mut stack = Stack { room, len: waiting as usize };
            let next = if enough { None } else { stack.pop() };
            let Some(next) = next else { return Some(enough) };
            stop = self.walk_by_kernel(search, enter, next as u32, stack)?;
        }
    }

    #[inline(always)]
    #[allow(unsafe_code, reason = "calls what not every processor can run")]
    fn walk_by_kernel<S: Search>(
        &self,
        search: &mut S,
        enter: impl Enter<S>,
        root: u32,
        stack: Stack,
    ) -> Option<Stop> {
        match self.kernel.instructions() {
            Instructions::Plain => self.walk_plain(search, enter, root, stack),
            // SAFETY: a kernel is made only where the processor has its instructions
            #[cfg(target_arch = "x86_64")]
            Instructions::Avx2 => unsafe { self.walk_avx2(search, enter, root, stack) },
            #[cfg(target_arch = "x86_64")]
            Instructions::Avx512 => unsafe { self.walk_avx512(search, enter, root, stack) },
        }
    }

    #[inline(never)]
    fn walk_plain<S: Search>(
        &self,
        search: &mut S,
        enter: impl Enter<S>,
        root: u32,
        stack: Stack,
    ) -> Option<Stop> {
        self.walk(search, enter, root, stack, Kernel::PLAIN)
    }

    #[cfg(target_arch = "x86_64")]
    #[target_feature(enable = "avx2,fma,bmi1")]
    fn walk_avx2<S: Search>(
        &self,
        search: &mut S,
        enter: impl Enter<S>,
        root: u32,
        stack: Stack,
    ) -> Option<Stop> {
        self.walk(search, enter, root, stack, Kernel::AVX2)
    }

    #[cfg(target_arch = "x86_64")]
    #[target_feature(enable = "avx2,fma,bmi1,avx512f,avx512vl")]
    fn walk_avx512<S: Search>(
        &self,
        search: &mut S,
        enter: impl Enter<S>,
        root: u32,
        stack: Stack,
    ) -> Option<Stop> {
        self.walk(search, enter, root, stack, Kernel::AVX512)
    }

    /// Visits what is below a node and what waits, the nearest first.
    #[inline(always)]
    fn walk<S: Search>(
        &self,
        search: &mut S,
        enter: impl Enter<S>,
        root: u32,
        mut stack: Stack,
        kernel: Kernel,
    ) -> Option<Stop> {
        let ray = enter.enter(search)?;
        let ray32 = Ray32::new(&ray, search.span());
        let mut last = last(&ray, search);
        let mut sifted = Sifted::default();
        let mut next = root;
        loop {
            if let Some(leaf) = self.descend(search, next, kernel, &ray32, last, &mut stack) {
                if leaf & PART == PART {
                    return Some(Stop::Part { number: leaf ^ PART, waiting: stack.len as u16 });
                }
                let (leaf, end) = (leaf ^ LEAF, search.end());
                search.sift(kernel, leaf, &mut sifted);
                if self.take(search, &mut sifted) {
                    return Some(Stop::Ended(true));
                }
                if sifted.open != 0 {
                    if S::SIFTS && kernel != Kernel::PLAIN {
                        let (open, waiting) = (sifted.open, stack.len as u16);
                        return Some(Stop::Open { leaf, open, waiting });
                    }
                    if self.open(search, leaf, sifted.open) {
                        return Some(Stop::Ended(true));
                    }
                }
                if search.end() < end {
                    last = self::last(&ray, search);
                }
            }
            // equal distance is not farther: ties are settled by the order of objects
            next = loop {
                let Some(waiting) = stack.pop() else { return Some(Stop::Ended(false)) };
                if f32::from_bits((waiting >> 32) as u32) <= last {
                    break waiting as u32;
                }
            };
        }
    }

    /// From a node to the nearest leaf or part below it that is crossed.
    #[inline(always)]
    fn descend<S: Search>(
        &self,
        search: &mut S,
        mut next: u32,
        kernel: Kernel,
        ray: &Ray32,
        last: f32,
        stack: &mut Stack,
    ) -> Option<u32> {
        while next & LEAF == 0 {
            search.step();
            let node = &self.nodes[next as usize];
            let crossed = node.crossed(kernel, ray, last);
            next = self.push_all_but_nearest(search, node, crossed, stack)?;
        }
        Some(next)
    }

    /// Searches a part, in its own frame.
    #[cold]
    fn part<S: Search>(&self, search: &mut S, number: u32) -> bool {
        let part = &self.parts[number as usize];
        self.follow(search, part.root, Within(&part.frame)).unwrap_or(false)
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

    /// Gives the search the hits that count; says whether it has enough.
    #[inline(always)]
    fn take<S: Search>(&self, search: &mut S, sifted: &mut Sifted) -> bool {
        while sifted.sure != 0 {
            let hit = sifted.hit(sifted.sure.trailing_zeros() as usize);
            sifted.sure &= sifted.sure - 1;
            if search.take(hit.part, hit) {
                return true;
            }
        }
        false
    }

    /// Shows the search those primitives of a leaf that its block leaves open; says whether it has
    /// enough.
    #[inline(always)]
    fn open<S: Search>(&self, search: &mut S, leaf: u32, mut open: u8) -> bool {
        while open != 0 {
            let slot = open.trailing_zeros() as usize;
            open &= open - 1;
            let index = || Some(self.leaves[leaf as usize][slot]).filter(|&i| i != NOTHING);
            if search.consider_in_leaf(leaf, slot, index) {
                return true;
            }
        }
        false
    }
}

/// How far away in the frame a hit may still be, rounded up; before all of it where it is negative.
#[inline(always)]
fn last(ray: &FrameRay, search: &impl Search) -> f32 {
    rounded_up(ray.last(search.end()))
}
