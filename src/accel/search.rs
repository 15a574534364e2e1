//! What every method does with a primitive once it has found it worth testing: the counting rule of
//! [`super::frame`], the best hit so far, and which of equal ones comes first.

use super::frame::{Frame, FrameRay};
use super::kernel::Kernel;
use super::{Counter, Member, Numbered, Primitives, Sifted};
use crate::math::{Ray, Span};
use crate::shapes::Candidate;

/// A ray among primitives, and the frame in which their boxes are compared.
#[derive(Clone, Copy)]
pub struct Among<'a, P> {
    pub primitives: &'a P,
    pub frame: &'a Frame,
    pub ray: &'a Ray,
    /// The ray in the frame, when it has entered.
    pub framed: Option<FrameRay>,
}

impl<P: Primitives> Among<'_, P> {
    fn enter(&mut self) -> Option<FrameRay> {
        self.framed = self.frame.ray(self.ray);
        self.framed
    }

    #[inline(always)]
    fn ordinary_ray(&self, span: Span) -> Option<FrameRay> {
        if span.min < 0.0 {
            return None;
        }
        self.frame.ordinary_ray(self.ray)
    }

    fn ray_in(&self, frame: &Frame, span: Span) -> Option<FrameRay> {
        if span.min < 0.0 { frame.line(self.ray) } else { frame.ray(self.ray) }
    }

    /// Whether a hit of this primitive counts: the rule of the frame.
    fn counts(&mut self, member: &impl Member, t: f64) -> bool {
        let ray = self.framed.or_else(|| self.enter());
        ray.is_some_and(|ray| ray.counts(&self.frame.boxed(&member.bounds()), t))
    }
}

/// What a structure needs to know of a search, for the first hit or for any.
pub trait Search {
    /// See [`Primitives::SIFTS`].
    const SIFTS: bool;

    /// The ray in the frame of the boxes, which is asked for first; `None` if it passes beside them.
    fn enter(&mut self) -> Option<FrameRay>;

    /// The same where nothing is wanted behind the ray's origin, for an ordinary ray
    /// ([`Frame::ordinary_ray`]).
    fn ordinary_ray(&self) -> Option<FrameRay>;

    /// That frame.
    fn frame(&self) -> &Frame;

    /// The ray in some frame, with no box behind its origin that is wanted; `None` if it passes beside.
    fn ray_in(&self, frame: &Frame) -> Option<FrameRay>;

    /// Where hits are still wanted.
    fn span(&self) -> Span;

    /// No hit beyond this is wanted: known sooner than the span, which ends with the next number.
    fn end(&self) -> f64;

    /// Hears of a node or a cell.
    fn step(&mut self) {}

    /// Looks at primitives without bounds; says whether the search has enough.
    fn consider_unbounded(&mut self, indices: &[u32]) -> bool;

    /// Looks at one primitive; says whether the search has enough.
    fn consider(&mut self, index: u32) -> bool;

    /// Looks at one primitive of a leaf; see [`Primitives::member`].
    fn consider_in_leaf(
        &mut self,
        leaf: u32,
        slot: usize,
        index: impl FnOnce() -> Option<u32>,
    ) -> bool;

    /// See [`Primitives::place`].
    fn place(&self, leaf: u32) -> *const u8;

    /// See [`Primitives::sift`].
    fn sift(&self, kernel: Kernel, leaf: u32, sifted: &mut Sifted);

    /// Takes a hit that counts; says whether the search has enough.
    fn take(&mut self, index: u32, hit: Candidate) -> bool;
}

/// The search for the first hit: the best so far, and what it leaves to look at.
pub struct Nearest<'a, P, C> {
    pub among: Among<'a, P>,
    pub span: Span,
    /// No hit beyond it is wanted: the best, or the end of the span.
    pub end: f64,
    pub best: Option<Candidate>,
    /// Of which primitive that is.
    pub index: u32,
    pub counter: &'a mut C,
}

impl<P: Primitives, C: Counter> Nearest<'_, P, C> {
    #[inline(always)]
    fn look_at(&mut self, member: &impl Member) {
        self.counter.test();
        let Some(hit) = member.hit(self.span) else { return };
        let index = member.index();
        if !self.loses_tie(index, hit.t) && self.among.counts(member, hit.t) {
            self.keep(index, hit);
        }
    }

    #[inline(always)]
    fn loses_tie(&self, index: u32, t: f64) -> bool {
        self.best.is_some_and(|best| t == best.t && index > self.index)
    }

    #[inline(always)]
    fn keep(&mut self, index: u32, hit: Candidate) {
        (self.best, self.index) = (Some(hit), index);
        self.end = hit.t;
        self.span = self.span.through(hit.t); // equal t must still be seen: the first object wins
    }
}

impl<P: Primitives, C: Counter> Search for Nearest<'_, P, C> {
    const SIFTS: bool = P::SIFTS;

    fn enter(&mut self) -> Option<FrameRay> {
        self.among.enter()
    }

    #[inline(always)]
    fn ordinary_ray(&self) -> Option<FrameRay> {
        self.among.ordinary_ray(self.span)
    }

    fn frame(&self) -> &Frame {
        self.among.frame
    }

    fn ray_in(&self, frame: &Frame) -> Option<FrameRay> {
        self.among.ray_in(frame, self.span)
    }

    fn span(&self) -> Span {
        self.span
    }

    #[inline(always)]
    fn end(&self) -> f64 {
        self.end
    }

    fn step(&mut self) {
        self.counter.step();
    }

    #[inline(never)] // few scenes have any, and meshes none
    fn consider_unbounded(&mut self, indices: &[u32]) -> bool {
        for &index in indices {
            self.counter.test();
            let hit = self.among.primitives.hit(index, self.span);
            if let Some(hit) = hit.filter(|hit| !self.loses_tie(index, hit.t)) {
                self.keep(index, hit);
            }
        }
        false
    }

    fn consider(&mut self, index: u32) -> bool {
        self.look_at(&Numbered { primitives: self.among.primitives, index });
        false
    }

    #[inline(always)]
    fn consider_in_leaf(
        &mut self,
        leaf: u32,
        slot: usize,
        index: impl FnOnce() -> Option<u32>,
    ) -> bool {
        if let Some(member) = self.among.primitives.member(leaf, slot, index) {
            self.look_at(&member);
        }
        false
    }

    #[inline(always)]
    fn place(&self, leaf: u32) -> *const u8 {
        self.among.primitives.place(leaf)
    }

    #[inline(always)]
    fn sift(&self, kernel: Kernel, leaf: u32, sifted: &mut Sifted) {
        self.among.primitives.sift(kernel, leaf, self.span, sifted);
    }

    #[inline(always)]
    fn take(&mut self, index: u32, hit: Candidate) -> bool {
        self.counter.test();
        if self.span.contains(hit.t) && !self.loses_tie(index, hit.t) {
            self.keep(index, hit);
        }
        false
    }
}

/// The search for any hit, and what it has found.
pub struct Any<'a, P> {
    pub among: Among<'a, P>,
    pub span: Span,
    pub found: Option<(u32, Candidate)>,
}

impl<P: Primitives> Any<'_, P> {
    fn look_at(&mut self, member: &impl Member) -> bool {
        let hit = member.shadow_hit(self.span);
        let hit = hit.filter(|hit| self.among.counts(member, hit.t));
        self.found = hit.map(|hit| (member.index(), hit));
        self.found.is_some()
    }
}

impl<P: Primitives> Search for Any<'_, P> {
    const SIFTS: bool = P::SIFTS;

    fn enter(&mut self) -> Option<FrameRay> {
        self.among.enter()
    }

    #[inline(always)]
    fn ordinary_ray(&self) -> Option<FrameRay> {
        self.among.ordinary_ray(self.span)
    }

    fn frame(&self) -> &Frame {
        self.among.frame
    }

    fn ray_in(&self, frame: &Frame) -> Option<FrameRay> {
        self.among.ray_in(frame, self.span)
    }

    fn span(&self) -> Span {
        self.span
    }

    fn end(&self) -> f64 {
        self.span.max
    }

    #[inline(never)]
    fn consider_unbounded(&mut self, indices: &[u32]) -> bool {
        let shadow = |&index| Some((index, self.among.primitives.shadow_hit(index, self.span)?));
        self.found = indices.iter().find_map(shadow);
        self.found.is_some()
    }

    fn consider(&mut self, index: u32) -> bool {
        self.look_at(&Numbered { primitives: self.among.primitives, index })
    }

    #[inline(always)]
    fn consider_in_leaf(
        &mut self,
        leaf: u32,
        slot: usize,
        index: impl FnOnce() -> Option<u32>,
    ) -> bool {
        match self.among.primitives.member(leaf, slot, index) {
            Some(member) => self.look_at(&member),
            None => false,
        }
    }

    #[inline(always)]
    fn place(&self, leaf: u32) -> *const u8 {
        self.among.primitives.place(leaf)
    }

    #[inline(always)]
    fn sift(&self, kernel: Kernel, leaf: u32, sifted: &mut Sifted) {
        self.among.primitives.sift(kernel, leaf, self.span, sifted);
    }

    #[inline(always)]
    fn take(&mut self, index: u32, hit: Candidate) -> bool {
        self.found = Some((index, hit));
        true
    }
}
