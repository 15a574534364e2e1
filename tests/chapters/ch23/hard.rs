//! Triangles of meshes against exact arithmetic, on hard cases.

use std::sync::Arc;

use groundtruth::accel::Method;
use groundtruth::kinds::Custom;
use groundtruth::math::{Point, Transform};
use groundtruth::shapes::{Context, Instance, Kind, TriangleMesh};
use oracle::hard::{Family, Kind as Hard, cases};

use crate::hard_cases::{Pair, steps, sweep_as};

/// A mesh of this triangle between two others that no ray of the case can reach.
fn mesh(shape: &oracle::Shape) -> Option<Kind> {
    let oracle::Shape::Triangle { vertices } = shape else { return None };
    let [a, b, c] = vertices.map(Point::from);
    let mesh = TriangleMesh::new(vec![a, b, c], vec![[0, 0, 1], [0, 1, 2], [2, 2, 2]]);
    let built = mesh.accelerated(Method::Bvh);
    Some(Kind::Custom(Custom(Arc::new(built))))
}

fn sweep_meshes(seed: u64, count: usize) {
    sweep_as(Hard::Triangle, seed, count, |shape, ray, _| {
        let ours = mesh(shape)?.build(&mut Context::default()).ok()?;
        Some((Pair { ours, exact: shape.clone() }, ray.clone()))
    });
}

fn sweep_instances(seed: u64, count: usize) {
    let matrices: Vec<_> = cases(Hard::Instance, Family::Scaled, 2300, 64)
        .into_iter()
        .filter_map(|(shape, _)| match shape {
            oracle::Shape::Instance { matrix, .. } => Some(matrix),
            _ => None,
        })
        .collect();
    sweep_as(Hard::Triangle, seed, count, |shape, ray, i| {
        let transform = steps(&matrices[i % matrices.len()])?;
        let map = Transform::from_steps(&transform).expect("not singular");
        let instance = Instance::new(mesh(shape)?, transform);
        let ours = Kind::from(instance).build(&mut Context::default()).ok()?;
        let exact = oracle::Shape::Instance { matrix: map.rows(), of: Box::new(shape.clone()) };
        let origin = map.point(ray.origin.into()).to_array();
        let direction = map.vector(ray.direction.into()).to_array();
        Some((Pair { ours, exact }, oracle::Ray { origin, direction }))
    });
}

/// Law: a triangle of a mesh is hit as exactly as its condition allows. Oracle: 512-bit arithmetic.
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
