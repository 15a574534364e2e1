//! Random spheres, and lattices of one shape.

use ask::Draw;
use oracle::Shape;
use oracle::hard::{Family, Kind, cases, rays};

use super::{Composite, Piece};
use crate::our_shape;
use groundtruth::accel::Method;
use groundtruth::shapes::{Context, Lattice, RandomSpheres, Sphere};

/// The radius of a sphere of this family.
pub fn hard_radius(family: Family, seed: u64, index: usize) -> f64 {
    match cases(Kind::Sphere, family, seed + index as u64, 1)[0].0 {
        Shape::Sphere { radius, .. } => radius,
        _ => unreachable!("a sphere is a sphere"),
    }
}

/// Spheres of a hard radius, from few and sparse to many and crowded.
pub fn spheres(family: Family, seed: u64, index: usize, accel: Option<Method>) -> Composite {
    let mut draw = Draw::case(seed + family as u64, index);
    let radius = hard_radius(family, seed, index);
    let (count, half_side) = (1 + draw.below(200) as u32, radius * draw.between(0.1, 20.0));
    let spheres = RandomSpheres { count, radius, half_side, seed: seed + index as u64, accel };
    let piece = |sphere: &Sphere| {
        let center = sphere.center.to_array();
        let corners = [-radius, radius].map(|r| center.map(|c| c + r));
        Piece::boxed(Shape::Sphere { center, radius }, corners)
    };
    let pieces: Vec<Piece> = spheres.spheres().iter().map(piece).collect();
    let aim = &pieces[draw.below(pieces.len())].exact;
    let ray = rays(aim, family, seed + index as u64, 1).remove(0);
    Composite { ours: spheres.into(), pieces, ray, condition: 1.0 }
}

/// A lattice of up to twelve copies of one shape, separate or overlapping.
pub fn lattice(
    family: Family,
    seed: u64,
    index: usize,
    accel: Option<Method>,
) -> Option<Composite> {
    const KINDS: [Kind; 5] =
        [Kind::Sphere, Kind::Cuboid, Kind::Triangle, Kind::Cone, Kind::PartSphere];
    let mut draw = Draw::case(seed + family as u64, index);
    let (shape, _) = cases(KINDS[index % KINDS.len()], family, seed + index as u64, 1).remove(0);
    let of = our_shape(&shape)?;
    let size = of.build(&mut Context::default()).ok()?.bounds().extent().length();
    let spacing = size * draw.vector(2.0);
    let counts = draw.pick(&[[3, 2, 2], [1, 4, 3], [7, 1, 1], [1, 1, 1]]);
    let copy = |index: u32| {
        let [i, j, k] =
            [index % counts[0], index / counts[0] % counts[1], index / counts[0] / counts[1]];
        let [x, y, z] = [(i, spacing.x()), (j, spacing.y()), (k, spacing.z())]
            .map(|(steps, apart)| f64::from(steps) * apart);
        let matrix = [[1.0, 0.0, 0.0, x], [0.0, 1.0, 0.0, y], [0.0, 0.0, 1.0, z]];
        Piece::anywhere(Shape::Instance { matrix, of: Box::new(shape.clone()) })
    };
    let pieces: Vec<Piece> = (0..counts.iter().product()).map(copy).collect();
    let aim = &pieces[draw.below(pieces.len())].exact;
    let ray = rays(aim, family, seed + index as u64, 1).remove(0);
    let ours = Lattice { of: Box::new(of), counts, spacing, accel };
    let condition = aim.condition();
    Some(Composite { ours: ours.into(), pieces, ray, condition })
}
