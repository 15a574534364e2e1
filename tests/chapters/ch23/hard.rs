//! Triangles of meshes against exact arithmetic, on hard cases.

use std::sync::Arc;

use groundtruth::accel::Method;
use groundtruth::kinds::Custom;
use groundtruth::math::{Point, Transform, Vector};
use groundtruth::shapes::{Context, Instance, Kind, TriangleMesh};
use groundtruth::verify::against;
use oracle::Shape;
use oracle::hard::{Family, Kind as Hard, cases};

use crate::draw::Draw;
use crate::hard_cases::{Case, judge_families, merged, steps, union};

/// Six points: a hard triangle's, and one across each of its sides, up to a side's length out of its
/// plane; and the four triangles, the hard one third.
const NET: [[u32; 3]; 4] = [[1, 0, 3], [2, 1, 4], [0, 1, 2], [0, 2, 5]];

fn net([a, b, c]: [Point; 3], draw: &mut Draw) -> [Point; 6] {
    let out = (b - a).cross(c - a).unit().unwrap_or(Vector::ZERO);
    let mut across = |p: Point, q: Point, r: Point| {
        let bend = if draw.coin() { draw.between(-1.0, 1.0) } else { draw.decades(-9.0, -1.0) };
        p + (q - r) + (bend * (q - p).length()) * out
    };
    [a, b, c, across(a, b, c), across(b, c, a), across(c, a, b)]
}

/// One of the cases of a family: the net about a hard triangle, and the ray that is hard for that.
fn case(family: Family, seed: u64, index: usize, matrix: Option<[[f64; 4]; 3]>) -> Option<Case> {
    let (shape, mut ray) = cases(Hard::Triangle, family, seed + index as u64, 1).remove(0);
    let Shape::Triangle { vertices } = shape else { return None };
    let mut draw = Draw::case(seed + family as u64, index);
    let points = net(vertices.map(Point::from), &mut draw);
    let method = draw.pick(&[Method::List, Method::Grid, Method::Bvh]);
    let mesh = TriangleMesh::new(points.to_vec(), NET.to_vec()).accelerated(method);
    let mut kind = Kind::Custom(Custom(Arc::new(mesh)));
    let triangle = |corners: [u32; 3]| Shape::Triangle {
        vertices: corners.map(|i| points[i as usize].to_array()),
    };
    let mut exact = NET.map(triangle);
    if let Some(matrix) = matrix {
        let transform = steps(&matrix)?;
        let map = Transform::from_steps(&transform).expect("not singular");
        kind = Instance::new(kind, transform).into();
        exact = exact.map(|of| Shape::Instance { matrix: map.rows(), of: Box::new(of) });
        ray.origin = map.point(ray.origin.into()).to_array();
        ray.direction = map.vector(ray.direction.into()).to_array();
    }
    let answers = exact.each_ref().map(|shape| oracle::intersect(shape, &ray));
    Some(Case {
        name: format!("mesh {family:?} seed {seed} index {index}"),
        ours: kind.build(&mut Context::default()).ok()?,
        ray: against::ray(&ray),
        condition: exact[0].condition(),
        exact: union(&answers, merged(&answers)),
    })
}

fn sweep_meshes(seed: u64, count: usize) {
    judge_families(count, |family, index| case(family, seed, index, None));
}

fn sweep_instances(seed: u64, count: usize) {
    let matrices: Vec<_> = cases(Hard::Instance, Family::Scaled, 2300, 64)
        .into_iter()
        .filter_map(|(shape, _)| match shape {
            Shape::Instance { matrix, .. } => Some(matrix),
            _ => None,
        })
        .collect();
    let matrix = |index| Some(matrices[index % matrices.len()]);
    judge_families(count, |family, index| case(family, seed, index, matrix(index)));
}

/// Law: a mesh has every hit of its triangles, as exactly as their condition allows, however it
/// searches. Oracle: 512-bit arithmetic, one triangle after the other.
#[test]
fn meshes_are_exact_within_their_condition() {
    sweep_meshes(23, 100);
}

/// Law and oracle as above, for instances of meshes.
#[test]
fn instances_of_meshes_are_exact_within_their_condition() {
    sweep_instances(231, 100);
}

/// Both, ten thousand cases a family.
#[test]
#[ignore = "cost: cargo test ch23 -- --ignored"]
fn meshes_and_their_instances_thoroughly() {
    sweep_meshes(2323, 10_000);
    sweep_instances(2324, 10_000);
}
