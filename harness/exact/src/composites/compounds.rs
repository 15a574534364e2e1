//! Compounds of three shapes.

use oracle::hard::{Family, Kind, cases};

use super::{Composite, Piece};
use crate::{oracle_shape, our_shape};
use groundtruth::accel::Method;
use groundtruth::shapes::Compound;

/// A compound has three consecutive kinds.
const KINDS: [Kind; 12] = [
    Kind::Sphere,
    Kind::Cuboid,
    Kind::Triangle,
    Kind::Cone,
    Kind::Rectangle,
    Kind::Instance,
    Kind::PartTorus,
    Kind::Disk,
    Kind::SolidCylinder,
    Kind::PartSphere,
    Kind::Annulus,
    Kind::OpenCylinder,
];

/// Three kinds of one family, and the ray that is hard for the first of them.
pub fn compound(
    family: Family,
    seed: u64,
    index: usize,
    accel: Option<Method>,
) -> Option<Composite> {
    let case = |i: usize| {
        let (kind, seed) = (KINDS[(index + i) % KINDS.len()], seed + (3 * index + i) as u64);
        cases(kind, family, seed, 1).remove(0)
    };
    let three = [case(0), case(1), case(2)];
    let ray = three[0].1.clone();
    let ours: Vec<_> = three.iter().map(|(shape, _)| our_shape(shape)).collect::<Option<_>>()?;
    let exact: Vec<_> = ours.iter().map(oracle_shape).collect::<Option<_>>()?;
    let condition = exact.iter().map(oracle::Shape::condition).fold(1.0, f64::max);
    Some(Composite {
        ours: Compound { accel, ..Compound::of(ours) }.into(),
        pieces: exact.into_iter().map(Piece::anywhere).collect(),
        ray,
        condition,
    })
}
