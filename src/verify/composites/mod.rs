//! Shapes made of many, beside the oracle's: compounds, random spheres, lattices, meshes. The oracle
//! answers for each of the pieces by itself; the whole has the roots of all.
//!
//! Used by the chapters' sweeps and by the report, as [`backward_error`] is for shapes that have a formula.

mod compounds;
mod meshes;
mod spheres_and_lattices;

use std::sync::Arc;

use oracle::hard::Family;
use oracle::{Answer, Root};

use super::backward_error::{self, ALLOWED};
use crate::accel::Method;
use crate::math::{Transform, UNIT_ROUNDOFF, Vector};
use crate::shapes::{self, Context, Instance};

/// The kinds of shapes that are made of many.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Three shapes of different kinds.
    Compound,
    /// Up to 200 spheres, apart or crowded.
    RandomSpheres,
    /// Up to twelve copies of one shape, apart or through one another.
    Lattice,
    /// A triangle and its three neighbours.
    Mesh,
    /// Triangles on a sphere, perhaps a bumpy one.
    TessellatedSphere,
}

impl Kind {
    /// All of them.
    pub const ALL: [Kind; 5] =
        [Kind::Compound, Kind::RandomSpheres, Kind::Lattice, Kind::Mesh, Kind::TessellatedSphere];

    /// The case of this number, of a family under a seed: a shape whose pieces are hard as the family
    /// says, searched by this method, and a ray that is hard for one of them. `None` where the
    /// library refuses a piece.
    pub fn case(
        self,
        family: Family,
        seed: u64,
        index: usize,
        accel: Option<Method>,
    ) -> Option<Case> {
        match self {
            Kind::Compound => compounds::compound(family, seed, index, accel),
            Kind::RandomSpheres => Some(spheres_and_lattices::spheres(family, seed, index, accel)),
            Kind::Lattice => spheres_and_lattices::lattice(family, seed, index, accel),
            Kind::Mesh => Some(meshes::net(family, seed, index, accel)),
            Kind::TessellatedSphere => Some(meshes::sphere(family, seed, index, accel)),
        }
    }
}

/// A shape of many pieces in both forms, and a ray.
#[derive(Clone, Debug)]
pub struct Case {
    /// The library's description of it.
    pub ours: shapes::Kind,
    /// The oracle's: all of these.
    pub pieces: Vec<Piece>,
    /// Hard for one of the pieces.
    pub ray: oracle::Ray,
    /// Of the matrices of its instances; 1 without, and where they only turn.
    pub condition: f64,
}

impl Case {
    /// The same in an instance, and the ray moved with it; `None` if the matrix is singular.
    pub fn instanced(self, matrix: &[[f64; 4]; 3]) -> Option<Self> {
        let steps = backward_error::steps(matrix)?;
        let map = Transform::from_steps(&steps).ok()?;
        let moved = |Piece { exact, .. }| {
            Piece::anywhere(oracle::Shape::Instance { matrix: map.rows(), of: Box::new(exact) })
        };
        Some(Self {
            ours: Instance::new(self.ours, steps).into(),
            pieces: self.pieces.into_iter().map(moved).collect(),
            ray: oracle::Ray {
                origin: map.point(self.ray.origin.into()).into(),
                direction: map.vector(self.ray.direction.into()).into(),
            },
            condition: oracle::condition(&map.rows()) * self.condition,
        })
    }

    /// Built for rays; `None` where the library refuses it.
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

/// A root, and which of the pieces it is of.
type Of = (usize, Root);

/// The roots of several shapes that are one, ascending.
fn merged(answers: &[Answer]) -> Vec<Of> {
    let of_piece =
        |(i, answer): (usize, &Answer)| answer.roots.clone().into_iter().map(move |root| (i, root));
    let mut roots: Vec<Of> = answers.iter().enumerate().flat_map(of_piece).collect();
    roots.sort_by(|(_, a), (_, b)| a.t.total_cmp(&b.t));
    roots
}

/// The answer for several shapes that are one and have these roots. It is open, with a margin of 0,
/// where roots of two shapes are so close that rounding may change their order.
fn union(answers: &[Answer], roots: Vec<Of>) -> Answer {
    let doubt = |root: &Root| ALLOWED * UNIT_ROUNDOFF * root.squeeze * root.cond.max(root.t.abs());
    let is_open = |pair: &[Of]| {
        let [(i, a), (j, b)] = [&pair[0], &pair[1]];
        i != j && b.t - a.t <= doubt(a) + doubt(b)
    };
    let margin = answers.iter().map(|answer| answer.margin).fold(f64::INFINITY, f64::min);
    let margin = if roots.windows(2).any(is_open) { 0.0 } else { margin };
    Answer { roots: roots.into_iter().map(|(_, root)| root).collect(), margin }
}

/// One of many shapes that are one, and half-spaces around it.
#[derive(Clone, Debug)]
pub struct Piece {
    /// Its form.
    pub exact: oracle::Shape,
    /// `n` and `d` of unit length of all with `n·p ≤ d`.
    within: Vec<(Vector, f64)>,
    /// The farthest of its points from the origin.
    reach: f64,
}

impl Piece {
    /// A shape of which nothing else is known.
    fn anywhere(exact: oracle::Shape) -> Self {
        Self { exact, within: Vec::new(), reach: 0.0 }
    }

    /// A shape in a box.
    fn boxed(exact: oracle::Shape, [min, max]: [[f64; 3]; 2]) -> Self {
        let axes = [Vector::X, Vector::Y, Vector::Z].into_iter().zip(min.into_iter().zip(max));
        let within = axes.flat_map(|(axis, (low, high))| [(-axis, -low), (axis, high)]).collect();
        let reach = [min, max].map(|corner| Vector::from(corner).length());
        Self { exact, within, reach: reach[0].max(reach[1]) }
    }

    /// The exact answer beyond `start`. A ray that passes the half-spaces by, and does so wherever a
    /// relative change by 1e-11 may move it and the piece, is not asked: it is farther from them than
    /// the rounding here.
    fn answer(&self, exact: &oracle::Ray, start: f64) -> Answer {
        const MARGIN: f64 = 1e-11;
        let ray = backward_error::ray(exact);
        let more = 4.0 * MARGIN * (Vector::from(exact.origin).length() + self.reach);
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
