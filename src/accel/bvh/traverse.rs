//! From the root to the leaves, the nearest first.
//!
//! One traversal for all searches and all kinds of primitives. It is compiled once for each
//! [`Kernel`]: only then do the kernels become part of it rather than calls.

use std::mem::MaybeUninit;

use super::build::DEEPEST;
use super::node::{Crossed, LEAF, Node, PART, Ray32, WIDTH, rounded_up};
use super::{Bvh, NOTHING};
use crate::accel::Sifted;
use crate::accel::frame::FrameRay;
use crate::accel::kernel::{Instructions, Kernel, prefetch};
use crate::accel::search::Search;

/// Makes the ray of a search.
trait Enter<S>: FnOnce(&mut S) -> Option<FrameRay> {}
impl<S, E: FnOnce(&mut S) -> Option<FrameRay>> Enter<S> for E {}

impl Bvh {
    /// Shows the search every primitive that it might still want, until it has enough.
    pub(in crate::accel) fn search<S: Search>(&self, search: &mut S) {
        if self.nodes.is_empty() || self.follow(search, 0, S::enter_from_near).is_some() {
            return;
        }
        if let Some(ray) = search.enter_from_afar() {
            self.follow_ray(search, 0, ray);
        }
    }

    /// Searches below a node with this ray, in the frame of the node; says whether the search has
    /// enough.
    fn follow_ray<S: Search>(&self, search: &mut S, root: u32, ray: FrameRay) -> bool {
        self.follow(search, root, |_| Some(ray)).unwrap_or(false)
    }

    /// The same with a ray that is made here, where it need not be handed over in memory; `None` if
    /// there is none.
    #[inline(always)]
    #[allow(unsafe_code, reason = "calls what not every processor can run")]
    fn follow<S: Search>(&self, search: &mut S, root: u32, enter: impl Enter<S>) -> Option<bool> {
        match self.kernel.instructions() {
            Instructions::Plain => self.walk(search, root, enter, Kernel::PLAIN),
            // SAFETY: a kernel is made only where the processor has its instructions
            #[cfg(target_arch = "x86_64")]
            Instructions::Avx2 => unsafe { self.walk_avx2(search, root, enter) },
            #[cfg(target_arch = "x86_64")]
            Instructions::Avx512 => unsafe { self.walk_avx512(search, root, enter) },
        }
    }

    #[cfg(target_arch = "x86_64")]
    #[target_feature(enable = "avx2,fma")]
    fn walk_avx2<S: Search>(
        &self,
        search: &mut S,
        root: u32,
        enter: impl Enter<S>,
    ) -> Option<bool> {
        self.walk(search, root, enter, Kernel::AVX2)
    }

    #[cfg(target_arch = "x86_64")]
    #[target_feature(enable = "avx2,fma,avx512f,avx512vl")]
    fn walk_avx512<S: Search>(
        &self,
        search: &mut S,
        root: u32,
        enter: impl Enter<S>,
    ) -> Option<bool> {
        self.walk(search, root, enter, Kernel::AVX512)
    }

    #[inline(always)]
    fn walk<S: Search>(
        &self,
        search: &mut S,
        root: u32,
        enter: impl Enter<S>,
        kernel: Kernel,
    ) -> Option<bool> {
        let ray = enter(search)?;
        let ray32 = Ray32::new(&ray, search.span());
        let mut last = last(&ray, search);
        let mut room = Stack::ROOM;
        let mut stack = Stack { room: &mut room, len: 0 };
        let mut sifted = Sifted::default();
        let mut next = root;
        loop {
            if next & LEAF == 0 {
                search.step();
                let node = &self.nodes[next as usize];
                let crossed = node.crossed(kernel, &ray32, last);
                if let Some(nearest) = self.push_all_but_nearest(search, node, crossed, &mut stack)
                {
                    next = nearest;
                    continue;
                }
            } else {
                let end = search.end();
                let enough = match next & PART == PART {
                    true => self.part(search, next ^ PART),
                    false => self.leaf(search, kernel, next ^ LEAF, &mut sifted),
                };
                if enough {
                    return Some(true);
                }
                if search.end() < end {
                    last = self::last(&ray, search);
                }
            }
            // equal distance is not farther: ties are settled by the order of objects
            next = loop {
                let Some(waiting) = stack.pop() else { return Some(false) };
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
        search.ray_in(&part.frame).is_some_and(|ray| self.follow_ray(search, part.root, ray))
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
    fn leaf<S: Search>(
        &self,
        search: &mut S,
        kernel: Kernel,
        number: u32,
        sifted: &mut Sifted,
    ) -> bool {
        search.sift(kernel, number, sifted);
        while sifted.sure != 0 {
            let hit = sifted.hit(sifted.sure.trailing_zeros() as usize);
            sifted.sure &= sifted.sure - 1;
            if search.take(hit.part, hit) {
                return true;
            }
        }
        while sifted.open != 0 {
            let slot = sifted.open.trailing_zeros() as usize;
            sifted.open &= sifted.open - 1;
            let index = || Some(self.leaves[number as usize][slot]).filter(|&i| i != NOTHING);
            if search.consider_in_leaf(number, slot, index) {
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

/// Children that wait: at most seven for each node above the present one.
struct Stack<'a> {
    room: &'a mut Room,
    /// So many have been written.
    len: usize,
}

/// Where children wait.
type Room = [MaybeUninit<u64>; (WIDTH - 1) * DEEPEST];

impl Stack<'_> {
    const ROOM: Room = [const { MaybeUninit::uninit() }; (WIDTH - 1) * DEEPEST];

    /// Puts a child below the nearer ones, but above `bottom`.
    #[inline(always)]
    fn insert(&mut self, bottom: usize, child: u64) {
        let mut place = self.len;
        while place > bottom && self.get(place - 1) < child {
            self.room[place].write(self.get(place - 1));
            place -= 1;
        }
        self.room[place].write(child);
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
        unsafe { self.room[place].assume_init() }
    }
}
