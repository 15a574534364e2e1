//! What every method does with a primitive once it has found it worth testing: the counting rule of
//! [`super::frame`], the best hit so far, and which of equal ones comes first.

use super::frame::{Frame, FrameRay};
use super::{Counter, Primitives};
use crate::math::{Aabb, Span};
use crate::shapes::Candidate;

/// A ray among primitives, and the frame in which their boxes are compared.
#[derive(Clone, Copy)]
pub struct Among<'a, P> {
    pub primitives: &'a P,
    pub frame: &'a Frame,
    pub ray: FrameRay,
}

impl<P: Primitives> Among<'_, P> {
    /// Whether a hit of this primitive counts: the rule.
    fn counts(&self, index: u32, t: f64) -> bool {
        self.ray.counts(&self.frame.boxed(&self.primitives.bounds(index)), t)
    }
}

/// The search for the first hit: the best so far, and what it leaves to look at.
pub struct Nearest<'a, P, C> {
    pub among: Among<'a, P>,
    pub span: Span,
    pub best: Option<(u32, Candidate)>,
    pub counter: &'a mut C,
}

impl<P: Primitives, C: Counter> Nearest<'_, P, C> {
    /// Looks at one primitive.
    pub fn consider(&mut self, index: u32) {
        self.counter.test();
        let Some(hit) = self.among.primitives.hit(index, self.span) else { return };
        let loses_tie = self.best.is_some_and(|(i, best)| hit.t == best.t && index > i);
        if !loses_tie && self.among.counts(index, hit.t) {
            self.best = Some((index, hit));
            self.span = self.span.through(hit.t); // equal t must still be seen: the first object wins
        }
    }

    /// Where the ray enters a box of the frame, if anything in it could still be the first hit.
    pub fn enters(&mut self, bounds: &Aabb) -> Option<f64> {
        let ray = &self.among.ray;
        let (near, far) = ray.crossing(bounds);
        let open = near <= far && far >= ray.first(self.span) && near <= ray.last(self.span);
        open.then_some(near)
    }

    /// How far away the first hit may still be, in the frame.
    pub fn farthest(&self) -> f64 {
        self.among.ray.last(self.span)
    }
}

/// The search for any hit.
pub struct Any<'a, P> {
    pub among: Among<'a, P>,
    pub span: Span,
}

impl<P: Primitives> Any<'_, P> {
    /// The hit of one primitive, if it counts.
    pub fn consider(&self, index: u32) -> Option<(u32, Candidate)> {
        let hit = self.among.primitives.shadow_hit(index, self.span)?;
        self.among.counts(index, hit.t).then_some((index, hit))
    }

    /// Whether anything in a box of the frame could be hit.
    pub fn enters(&self, bounds: &Aabb) -> bool {
        let ray = &self.among.ray;
        let (near, far) = ray.crossing(bounds);
        near <= far && far >= ray.first(self.span) && near <= ray.last(self.span)
    }
}
