//! The structures that are compared, built over the same objects.

use std::cell::Cell;
use std::ops::Range;
use std::sync::Arc;

use super::stages::Objects;
use groundtruth::accel::{Accel, Counter, Method};
use groundtruth::math::{Aabb, Ray, Span};
use groundtruth::shapes::{Candidate, Shape, TriangleMesh};

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
    pub const ALL: [Self; 4] = [
        Self::Plain(Method::List),
        Self::Plain(Method::Grid),
        Self::Nested(Method::Grid),
        Self::Plain(Method::Bvh),
    ];

    /// The name in the tables.
    pub fn name(self) -> String {
        match self {
            Self::Plain(method) => method.name().to_owned(),
            Self::Nested(method) => format!("nested {}", method.name()),
        }
    }

    /// Builds it over the objects; `mesh` has its own, which counts no tests.
    pub fn build(self, objects: &Objects, mesh: Option<&TriangleMesh>) -> BuiltStructure {
        let over = |group: &Range<usize>| &objects.bounds[group.clone()];
        match self {
            Self::Plain(method) => match mesh {
                Some(mesh) => BuiltStructure::Mesh(Box::new(mesh.clone().accelerated(method))),
                None => BuiltStructure::Plain(Accel::build(method, &objects.bounds)),
            },
            Self::Nested(method) => {
                let whole = |group| over(group).iter().fold(Aabb::EMPTY, |a, b| a.union(*b));
                let bounds: Vec<Aabb> = objects.groups.iter().map(whole).collect();
                let of_group = |group| Accel::build(method, over(group));
                BuiltStructure::Nested {
                    outer: Accel::build(method, &bounds),
                    inner: objects.groups.iter().map(of_group).collect(),
                }
            }
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

/// The cost of searches.
#[derive(Debug, Default)]
pub struct Counts {
    /// The number of objects tested.
    pub tests: Cell<u64>,
    /// The number of nodes or cells visited.
    pub steps: Cell<u64>,
}

impl Counter for &Counts {
    fn test(&mut self) {
        self.tests.update(|tests| tests + 1);
    }

    fn step(&mut self) {
        self.steps.update(|steps| steps + 1);
    }
}

impl BuiltStructure {
    /// The distance of the first hit. The cost of a search among groups goes to the first counter,
    /// that among objects to the second.
    pub fn nearest<C: Counter + Copy>(
        &self,
        objects: &Objects,
        ray: &Ray,
        [mut groups, within]: [C; 2],
    ) -> Option<f64> {
        let hit = match self {
            Self::Mesh(shape) => return shape.hit(ray, Span::AHEAD).map(|hit| hit.t),
            Self::Plain(accel) => first_of(&objects.shapes, accel, (ray, Span::AHEAD), within),
            Self::Nested { outer, inner } => {
                let of_group = |index: u32, span| {
                    let index = index as usize;
                    let shapes = &objects.shapes[objects.groups[index].clone()];
                    first_of(shapes, &inner[index], (ray, span), within)
                };
                outer.nearest(ray, Span::AHEAD, &mut groups, of_group).map(|(_, hit)| hit)
            }
        };
        hit.map(|hit| hit.t)
    }

    /// The memory of the structure, without the objects; `None` for a mesh.
    pub fn memory_bytes(&self) -> Option<u64> {
        let (outer, inner) = match self {
            Self::Mesh(_) => return None,
            Self::Plain(accel) => (accel, &[][..]),
            Self::Nested { outer, inner } => (outer, &inner[..]),
        };
        Some(inner.iter().chain([outer]).map(|accel| accel.memory_bytes() as u64).sum())
    }
}

/// The first hit with one of these shapes.
fn first_of(
    shapes: &[Arc<dyn Shape>],
    accel: &Accel,
    (ray, span): (&Ray, Span),
    mut counter: impl Counter,
) -> Option<Candidate> {
    let hit = |index: u32, span| shapes[index as usize].hit(ray, span);
    accel.nearest(ray, span, &mut counter, hit).map(|(_, hit)| hit)
}
