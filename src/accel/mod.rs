//! Acceleration: which of many primitives a ray hits first (Suffern, ch. 22).
//!
//! Every method gives the same answer for every ray, to the last bit: the smallest `t`, and among
//! equal `t` the primitive that comes first. Two rules make that a law rather than a hope. A hit
//! counts only if its `t` lies between where the ray enters and leaves the primitive's own box (a
//! grazing hit can be rounded out of it); and the interval of a box contains, bit for bit, that of
//! each box inside it ([`Aabb::crossing`]). So no method can skip a hit that another one counts.

mod bvh;
mod list;

use serde::{Deserialize, Serialize};

use crate::math::{Aabb, Ray, SlabRay, Span};
use crate::shapes::Candidate;

/// How the primitives are searched.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Method {
    /// One after the other: the reference.
    List,
    /// A tree of boxes.
    #[default]
    Bvh,
}

/// Numbered things that one ray may hit.
pub trait Primitives {
    /// The nearest hit of primitive `index` inside the span; its `t` must not depend on the span.
    fn hit(&self, index: u32, span: Span) -> Option<Candidate>;

    /// Some hit of primitive `index` inside the span.
    fn shadow_hit(&self, index: u32, span: Span) -> Option<Candidate> {
        self.hit(index, span)
    }

    /// A box around primitive `index`, the same each time.
    fn bounds(&self, index: u32) -> Aabb;
}

/// A built acceleration structure.
#[derive(Debug)]
pub enum Accel {
    /// See [`Method::List`].
    List(list::List),
    /// See [`Method::Bvh`].
    Bvh(bvh::Bvh),
}

impl Accel {
    /// Builds for primitives with these boxes; unbounded ones are kept apart by themselves.
    pub fn build(method: Method, bounds: &[Aabb]) -> Self {
        match method {
            Method::List => Self::List(list::List::new(bounds.len())),
            Method::Bvh => Self::Bvh(bvh::Bvh::build(bounds)),
        }
    }

    /// The first hit along the ray, and of which primitive.
    pub fn nearest(
        &self,
        primitives: &impl Primitives,
        ray: &Ray,
        span: Span,
    ) -> Option<(u32, Candidate)> {
        let search = Nearest { primitives, ray: SlabRay::new(ray), span, best: None };
        match self {
            Self::List(list) => list.nearest(search),
            Self::Bvh(bvh) => bvh.nearest(search),
        }
    }

    /// Any hit along the ray, and of which primitive. Whether there is one does not depend on the
    /// method; which one is found may.
    pub fn any(
        &self,
        primitives: &impl Primitives,
        ray: &Ray,
        span: Span,
    ) -> Option<(u32, Candidate)> {
        let ray = SlabRay::new(ray);
        let test = |index| {
            let hit = primitives.shadow_hit(index, span)?;
            in_own_box(primitives, index, &ray, hit.t).then_some((index, hit))
        };
        match self {
            Self::List(list) => list.any(test),
            Self::Bvh(bvh) => bvh.any(&ray, span, test),
        }
    }
}

/// The first rule: whether `t` lies where the ray crosses the box of the primitive.
fn in_own_box(primitives: &impl Primitives, index: u32, ray: &SlabRay, t: f64) -> bool {
    let (entry, exit) = primitives.bounds(index).padded().crossing(ray);
    entry <= t && t <= exit
}

/// The search for the first hit: the best so far, and what it leaves to look at.
struct Nearest<'a, P> {
    primitives: &'a P,
    ray: SlabRay,
    span: Span,
    best: Option<(u32, Candidate)>,
}

impl<P: Primitives> Nearest<'_, P> {
    /// Looks at one primitive.
    fn consider(&mut self, index: u32) {
        let Some(hit) = self.primitives.hit(index, self.span) else { return };
        let loses_tie = self.best.is_some_and(|(i, best)| hit.t == best.t && index > i);
        if !loses_tie && in_own_box(self.primitives, index, &self.ray, hit.t) {
            self.best = Some((index, hit));
            self.span = self.span.through(hit.t); // equal t must still be seen: the first object wins
        }
    }

    /// Where the ray enters a box, if anything in it could still be the first hit.
    fn enters(&self, bounds: &Aabb) -> Option<f64> {
        let (entry, exit) = bounds.crossing(&self.ray);
        let open = entry <= exit && exit > self.span.min && entry < self.span.max;
        open.then_some(entry)
    }
}
