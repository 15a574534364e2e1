//! Random spheres and lattices against exact arithmetic, on rays that are hard for one of the many.

use groundtruth::accel::Method;
use groundtruth::shapes::{Context, Kind as Described, Lattice, RandomSpheres};
use groundtruth::verify::against;
use oracle::Shape;
use oracle::hard::{Family, Kind, cases, rays};

use crate::draw::Draw;
use crate::hard_cases::{Case, Piece, judge_families, merged, union};

const METHODS: [Option<Method>; 4] =
    [None, Some(Method::List), Some(Method::Grid), Some(Method::Bvh)];

/// A ray that is hard for one of the pieces, and the answer for all of them.
fn case(
    name: &str,
    (family, seed, index): (Family, u64, usize),
    draw: &mut Draw,
    (ours, pieces): (Described, Vec<Piece>),
) -> Option<Case> {
    let condition = pieces[0].exact.condition();
    let aim = &pieces[draw.below(pieces.len())].exact;
    let ray = rays(aim, family, seed + index as u64, 1).remove(0);
    let answers: Vec<_> = pieces.iter().map(|piece| piece.answer(&ray)).collect();
    let exact = union(&answers, merged(&answers));
    let name = format!("{name} {family:?} seed {seed} index {index}");
    let ours = ours.build(&mut Context::default()).ok()?;
    Some(Case { name, ours, ray: against::ray(&ray), exact, condition })
}

/// Of the radius that the family has for a sphere, few and far between up to many and crowded.
fn spheres(family: Family, seed: u64, index: usize) -> Option<Case> {
    let mut draw = Draw::case(seed + family as u64, index);
    let Shape::Sphere { radius, .. } = cases(Kind::Sphere, family, seed + index as u64, 1)[0].0
    else {
        unreachable!("a sphere is a sphere")
    };
    let (count, half_side) = (1 + draw.below(200) as u32, radius * draw.between(0.1, 20.0));
    let accel = METHODS[index % METHODS.len()];
    let spheres = RandomSpheres { count, radius, half_side, seed: index as u64, accel };
    let piece = |sphere: &groundtruth::shapes::Sphere| {
        let center = sphere.center.to_array();
        let corners = [-radius, radius].map(|r| center.map(|c| c + r));
        Piece::boxed(Shape::Sphere { center, radius }, corners)
    };
    let pieces = spheres.spheres().iter().map(piece).collect();
    case("spheres", (family, seed, index), &mut draw, (spheres.into(), pieces))
}

/// Of up to twelve copies of one of these, apart or through one another.
fn lattice(family: Family, seed: u64, index: usize) -> Option<Case> {
    const KINDS: [Kind; 5] =
        [Kind::Sphere, Kind::Cuboid, Kind::Triangle, Kind::Cone, Kind::PartSphere];
    let mut draw = Draw::case(seed + family as u64, index);
    let (shape, _) = cases(KINDS[index % KINDS.len()], family, seed + index as u64, 1).remove(0);
    let (of, _) = against::ours(&shape)?;
    let size = of.build(&mut Context::default()).ok()?.bounds().extent().length();
    let spacing = size * draw.vector(2.0);
    let counts = draw.pick(&[[3, 2, 2], [1, 4, 3], [7, 1, 1], [1, 1, 1]]);
    let mut pieces = Vec::new();
    for place in 0..counts.iter().product() {
        let [i, j, k] =
            [place % counts[0], place / counts[0] % counts[1], place / counts[0] / counts[1]];
        let [x, y, z] = [(i, spacing.x()), (j, spacing.y()), (k, spacing.z())]
            .map(|(steps, apart)| f64::from(steps) * apart);
        let matrix = [[1.0, 0.0, 0.0, x], [0.0, 1.0, 0.0, y], [0.0, 0.0, 1.0, z]];
        let exact = Shape::Instance { matrix, of: Box::new(shape.clone()) };
        pieces.push(Piece { exact, within: Vec::new(), reach: 0.0 });
    }
    let accel = METHODS[index / KINDS.len() % METHODS.len()];
    let lattice = Lattice { of: Box::new(of), counts, spacing, accel };
    case("lattice", (family, seed, index), &mut draw, (lattice.into(), pieces))
}

/// Law: random spheres have every hit of each, however they search. Oracle: the spheres in 512-bit
/// arithmetic, one by one.
#[test]
fn random_spheres_are_exact_within_their_condition() {
    judge_families(100, |family, index| spheres(family, 2270, index));
}

/// Law and oracle as above, for the copies of a lattice.
#[test]
fn lattices_are_exact_within_their_condition() {
    judge_families(100, |family, index| lattice(family, 2271, index));
}

/// Both, ten thousand cases a family.
#[test]
#[ignore = "cost: cargo test ch22 -- --ignored"]
fn random_spheres_and_lattices_thoroughly() {
    judge_families(10_000, |family, index| spheres(family, 22_700, index));
    judge_families(10_000, |family, index| lattice(family, 22_710, index));
}
