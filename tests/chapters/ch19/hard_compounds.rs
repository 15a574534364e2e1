//! Compounds of three shapes against exact arithmetic, on hard cases.

use groundtruth::accel::Method;
use groundtruth::shapes::{Compound, Context, Kind as Described};
use groundtruth::verify::against;
use oracle::hard::{Family, Kind, cases};

use crate::hard_cases::{Case, judge_families, merged, union};

/// Of each three in a row.
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
const METHODS: [Option<Method>; 4] =
    [None, Some(Method::List), Some(Method::Grid), Some(Method::Bvh)];

/// Three kinds of one family, and the ray that is hard for the first of them.
fn compound(family: Family, seed: u64, index: usize) -> Option<Case> {
    let case = |i: usize| {
        let (kind, seed) = (KINDS[(index + i) % KINDS.len()], seed + (3 * index + i) as u64);
        cases(kind, family, seed, 1).remove(0)
    };
    let three = [case(0), case(1), case(2)];
    let ray = three[0].1.clone();
    let [a, b, c] = three.map(|(shape, _)| against::ours(&shape));
    let described: Vec<(Described, oracle::Shape)> = vec![a?, b?, c?];
    let condition = described.iter().map(|(_, shape)| shape.condition()).fold(1.0, f64::max);
    let answers = [0, 1, 2].map(|i| oracle::intersect(&described[i].1, &ray));
    let exact = union(&answers, merged(&answers));
    let accel = METHODS[index / KINDS.len() % METHODS.len()];
    let shapes = described.into_iter().map(|(shape, _)| shape);
    let compound = Described::from(Compound { accel, ..Compound::of(shapes) });
    let ours = compound.build(&mut Context::default()).ok()?;
    let name = format!("compound {family:?} seed {seed} index {index}");
    Some(Case { name, ours, ray: against::ray(&ray), exact, condition })
}

fn sweep(seed: u64, count: usize) {
    judge_families(count, |family, index| compound(family, seed, index));
}

/// Law: a compound has every hit of its parts, in their order, with their normals, however it searches.
/// Oracle: its parts in 512-bit arithmetic, one by one.
#[test]
fn compounds_are_exact_within_their_condition() {
    sweep(191, 100);
}

/// The same, ten thousand cases a family.
#[test]
#[ignore = "cost: cargo test ch19 -- --ignored"]
fn compounds_thoroughly() {
    sweep(19_191, 10_000);
}
