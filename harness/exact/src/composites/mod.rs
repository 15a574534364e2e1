//! Composite shapes compared with the oracle: compounds, random spheres, lattices, meshes. The oracle
//! intersects each piece separately; the whole has the roots of all pieces.
//!
//! Used by the chapters' sweeps and by the report, like [`backward_error`] for shapes that have a formula.

mod compounds;
mod meshes;
mod spheres_and_lattices;

use std::sync::Arc;

use oracle::hard::Family;
use oracle::{Answer, Root};

use crate::backward_error::{self, ALLOWED};
use groundtruth::accel::Method;
use groundtruth::math::{Transform, UNIT_ROUNDOFF, Vector};
use groundtruth::shapes::{self, Context, Instance};

/// The kinds of composite shapes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Three shapes of different kinds.
    Compound,
    /// Up to 200 spheres, apart or crowded.
    RandomSpheres,
    /// Up to twelve copies of one shape, separate or overlapping.
    Lattice,
    /// A triangle and its three neighbours.
    Mesh,
    /// Triangles on a sphere, perhaps a bumpy one.
    TessellatedSphere,
}

impl Kind {
    /// All kinds.
    pub const ALL: [Kind; 5] =
        [Kind::Compound, Kind::RandomSpheres, Kind::Lattice, Kind::Mesh, Kind::TessellatedSphere];

    /// Case `index` of a family and a seed: a shape whose pieces are hard cases of the family, and a ray
    /// that is hard for one of them. `None` if the library refuses a piece.
    pub fn case(
        self,
        family: Family,
        seed: u64,
        index: usize,
        accel: Option<Method>,
    ) -> Option<Composite> {
        match self {
            Kind::Compound => compounds::compound(family, seed, index, accel),
            Kind::RandomSpheres => Some(spheres_and_lattices::spheres(family, seed, index, accel)),
            Kind::Lattice => spheres_and_lattices::lattice(family, seed, index, accel),
            Kind::Mesh => Some(meshes::net(family, seed, index, accel)),
            Kind::TessellatedSphere => Some(meshes::sphere(family, seed, index, accel)),
        }
    }
}

/// A composite shape for the library and for the oracle, and a ray.
#[derive(Clone, Debug)]
pub struct Composite {
    /// The library's description of the shape.
    pub ours: shapes::Kind,
    /// The oracle's pieces.
    pub pieces: Vec<Piece>,
    /// A ray that is hard for one of the pieces.
    pub ray: oracle::Ray,
    /// The condition number of its instances' matrices; 1 without instances, and for rotations.
    pub condition: f64,
}

impl Composite {
    /// The shape in an instance, and the ray transformed with it; `None` if the matrix is singular.
    pub fn instanced(self, matrix: &[[f64; 4]; 3]) -> Option<Self> {
        let steps = crate::steps(matrix)?;
        let map = Transform::from_steps(&steps).ok()?;
        let moved = |Piece { exact, .. }| {
            Piece::anywhere(oracle::Shape::Instance { matrix: map.rows(), of: Box::new(exact) })
        };
        Some(Self {
            ours: Instance::new(self.ours, steps).into(),
            pieces: self.pieces.into_iter().map(moved).collect(),
            ray: backward_error::transformed(&self.ray, &map),
            condition: oracle::condition(&map.rows()) * self.condition,
        })
    }

    /// The library's shape; `None` if the library refuses it.
    pub fn build(&self) -> Option<Arc<dyn shapes::Shape>> {
        self.ours.build(&mut Context::default()).ok()
    }

    /// The exact answer beyond `start`.
    pub fn answer(&self, start: f64) -> Answer {
        let answers: Vec<Answer> =
            self.pieces.iter().map(|piece| piece.answer(&self.ray, start)).collect();
        union(&answers, merged(&answers))
    }
}

/// The index of a piece, and a root of it.
type Of = (usize, Root);

/// The roots of all pieces, ascending.
fn merged(answers: &[Answer]) -> Vec<Of> {
    let of_piece =
        |(i, answer): (usize, &Answer)| answer.roots.clone().into_iter().map(move |root| (i, root));
    let mut roots: Vec<Of> = answers.iter().enumerate().flat_map(of_piece).collect();
    roots.sort_by(|(_, a), (_, b)| a.t.total_cmp(&b.t));
    roots
}

/// The answer for the union of pieces with these roots. It is undecided (its margin is 0) if roots of two
/// pieces are so close that rounding may change their order.
fn union(answers: &[Answer], roots: Vec<Of>) -> Answer {
    let error = |root: &Root| ALLOWED * UNIT_ROUNDOFF * root.squeeze * root.cond.max(root.t.abs());
    let is_undecided = |pair: &[Of]| {
        let [(i, a), (j, b)] = [&pair[0], &pair[1]];
        i != j && b.t - a.t <= error(a) + error(b)
    };
    let margin = answers.iter().map(|answer| answer.margin).fold(f64::INFINITY, f64::min);
    let margin = if roots.windows(2).any(is_undecided) { 0.0 } else { margin };
    Answer { roots: roots.into_iter().map(|(_, root)| root).collect(), margin }
}

/// One piece of a composite shape, and half-spaces that contain it.
#[derive(Clone, Debug)]
pub struct Piece {
    /// The oracle's shape.
    pub exact: oracle::Shape,
    /// The half-spaces `n·p ≤ d`, as `(n, d)` with `n` unit.
    within: Vec<(Vector, f64)>,
    /// The largest distance of its points from the origin.
    extent: f64,
}

impl Piece {
    /// A piece without known half-spaces.
    fn anywhere(exact: oracle::Shape) -> Self {
        Self { exact, within: Vec::new(), extent: 0.0 }
    }

    /// A piece in a box.
    fn boxed(exact: oracle::Shape, [min, max]: [[f64; 3]; 2]) -> Self {
        let axes = [Vector::X, Vector::Y, Vector::Z].into_iter().zip(min.into_iter().zip(max));
        let within = axes.flat_map(|(axis, (low, high))| [(-axis, -low), (axis, high)]).collect();
        let extent = [min, max].map(|corner| Vector::from(corner).length());
        Self { exact, within, extent: extent[0].max(extent[1]) }
    }

    /// The exact answer beyond `start`. The oracle is not called for a ray that clearly misses the
    /// half-spaces: it would still miss them after a relative change of ray and piece by 1e-11, which is
    /// far more than the rounding here.
    fn answer(&self, exact: &oracle::Ray, start: f64) -> Answer {
        const MARGIN: f64 = 1e-11;
        let ray = backward_error::ray(exact);
        let more = 4.0 * MARGIN * (Vector::from(exact.origin).length() + self.extent);
        let (mut from, mut to) = (start, f64::INFINITY);
        for &(normal, d) in &self.within {
            let (room, speed) =
                (d + more - normal.dot(ray.origin.to_vector()), normal.dot(ray.direction));
            if speed > 0.0 {
                to = to.min(room / speed);
            } else if speed < 0.0 {
                from = from.max(room / speed);
            } else if room < 0.0 {
                to = -1.0;
            }
        }
        if from > to {
            return Answer { roots: Vec::new(), margin: MARGIN };
        }
        oracle::intersect_beyond(&self.exact, exact, start)
    }
}
