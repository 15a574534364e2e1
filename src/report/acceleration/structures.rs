//! The structures that are compared, built over the same things.

use std::cell::Cell;

use super::stages::Things;
use crate::accel::{self, Accel, Method, Primitives};
use crate::math::{Aabb, Ray, Span};
use crate::shapes::{Candidate, Shape};

/// How a scene is searched.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Structure {
    /// One method over all objects.
    Plain(Method),
    /// One method over groups, and within each group again (section 22.7).
    Nested(Method),
}

impl Structure {
    /// All structures.
    pub fn all() -> Vec<Self> {
        let [list, grid, bvh] = Method::ALL.map(Self::Plain);
        vec![list, grid, Self::Nested(Method::Grid), bvh]
    }

    /// As the tables call it.
    pub fn name(self) -> String {
        match self {
            Self::Plain(method) => method.name().to_owned(),
            Self::Nested(method) => format!("nested {}", method.name()),
        }
    }

    /// Whether every ray tests every object.
    pub fn is_exhaustive(self) -> bool {
        self == Self::Plain(Method::List)
    }

    /// Why it cannot be built over these things, if so.
    pub fn unfit(self, things: &Things) -> Option<&'static str> {
        let nests = matches!(self, Self::Nested(_));
        (nests && things.groups.is_empty()).then_some("the scene has no groups to nest")
    }

    /// Builds it.
    pub fn build(self, things: &Things) -> BuiltStructure {
        match self {
            Self::Plain(method) => match &things.mesh {
                Some(mesh) => BuiltStructure::Mesh(Box::new(mesh.clone().accelerated(method))),
                None => BuiltStructure::Plain(Accel::build(method, &things.bounds)),
            },
            Self::Nested(method) => {
                let boxes = |group: &std::ops::Range<usize>| &things.bounds[group.clone()];
                let whole = |all: &[Aabb]| all.iter().fold(Aabb::EMPTY, |a, b| a.union(*b));
                let bounds: Vec<Aabb> = things.groups.iter().map(|g| whole(boxes(g))).collect();
                BuiltStructure::Nested {
                    outer: Accel::build(method, &bounds),
                    inner: things.groups.iter().map(|g| Accel::build(method, boxes(g))).collect(),
                }
            }
        }
    }

    /// The same search with its costs open to be counted: a mesh's own is hidden inside it, and the
    /// one over its triangles has the same boxes.
    pub fn build_counted(self, things: &Things) -> BuiltStructure {
        match self {
            Self::Plain(method) => BuiltStructure::Plain(Accel::build(method, &things.bounds)),
            Self::Nested(_) => self.build(things),
        }
    }
}

/// A structure, built.
pub enum BuiltStructure {
    Plain(Accel),
    Nested { outer: Accel, inner: Vec<Accel> },
    Mesh(Box<dyn Shape>),
}

/// What searches cost.
#[derive(Debug, Default)]
pub struct Counts {
    /// Objects tested.
    pub tests: Cell<u64>,
    /// Nodes or cells visited, if they are counted.
    pub steps: Cell<Option<u64>>,
}

impl BuiltStructure {
    /// The first hit, and what it costs to find, added to `counts` if there are any.
    pub fn nearest(&self, things: &Things, ray: &Ray, counts: Option<&Counts>) -> Option<f64> {
        let hit = match self {
            Self::Mesh(shape) => return shape.hit(ray, Span::AHEAD).map(|hit| hit.t),
            Self::Plain(accel) => {
                let seen = Seen { things, first: 0, ray, counts };
                search(accel, &seen, ray, Span::AHEAD, counts)
            }
            Self::Nested { outer, inner } => {
                let groups = Groups { things, inner, ray, counts };
                search(outer, &groups, ray, Span::AHEAD, counts)
            }
        };
        hit.map(|hit| hit.t)
    }

    /// What it takes in memory, without the objects; `None` for what hides it.
    pub fn memory_bytes(&self) -> Option<u64> {
        match self {
            Self::Mesh(_) => None,
            Self::Plain(accel) => Some(memory_bytes(accel)),
            Self::Nested { outer, inner } => {
                let inside: u64 = inner.iter().map(memory_bytes).sum();
                Some(memory_bytes(outer) + inside)
            }
        }
    }
}

/// What an acceleration takes.
fn memory_bytes(accel: &Accel) -> u64 {
    accel.memory_bytes() as u64
}

/// One search of one acceleration. Tests of objects are counted where they are made, nodes and cells
/// here.
fn search(
    accel: &Accel,
    primitives: &impl Primitives,
    ray: &Ray,
    span: Span,
    counts: Option<&Counts>,
) -> Option<Candidate> {
    let Some(counts) = counts else {
        return accel.nearest(primitives, ray, span).map(|(_, hit)| hit);
    };
    let mut here = accel::Counts::default();
    let found = accel.nearest_counted(primitives, ray, span, &mut here);
    counts.steps.set(Some(counts.steps.get().unwrap_or(0) + here.steps));
    found.map(|(_, hit)| hit)
}

/// The objects from `first` on, as one ray sees them.
struct Seen<'a> {
    things: &'a Things,
    first: usize,
    ray: &'a Ray,
    counts: Option<&'a Counts>,
}

impl Primitives for Seen<'_> {
    fn hit(&self, index: u32, span: Span) -> Option<Candidate> {
        if let Some(counts) = self.counts {
            counts.tests.set(counts.tests.get() + 1);
        }
        self.things.shapes[self.first + index as usize].hit(self.ray, span)
    }
}

/// The groups, as one ray sees them.
struct Groups<'a> {
    things: &'a Things,
    inner: &'a [Accel],
    ray: &'a Ray,
    counts: Option<&'a Counts>,
}

impl Primitives for Groups<'_> {
    fn hit(&self, index: u32, span: Span) -> Option<Candidate> {
        let Self { things, ray, counts, .. } = *self;
        let first = things.groups[index as usize].start;
        let seen = Seen { things, first, ray, counts };
        search(&self.inner[index as usize], &seen, ray, span, counts)
    }
}

#[cfg(test)]
mod tests {
    use super::super::stages::STAGES;
    use super::*;

    /// Law: whatever is compared gives the same distances, to the last bit, nested or not, in a mesh
    /// or over its triangles. Oracle: the list.
    #[test]
    fn structures_give_equal_answers() {
        for stage in STAGES {
            let things = (stage.things)(300, 7);
            let rays = stage.rays(24);
            let list = Structure::Plain(Method::List).build(&things);
            let expected: Vec<_> =
                rays.iter().map(|ray| list.nearest(&things, ray, None)).collect();
            let hits = expected.iter().flatten().count();
            assert!(hits > rays.len() / 8, "{}: {hits} rays hit", stage.name);
            let nested = Structure::Nested(Method::Bvh);
            let all = Structure::all().into_iter().chain([nested]);
            for structure in all.filter(|structure| structure.unfit(&things).is_none()) {
                for built in [structure.build(&things), structure.build_counted(&things)] {
                    let found = rays.iter().map(|ray| built.nearest(&things, ray, None));
                    assert!(found.eq(expected.iter().copied()), "{}: {structure:?}", stage.name);
                }
            }
        }
    }

    /// Law: a list tests every object for every ray; a tree tests few, but at least one for each ray
    /// that hits.
    #[test]
    fn tests_are_counted() {
        let things = (STAGES[0].things)(500, 7);
        let rays = STAGES[0].rays(16);
        let cost = |method| {
            let (counts, built) = (Counts::default(), Structure::Plain(method).build(&things));
            let found = |ray: &&Ray| built.nearest(&things, ray, Some(&counts)).is_some();
            let hits = rays.iter().filter(found).count() as u64;
            (hits, counts.tests.get())
        };
        let (hits, tests) = cost(Method::List);
        assert_eq!(tests, 500 * 256);
        let (same_hits, few) = cost(Method::Bvh);
        assert_eq!(same_hits, hits);
        assert!(0 < hits && hits <= few && few < 50 * 256, "{few} tests, {hits} hits");
    }
}
