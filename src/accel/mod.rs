//! Acceleration structures: they find the first of many primitives that a ray hits (Suffern, ch.
//! 22).
//!
//! A structure only chooses the primitives to test; each primitive computes its own hit. So every
//! structure finds the same hit: the nearest, and of equally near hits that of the first primitive.
//! This relies on one promise: **a hit lies in its primitive's box, up to the error of the hit.**
//! Boxes are grown by more than that error ([`BoxRay`]) for rays that start within 2²⁰ sizes of the
//! scene.

mod bvh;
mod cells;
mod grid;

use crate::candidate::Candidate;
use crate::math::{Aabb, BoxRay, Ray, Span};

pub(crate) use bvh::build;
pub use cells::Cells;

/// How the primitives are searched.
#[kind(Default)]
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

/// Counts the cost of a search. `()` counts nothing and costs nothing.
pub trait Counter {
    /// A primitive was tested.
    fn test(&mut self) {}

    /// A node of a tree, or a cell of a grid, was visited.
    fn step(&mut self) {}
}

impl Counter for () {}

/// The cost of searches.
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
    /// Primitives without bounds, which every ray tests first.
    unbounded: Vec<u32>,
    bounded: Structure,
    /// The largest coordinate of the boxes.
    largest: f64,
}

/// See [`Method`].
#[derive(Debug)]
enum Structure {
    List(Vec<u32>),
    Grid(grid::Grid),
    Bvh(bvh::Bvh),
}

impl Method {
    /// All methods, the reference first.
    pub const ALL: [Self; 3] = [Self::List, Self::Grid, Self::Bvh];

    /// Its name in scene files.
    pub fn name(self) -> &'static str {
        match self {
            Self::List => "list",
            Self::Grid => "grid",
            Self::Bvh => "bvh",
        }
    }
}

impl Accel {
    /// Builds the structure for primitives with these boxes; unbounded primitives are kept
    /// separately.
    pub fn build(method: Method, bounds: &[Aabb]) -> Self {
        let count = u32::try_from(bounds.len()).expect("primitives are numbered by u32");
        let (bounded, unbounded): (Vec<u32>, Vec<u32>) =
            (0..count).partition(|&i| bounds[i as usize].is_bounded());
        let whole = bounded.iter().fold(Aabb::EMPTY, |all, &i| all.union(bounds[i as usize]));
        let largest = if bounded.is_empty() { 0.0 } else { whole.largest_coordinate() };
        let bounded = match method {
            Method::List => Structure::List(bounded),
            Method::Grid => Structure::Grid(grid::Grid::build(bounds, &bounded, grid::MULTIPLIER)),
            Method::Bvh => Structure::Bvh(bvh::Bvh::build(bounds, bounded)),
        };
        Self { unbounded, bounded, largest }
    }

    /// The first hit along the ray, and the index of its primitive; `counter` counts the cost.
    /// `hit` finds the nearest hit of the primitive of an index inside a span; its `t` must not
    /// depend on the span.
    // not inlined, it copies each hit once more, and pictures take up to a tenth longer
    #[inline]
    pub fn nearest(
        &self,
        ray: &Ray,
        mut span: Span,
        counter: &mut impl Counter,
        hit: impl Fn(u32, Span) -> Option<Candidate>,
    ) -> Option<(u32, Candidate)> {
        let mut nearest: Option<(u32, Candidate)> = None;
        self.visit(ray, span, counter, |index| {
            if let Some(hit) = hit(index, span)
                && nearest.is_none_or(|(first, best)| hit.t < best.t || index < first)
            {
                nearest = Some((index, hit));
                span = span.through(hit.t); // `t` included: an equally near hit of an earlier primitive wins
            }
            nearest.map_or(span.max, |(_, best)| best.t)
        });
        nearest
    }

    /// Any hit along the ray, and the index of its primitive; `counter` counts the cost. `hit`
    /// finds some hit of the primitive of an index. Whether there is one does not depend on the
    /// method, but which one is found may.
    #[inline]
    pub fn any<T>(
        &self,
        ray: &Ray,
        span: Span,
        counter: &mut impl Counter,
        hit: impl Fn(u32) -> Option<T>,
    ) -> Option<(u32, T)> {
        let mut found = None;
        self.visit(ray, span, counter, |index| {
            found = hit(index).map(|hit| (index, hit));
            if found.is_some() { f64::NEG_INFINITY } else { span.max }
        });
        found
    }

    /// Tests the primitives that the ray may hit. `test` returns the largest `t` of a useful hit;
    /// −∞ ends the search.
    #[inline(always)]
    fn visit<C: Counter>(
        &self,
        ray: &Ray,
        span: Span,
        counter: &mut C,
        mut test: impl FnMut(u32) -> f64,
    ) {
        let mut end = span.max;
        for &index in &self.unbounded {
            counter.test();
            end = test(index);
            if end == f64::NEG_INFINITY {
                return;
            }
        }
        let (box_ray, wanted) = (BoxRay::new(ray, self.largest), Span { max: end, ..span });
        match &self.bounded {
            Structure::List(all) => {
                for &index in all {
                    counter.test();
                    if test(index) == f64::NEG_INFINITY {
                        return;
                    }
                }
            }
            Structure::Grid(grid) => grid.visit(ray, &box_ray, wanted, counter, test),
            Structure::Bvh(bvh) => bvh.visit(&box_ray, wanted, counter, test),
        }
    }

    /// The memory of the structure itself, without its primitives.
    pub fn memory_bytes(&self) -> usize {
        let bounded = match &self.bounded {
            Structure::List(all) => size_of_val(&**all),
            Structure::Grid(grid) => grid.memory_bytes(),
            Structure::Bvh(bvh) => bvh.memory_bytes(),
        };
        size_of::<Self>() + size_of_val(&*self.unbounded) + bounded
    }
}
