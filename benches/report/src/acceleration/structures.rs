//! The structures that are compared, built over the same objects.

use std::cell::Cell;
use std::sync::Arc;

use super::stages::Objects;
use groundtruth::accel::{self, Accel, Method};
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
                search(accel, ray, Span::AHEAD, counts, tested(&objects.shapes, ray, counts))
            }
            Self::Nested { outer, inner } => {
                let group = |index: u32, span| {
                    let index = index as usize;
                    let shapes = &objects.shapes[objects.groups[index].clone()];
                    search(&inner[index], ray, span, counts, tested(shapes, ray, counts))
                };
                search(outer, ray, Span::AHEAD, counts, group)
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

/// One traversal of one structure. This counts nodes and cells; `hit` counts tests of objects.
fn search(
    accel: &Accel,
    ray: &Ray,
    span: Span,
    counts: Option<&Counts>,
    hit: impl Fn(u32, Span) -> Option<Candidate>,
) -> Option<Candidate> {
    let Some(counts) = counts else {
        return accel.nearest(ray, span, &mut (), hit).map(|(_, hit)| hit);
    };
    let mut here = accel::Counts::default();
    let found = accel.nearest(ray, span, &mut here, hit);
    counts.steps.set(counts.steps.get() + here.steps);
    found.map(|(_, hit)| hit)
}

/// The hits of a ray with the objects, or with those of one group.
fn tested<'a>(
    shapes: &'a [Arc<dyn Shape>],
    ray: &'a Ray,
    counts: Option<&'a Counts>,
) -> impl Fn(u32, Span) -> Option<Candidate> + 'a {
    move |index, span| {
        if let Some(counts) = counts {
            counts.tests.set(counts.tests.get() + 1);
        }
        shapes[index as usize].hit(ray, span)
    }
}
