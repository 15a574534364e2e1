//! Acceleration: which of many primitives a ray hits first (Suffern, ch. 22).
//!
//! Every method gives the same answer for every ray, to the last bit: the smallest `t`, and among
//! equal `t` the primitive that comes first. The counting rule makes that a law rather than a hope
//! (`frame.rs`): a hit counts only where the ray crosses the primitive's own box, and no method can
//! skip a hit that another one counts.

mod bvh;
mod cells;
mod frame;
mod grid;
mod kernel;
mod list;
mod search;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::math::{Aabb, Ray, Span};
use crate::shapes::Candidate;
use frame::Frame;
use search::{Among, Any, Nearest, Search};

pub use bvh::{LeafCost, OneByOne};
pub use cells::Cells;
pub(crate) use kernel::Instructions;
pub use kernel::Kernel;

/// How the primitives are searched.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
#[schemars(title = "acceleration methods")]
pub enum Method {
    /// One after the other: the reference.
    List,
    /// Equal cells, as in the book.
    Grid,
    /// A tree of boxes.
    #[default]
    Bvh,
}

/// Numbered things that one ray may hit.
pub trait Primitives {
    /// Whether [`Primitives::sift`] leaves few primitives open.
    const SIFTS: bool = false;

    /// The nearest hit of primitive `index` inside the span; its `t` must not depend on the span.
    fn hit(&self, index: u32, span: Span) -> Option<Candidate>;

    /// Some hit of primitive `index` inside the span.
    fn shadow_hit(&self, index: u32, span: Span) -> Option<Candidate> {
        self.hit(index, span)
    }

    /// A box around primitive `index`, the same each time.
    fn bounds(&self, index: u32) -> Aabb;

    /// Tests all primitives of a leaf ([`Accel::leaves`]) at once, as far as that goes.
    #[inline(always)]
    fn sift(&self, kernel: Kernel, leaf: u32, span: Span, sifted: &mut Sifted) {
        let _ = (kernel, leaf, span);
        (sifted.sure, sifted.open) = (0, u8::MAX);
    }

    /// Where in memory the content of a leaf begins, which will probably be asked for; anywhere if
    /// it is not worth fetching beforehand.
    #[inline(always)]
    fn place(&self, leaf: u32) -> *const u8 {
        let _ = leaf;
        std::ptr::null()
    }

    /// A primitive at its place in a leaf, where it may be nearer at hand than by its number, which
    /// `index` looks up; `None` behind the last.
    #[inline(always)]
    fn member(
        &self,
        leaf: u32,
        slot: usize,
        index: impl FnOnce() -> Option<u32>,
    ) -> Option<impl Member> {
        let _ = (leaf, slot);
        index().map(|index| Numbered { primitives: self, index })
    }
}

/// What a test of all primitives of a leaf at once found, by their places in it; in masks one bit
/// each.
#[derive(Clone, Copy, Default)]
pub struct Sifted {
    /// Those with a hit inside the span that counts, whatever the rule says (`frame.rs`).
    pub sure: u8,
    /// Those that must still be tested by themselves.
    pub open: u8,
    /// For those that are sure the numbers of the candidate: the primitive's own …
    pub part: [u32; 8],
    /// … where along the ray …
    pub t: [f64; 8],
    /// … and where on the primitive.
    pub parameters: [[f64; 8]; 2],
}

impl Sifted {
    /// The hit of one that is sure.
    #[inline(always)]
    fn hit(&self, slot: usize) -> Candidate {
        Candidate {
            part: self.part[slot % 8],
            parameters: [self.parameters[0][slot % 8], self.parameters[1][slot % 8]],
            ..Candidate::at(self.t[slot % 8])
        }
    }
}

/// One of [`Primitives`].
pub trait Member {
    /// Its number.
    fn index(&self) -> u32;
    /// See [`Primitives::hit`].
    fn hit(&self, span: Span) -> Option<Candidate>;
    /// See [`Primitives::shadow_hit`].
    fn shadow_hit(&self, span: Span) -> Option<Candidate>;
    /// See [`Primitives::bounds`].
    fn bounds(&self) -> Aabb;
}

/// A primitive that is known by its number alone.
struct Numbered<'a, P: ?Sized> {
    primitives: &'a P,
    index: u32,
}

impl<P: Primitives + ?Sized> Member for Numbered<'_, P> {
    fn index(&self) -> u32 {
        self.index
    }

    fn hit(&self, span: Span) -> Option<Candidate> {
        self.primitives.hit(self.index, span)
    }

    fn shadow_hit(&self, span: Span) -> Option<Candidate> {
        self.primitives.shadow_hit(self.index, span)
    }

    fn bounds(&self) -> Aabb {
        self.primitives.bounds(self.index)
    }
}

/// Hears what a search costs. `()` hears nothing and costs nothing.
pub trait Counter {
    /// A primitive was tested.
    fn test(&mut self) {}

    /// A node of a tree, or a cell of a grid, was visited.
    fn step(&mut self) {}
}

impl Counter for () {}

/// What searches cost.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// Primitives tested.
    pub tests: u64,
    /// Nodes or cells visited.
    pub steps: u64,
}

impl Counter for Counts {
    fn test(&mut self) {
        self.tests += 1;
    }

    fn step(&mut self) {
        self.steps += 1;
    }
}

/// A built acceleration structure.
#[derive(Debug)]
pub struct Accel {
    frame: Frame,
    /// Primitives without bounds: tested for every ray, first.
    unbounded: Vec<u32>,
    bounded: Structure,
}

/// See [`Method`].
#[derive(Debug)]
#[repr(u8)] // which it is shall be read for each ray, not worked out
enum Structure {
    List(list::List),
    Grid(grid::Grid),
    Bvh(bvh::Bvh),
}

impl Method {
    /// All methods, the reference first.
    pub const ALL: [Self; 3] = [Self::List, Self::Grid, Self::Bvh];

    /// What scene files call it.
    pub fn name(self) -> &'static str {
        match self {
            Self::List => "list",
            Self::Grid => "grid",
            Self::Bvh => "bvh",
        }
    }
}

impl Accel {
    /// Builds for primitives with these boxes; unbounded ones are kept apart by themselves.
    pub fn build(method: Method, bounds: &[Aabb]) -> Self {
        Self::build_for(method, bounds, &bvh::OneByOne, Kernel::best())
    }

    /// The same with leaves of another cost, and for another kernel than the best.
    pub fn build_for(
        method: Method,
        bounds: &[Aabb],
        leaf_cost: &impl LeafCost,
        kernel: Kernel,
    ) -> Self {
        let count = u32::try_from(bounds.len()).expect("primitives are numbered by u32");
        let (bounded, unbounded) = (0..count).partition(|&i| bounds[i as usize].is_bounded());
        let frame = Frame::around(bounds);
        let bounded = match method {
            Method::List => Structure::List(list::List::new(bounded)),
            Method::Grid => Structure::Grid(grid::Grid::build(&frame, bounds, &bounded)),
            Method::Bvh => {
                Structure::Bvh(bvh::Bvh::build(&frame, bounds, &bounded, leaf_cost, kernel))
            }
        };
        Self { frame, unbounded, bounded }
    }

    /// The first hit along the ray, and of which primitive.
    pub fn nearest(
        &self,
        primitives: &impl Primitives,
        ray: &Ray,
        span: Span,
    ) -> Option<(u32, Candidate)> {
        self.nearest_counted(primitives, ray, span, &mut ())
    }

    /// The same, and what it costs.
    pub fn nearest_counted(
        &self,
        primitives: &impl Primitives,
        ray: &Ray,
        span: Span,
        counter: &mut impl Counter,
    ) -> Option<(u32, Candidate)> {
        let search = self.first(primitives, ray, span, counter);
        search.best.map(|hit| (search.index, hit))
    }

    /// The same for primitives whose candidates say which of them they are. (To join a number to a
    /// candidate, and take it away again, is to copy it twice when it has just been written, which
    /// stalls.)
    pub fn hit_counted(
        &self,
        primitives: &impl Primitives,
        ray: &Ray,
        span: Span,
        counter: &mut impl Counter,
    ) -> Option<Candidate> {
        self.first(primitives, ray, span, counter).best
    }

    #[inline(always)]
    fn first<'a, P: Primitives, C: Counter>(
        &'a self,
        primitives: &'a P,
        ray: &'a Ray,
        span: Span,
        counter: &'a mut C,
    ) -> Nearest<'a, P, C> {
        let among = Among { primitives, frame: &self.frame, ray, framed: None };
        let mut search = Nearest { among, span, end: span.max, best: None, index: 0, counter };
        self.search(&mut search);
        search
    }

    /// Any hit along the ray, and of which primitive. Whether there is one does not depend on the
    /// method; which one is found may.
    pub fn any(
        &self,
        primitives: &impl Primitives,
        ray: &Ray,
        span: Span,
    ) -> Option<(u32, Candidate)> {
        let among = Among { primitives, frame: &self.frame, ray, framed: None };
        let mut search = Any { among, span, found: None };
        self.search(&mut search);
        search.found
    }

    /// Shows the search what it might want, first what has no bounds.
    #[inline(always)]
    fn search(&self, search: &mut impl Search) {
        if !self.unbounded.is_empty() && search.consider_unbounded(&self.unbounded) {
            return;
        }
        match &self.bounded {
            Structure::List(list) => list.search(search),
            Structure::Grid(grid) => grid.search(search),
            Structure::Bvh(bvh) => bvh.search(search),
        }
    }

    /// The leaves of a bvh: their primitives, `u32::MAX` behind the last. Other methods have none.
    pub fn leaves(&self) -> &[[u32; 8]] {
        match &self.bounded {
            Structure::Bvh(bvh) => bvh.leaves(),
            Structure::List(_) | Structure::Grid(_) => &[],
        }
    }

    /// Which hits of a primitive in this box count; `None` if none can. For those who ask each
    /// primitive for all its hits.
    pub fn counting(&self, bounds: &Aabb, ray: &Ray) -> Option<impl Fn(f64) -> bool + use<>> {
        let bounded = match bounds.is_bounded() {
            true => Some((self.frame.ray(ray)?, self.frame.boxed(bounds))),
            false => None,
        };
        let met = bounded.as_ref().is_none_or(|(ray, bounds)| {
            let (near, far) = ray.crossing(bounds);
            near <= far
        });
        met.then_some(move |t| bounded.as_ref().is_none_or(|(ray, bounds)| ray.counts(bounds, t)))
    }

    /// What the structure itself takes, without its primitives.
    pub fn memory_bytes(&self) -> usize {
        let bounded = match &self.bounded {
            Structure::List(list) => list.memory_bytes(),
            Structure::Grid(grid) => grid.memory_bytes(),
            Structure::Bvh(bvh) => bvh.memory_bytes(),
        };
        size_of::<Self>() + size_of_val(&*self.unbounded) + bounded
    }
}
