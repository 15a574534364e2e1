//! Tessellated spheres against exact arithmetic, on rays that are hard for one of their triangles.

use groundtruth::accel::Method;
use groundtruth::math::Point;
use groundtruth::shapes::{Context, Kind as Described, TessellatedSphere};
use groundtruth::verify::against;
use oracle::Shape;
use oracle::hard::{Family, Kind, cases, rays};

use crate::draw::Draw;
use crate::hard_cases::{Case, Piece, judge_families, merged, union};

const METHODS: [Method; 3] = [Method::List, Method::Grid, Method::Bvh];

/// A triangle in its box.
fn piece(vertices: [Point; 3]) -> Piece {
    let vertices = vertices.map(Point::to_array);
    let end = |which: fn(f64, f64) -> f64| {
        [0, 1, 2].map(|i| vertices.iter().map(|v| v[i]).reduce(which).expect("three"))
    };
    Piece::boxed(Shape::Triangle { vertices }, [end(f64::min), end(f64::max)])
}

fn sphere(family: Family, seed: u64, index: usize) -> Option<Case> {
    let mut draw = Draw::case(seed + family as u64, index);
    let Shape::Sphere { radius, .. } = cases(Kind::Sphere, family, seed + index as u64, 1)[0].0
    else {
        unreachable!("a sphere is a sphere")
    };
    let (few, many) = (2 + draw.below(30) as u32, 200 + draw.below(200) as u32);
    let [horizontal, vertical] = match family {
        Family::Thin if draw.coin() => [3, many],
        Family::Thin => [many, 2],
        _ => [3 + draw.below(40) as u32, few],
    };
    let bumps = if draw.coin() { draw.between(0.0, 0.9) } else { 0.0 };
    let accel = Some(METHODS[index % METHODS.len()]);
    let sphere = TessellatedSphere { horizontal, vertical, radius, smooth: false, bumps, accel };
    let mesh = sphere.mesh();
    let corners = |triangle: &[u32; 3]| triangle.map(|i| mesh.vertices()[i as usize]);
    let pieces: Vec<Piece> = mesh.triangles().iter().map(|t| piece(corners(t))).collect();

    let aim = &pieces[draw.below(pieces.len())].exact;
    let ray = rays(aim, family, seed + index as u64, 1).remove(0);
    let name = format!("{family:?} seed {seed} index {index}");
    let ours = Described::from(sphere).build(&mut Context::default()).ok()?;
    let answers: Vec<_> = pieces.iter().map(|piece| piece.answer(&ray)).collect();
    let exact = union(&answers, merged(&answers));
    Some(Case { name, ours, ray: against::ray(&ray), exact, condition: 1.0 })
}

/// Law: a tessellated sphere has every hit of its triangles, however it searches. Oracle: those
/// triangles in 512-bit arithmetic, one by one; that their corners are where they belong is a law
/// of its own.
#[test]
fn tessellated_spheres_are_exact_within_their_condition() {
    judge_families(100, |family, index| sphere(family, 2360, index));
}

/// The same, ten thousand cases a family.
#[test]
#[ignore = "cost: cargo test ch23 -- --ignored"]
fn tessellated_spheres_thoroughly() {
    judge_families(10_000, |family, index| sphere(family, 23_600, index));
}
