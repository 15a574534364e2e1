//! Meshes: a hard triangle among its neighbours, and tessellated spheres.

use ask::Draw;
use std::sync::Arc;

use oracle::Shape;
use oracle::hard::{Family, Kind, cases, rays};

use super::spheres_and_lattices::hard_radius;
use super::{Composite, Piece};
use groundtruth::accel::Method;
use groundtruth::kinds::Custom;
use groundtruth::math::{Point, Vector};
use groundtruth::shapes::{self, TessellatedSphere, TriangleMesh};

/// A triangle of a mesh, in its box.
fn piece(vertices: [Point; 3]) -> Piece {
    let vertices = vertices.map(Point::to_array);
    let end = |which: fn(f64, f64) -> f64| {
        [0, 1, 2].map(|i| vertices.iter().map(|v| v[i]).reduce(which).expect("three"))
    };
    Piece::boxed(Shape::Triangle { vertices }, [end(f64::min), end(f64::max)])
}

/// Four triangles on six points: the corners of a hard triangle, and a point across each of its sides, up
/// to a side's length out of its plane. The hard triangle is the third.
const NET: [[u32; 3]; 4] = [[1, 0, 3], [2, 1, 4], [0, 1, 2], [0, 2, 5]];

fn net_around([a, b, c]: [Point; 3], draw: &mut Draw) -> [Point; 6] {
    let out = (b - a).cross(c - a).unit().unwrap_or(Vector::ZERO);
    let mut across = |p: Point, q: Point, r: Point| {
        let bend = if draw.coin() { draw.between(-1.0, 1.0) } else { draw.decades(-9.0, -1.0) };
        p + (q - r) + (bend * (q - p).length()) * out
    };
    [a, b, c, across(a, b, c), across(b, c, a), across(c, a, b)]
}

/// A hard triangle with its neighbours, and a ray that is hard for it.
pub fn net(family: Family, seed: u64, index: usize, accel: Option<Method>) -> Composite {
    let (shape, ray) = cases(Kind::Triangle, family, seed + index as u64, 1).remove(0);
    let Shape::Triangle { vertices } = shape else { unreachable!("a triangle is a triangle") };
    let mut draw = Draw::case(seed + family as u64, index);
    let points = net_around(vertices.map(Point::from), &mut draw);
    let mesh = TriangleMesh::new(points.to_vec(), NET.to_vec());
    let mesh = mesh.accelerated(accel.unwrap_or_default());
    Composite {
        ours: shapes::Kind::Custom(Custom(Arc::new(mesh))),
        pieces: NET.map(|corners| piece(corners.map(|i| points[i as usize]))).into(),
        ray,
        condition: 1.0,
    }
}

/// A tessellated sphere of a hard radius, with few or many steps.
pub fn sphere(family: Family, seed: u64, index: usize, accel: Option<Method>) -> Composite {
    let mut draw = Draw::case(seed + family as u64, index);
    let radius = hard_radius(family, seed, index);
    let (few, many) = (2 + draw.below(30) as u32, 200 + draw.below(200) as u32);
    let [horizontal, vertical] = match family {
        Family::Thin if draw.coin() => [3, many],
        Family::Thin => [many, 2],
        _ => [3 + draw.below(40) as u32, few],
    };
    let bumps = if draw.coin() { draw.between(0.0, 0.9) } else { 0.0 };
    let sphere = TessellatedSphere { horizontal, vertical, radius, smooth: false, bumps, accel };
    let mesh = sphere.mesh();
    let corners = |triangle: &[u32; 3]| triangle.map(|i| mesh.vertices()[i as usize]);
    let pieces: Vec<Piece> = mesh.triangles().iter().map(|t| piece(corners(t))).collect();
    let aim = &pieces[draw.below(pieces.len())].exact;
    let ray = rays(aim, family, seed + index as u64, 1).remove(0);
    Composite { ours: sphere.into(), pieces, ray, condition: 1.0 }
}
