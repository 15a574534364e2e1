//! The structures that are compared, built over the same objects.

use std::cell::Cell;
use std::sync::Arc;

use super::stages::Objects;
use groundtruth::accel::{self, Accel, Method, Primitives};
use groundtruth::math::{Aabb, Ray, Span};
use groundtruth::shapes::{Candidate, Shape};

/// The acceleration structure of a scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Structure {
    /// One method over all objects.
    Plain(Method),
    /// One method over groups, and again within each group (section 22.7).
    Nested(Method),
}

impl Structure {
    /// All structures.
    pub fn all() -> Vec<Self> {
        let [list, grid, bvh] = Method::ALL.map(Self::Plain);
        vec![list, grid, Self::Nested(Method::Grid), bvh]
    }

    /// The name in the tables.
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

    /// The reason why it cannot be built over these objects; `None` if it can.
    pub fn unsupported(self, objects: &Objects) -> Option<&'static str> {
        let nests = matches!(self, Self::Nested(_));
        (nests && objects.groups.is_empty()).then_some("the scene has no groups to nest")
    }

    /// Builds it over the objects.
    pub fn build(self, objects: &Objects) -> BuiltStructure {
        match self {
            Self::Plain(method) => match &objects.mesh {
                Some(mesh) => BuiltStructure::Mesh(Box::new(mesh.clone().accelerated(method))),
                None => BuiltStructure::Plain(Accel::build(method, &objects.bounds)),
            },
            Self::Nested(method) => {
                let boxes = |group: &std::ops::Range<usize>| &objects.bounds[group.clone()];
                let whole = |all: &[Aabb]| all.iter().fold(Aabb::EMPTY, |a, b| a.union(*b));
                let bounds: Vec<Aabb> = objects.groups.iter().map(|g| whole(boxes(g))).collect();
                BuiltStructure::Nested {
                    outer: Accel::build(method, &bounds),
                    inner: objects.groups.iter().map(|g| Accel::build(method, boxes(g))).collect(),
                }
            }
        }
    }

    /// The structure for counting tests: for a mesh, one over its triangles as shapes, with the
    /// same boxes.
    pub fn build_counted(self, objects: &Objects) -> BuiltStructure {
        match self {
            Self::Plain(method) => BuiltStructure::Plain(Accel::build(method, &objects.bounds)),
            Self::Nested(_) => self.build(objects),
        }
    }
}

/// A built structure.
pub enum BuiltStructure {
    /// Over all objects.
    Plain(Accel),
    /// Over groups, each with one of its own.
    Nested {
        /// Over the groups.
        outer: Accel,
        /// Of each group.
        inner: Vec<Accel>,
    },
    /// A mesh, which has its own.
    Mesh(Box<dyn Shape>),
}

/// The cost of traversals.
#[derive(Debug, Default)]
pub struct Counts {
    /// The number of objects tested.
    pub tests: Cell<u64>,
    /// The number of nodes or cells visited.
    pub steps: Cell<u64>,
}

impl BuiltStructure {
    /// The distance of the first hit; adds the cost to `counts`.
    pub fn nearest(&self, objects: &Objects, ray: &Ray, counts: Option<&Counts>) -> Option<f64> {
        let hit = match self {
            Self::Mesh(shape) => return shape.hit(ray, Span::AHEAD).map(|hit| hit.t),
            Self::Plain(accel) => {
                let query = RayQuery { shapes: &objects.shapes, ray, counts };
                search(accel, &query, ray, Span::AHEAD, counts)
            }
            Self::Nested { outer, inner } => {
                let groups = GroupQuery { objects, inner, ray, counts };
                search(outer, &groups, ray, Span::AHEAD, counts)
            }
        };
        hit.map(|hit| hit.t)
    }

    /// The memory of the structure, without the objects; `None` for a mesh.
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

fn memory_bytes(accel: &Accel) -> u64 {
    accel.memory_bytes() as u64
}

/// One traversal of one structure. This counts nodes and cells; the queries count tests of objects.
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
    counts.steps.set(counts.steps.get() + here.steps);
    found.map(|(_, hit)| hit)
}

/// The objects, or those of one group, for one ray.
struct RayQuery<'a> {
    shapes: &'a [Arc<dyn Shape>],
    ray: &'a Ray,
    counts: Option<&'a Counts>,
}

impl Primitives for RayQuery<'_> {
    fn hit(&self, index: u32, span: Span) -> Option<Candidate> {
        if let Some(counts) = self.counts {
            counts.tests.set(counts.tests.get() + 1);
        }
        self.shapes[index as usize].hit(self.ray, span)
    }
}

/// The groups, for one ray.
struct GroupQuery<'a> {
    objects: &'a Objects,
    inner: &'a [Accel],
    ray: &'a Ray,
    counts: Option<&'a Counts>,
}

impl Primitives for GroupQuery<'_> {
    fn hit(&self, index: u32, span: Span) -> Option<Candidate> {
        let Self { objects, ray, counts, .. } = *self;
        let shapes = &objects.shapes[objects.groups[index as usize].clone()];
        let query = RayQuery { shapes, ray, counts };
        search(&self.inner[index as usize], &query, ray, span, counts)
    }
}
