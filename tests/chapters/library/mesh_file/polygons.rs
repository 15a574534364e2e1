//! How polygons of more than three corners are split into triangles.
//!
//! Triangles that are all wound like a simple polygon cover it exactly once if their directed sides are
//! the polygon's sides and pairs of opposite sides, which cancel. For then the winding number of the
//! polygon around any point is the sum of the triangles' winding numbers, each of which is 0 or 1. So
//! the tests need only the sides and the signs of areas, which are exact in integers.

use std::collections::HashMap;

use formats::meshes::{MeshFileError, parse_obj};

use super::samples::SplitMix64;
use crate::prelude::as_many;

type Point = [i64; 2];

/// Twice the area, exactly.
fn doubled_area([a, b, c]: [Point; 3]) -> i64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

/// Whether two sides have a point in common.
fn meet([a, b]: [Point; 2], [c, d]: [Point; 2]) -> bool {
    let side = |p| doubled_area([a, b, p]).signum();
    let other = |p| doubled_area([c, d, p]).signum();
    let apart = |i: usize| a[i].max(b[i]) < c[i].min(d[i]) || c[i].max(d[i]) < a[i].min(b[i]);
    side(c) * side(d) <= 0 && other(a) * other(b) <= 0 && !apart(0) && !apart(1)
}

fn side(polygon: &[Point], i: usize) -> [Point; 2] {
    [polygon[i], polygon[(i + 1) % polygon.len()]]
}

/// Whether the polygon is simple: sides meet only at the corner between neighbours.
fn is_simple(polygon: &[Point]) -> bool {
    let n = polygon.len();
    let next_is_fine = |i: usize| {
        let [a, b] = side(polygon, i);
        let c = side(polygon, (i + 1) % n)[1];
        let back = (a[0] - b[0]) * (c[0] - b[0]) + (a[1] - b[1]) * (c[1] - b[1]);
        a != b && (doubled_area([a, b, c]) != 0 || back < 0)
    };
    let apart = |i: usize, j: usize| !meet(side(polygon, i), side(polygon, j));
    (0..n).all(next_is_fine)
        && (0..n).all(|i| (i + 2..n).filter(|j| (j + 1) % n != i).all(|j| apart(i, j)))
}

/// A simple polygon with corners on a small grid, so that many corners lie on straight lines. Random
/// points are joined in any order, then 2-opt moves shorten the polygon, which removes crossings. `None`
/// if it is still not simple.
fn random_polygon(random: &mut SplitMix64, corners: usize) -> Option<Vec<Point>> {
    let mut below = |n| random.below(n) as i64;
    let mut polygon: Vec<Point> = (0..corners).map(|_| [below(9), below(9)]).collect();
    for _ in 0..1_000 {
        let pairs = (0..corners).flat_map(|i| (i + 1..corners).map(move |j| (i, j)));
        let length = |[a, b]: [Point; 2]| {
            let [x, y] = [b[0] - a[0], b[1] - a[1]].map(|x| x as f64);
            (x * x + y * y).sqrt()
        };
        let mut shorter = pairs.filter(|&(i, j)| {
            let [[a, b], [c, d]] = [side(&polygon, i), side(&polygon, j)];
            length([a, c]) + length([b, d]) < length([a, b]) + length([c, d]) - 1e-9
        });
        match shorter.next() {
            Some((i, j)) => polygon[i + 1..=j].reverse(),
            None => break,
        }
    }
    is_simple(&polygon).then_some(polygon)
}

/// The triangles of the polygon after a random map of its plane into space.
fn triangles(polygon: &[Point], random: &mut SplitMix64) -> Vec<[u32; 3]> {
    let mut entry = || random.below(7) as i64 - 3;
    let (u, v) = loop {
        let (u, v) = ([entry(), entry(), entry()], [entry(), entry(), entry()]);
        let turned = |i: usize, j: usize| u[i] * v[j] - u[j] * v[i];
        if turned(0, 1) != 0 || turned(1, 2) != 0 || turned(2, 0) != 0 {
            break (u, v);
        }
    };
    let mut text = String::new();
    for [x, y] in polygon {
        let [x, y, z] = [0, 1, 2].map(|i| 5 + x * u[i] + y * v[i]);
        text += &format!("v {x} {y} {z}\n");
    }
    text += "f";
    (1..=polygon.len()).for_each(|corner| text += &format!(" {corner}"));
    parse_obj(text.as_bytes()).expect("readable").triangles
}

/// Checks that the triangles' directed sides, without the pairs that run in opposite directions, are the
/// sides of the polygon, and that all areas have the sign of the polygon's area.
fn assert_covers_once(polygon: &[Point], triangles: &[[u32; 3]]) {
    let mut left: HashMap<[Point; 2], i32> = HashMap::new();
    let mut count = |[a, b]: [Point; 2], by: i32| {
        let (side, by) = if a < b { ([a, b], by) } else { ([b, a], -by) };
        *left.entry(side).or_default() += by;
    };
    (0..polygon.len()).for_each(|i| count(side(polygon, i), 1));
    let area: i64 = (1..polygon.len() - 1)
        .map(|i| doubled_area([polygon[0], polygon[i], polygon[i + 1]]))
        .sum();
    for triangle in triangles {
        let corners = triangle.map(|corner| polygon[corner as usize]);
        assert_eq!(doubled_area(corners).signum(), area.signum(), "{corners:?} of {polygon:?}");
        (0..3).for_each(|i| count(side(&corners, i), -1));
    }
    left.retain(|_, count| *count != 0);
    assert!(left.is_empty(), "{left:?} of {polygon:?}: {triangles:?}");
    assert_eq!(triangles.len(), polygon.len() - 2, "{polygon:?}");
}

/// Law: the triangles of a simple polygon cover it once and have all its sides, also where corners lie
/// on a straight line. Oracle: winding numbers, in integers.
#[test]
fn triangles_cover_a_polygon_once() {
    let mut random = SplitMix64(1975);
    let (mut polygons, mut straight) = (0, 0);
    let all = as_many(500, 3_000);
    while polygons < all {
        let corners = 4 + random.below(21);
        let Some(polygon) = random_polygon(&mut random, corners) else { continue };
        let bend = |i: usize| doubled_area([i, i + 1, i + 2].map(|i| polygon[i % polygon.len()]));
        polygons += 1;
        straight += usize::from((0..corners).any(|i| bend(i) == 0));
        assert_covers_once(&polygon, &triangles(&polygon, &mut random));
    }
    assert!(straight > all / 6, "{straight} with corners on a straight line");
}

/// Law: the same holds for spirals, combs, and a square with a square hole that a cut joins to the rim,
/// for every first corner and both directions. Oracle: the same.
#[test]
fn triangles_cover_spirals_combs_and_holes_once() {
    let wall = |k: i64, beside: i64| {
        let [x, y] = [[1, 1], [-1, 1], [-1, -1], [1, -1]][k as usize % 4];
        [x * (4 * k + 4 + beside), y * (4 * k + 4 + beside)]
    };
    let outside = (0..12).map(|k| wall(k, 1));
    let spiral: Vec<Point> = outside.chain((0..12).rev().map(|k| wall(k, -1))).collect();
    let comb = (0..20).flat_map(|k| [[2 * k, 0], [2 * k + 1, 30]]).chain([[40, -1], [0, -1]]);
    let comb: Vec<Point> = comb.collect();
    assert!(is_simple(&spiral) && is_simple(&comb));
    let hole = [
        [0, 0],
        [9, 0],
        [9, 9],
        [0, 9],
        [0, 0], // from here along the cut to the hole
        [3, 3],
        [3, 6],
        [6, 6],
        [6, 3],
        [3, 3],
    ];
    let mut random = SplitMix64(1976);
    for polygon in [spiral, comb, hole.to_vec()] {
        for first in 0..polygon.len() {
            let mut polygon = polygon.clone();
            polygon.rotate_left(first);
            assert_covers_once(&polygon, &triangles(&polygon, &mut random));
            polygon.reverse();
            assert_covers_once(&polygon, &triangles(&polygon, &mut random));
        }
    }
}

/// Law: a polygon of n corners that crosses itself or has no area gives n − 2 triangles and no panic.
#[test]
fn self_crossing_and_flat_polygons_become_triangles_too() {
    let mut random = SplitMix64(1977);
    for case in 0..2_000 {
        let corners = 4 + random.below(12);
        let high = if case % 4 == 0 { 1 } else { 5 };
        let mut point = || [random.below(5) as i64, random.below(high) as i64];
        let polygon: Vec<Point> = (0..corners).map(|_| point()).collect();
        assert_eq!(triangles(&polygon, &mut random).len(), corners - 2, "{polygon:?}");
    }
}

/// Law: a face with very many corners is read if it is convex; if not, the message names the face.
#[test]
fn a_face_of_very_many_corners_is_read_if_it_is_convex() {
    let many = |last: &str| {
        // on the parabola y = x²
        let vertices: String = (0..10_001_i64).map(|x| format!("v {x} {} 0\n", x * x)).collect();
        let corners: String = (4..=10_004).map(|corner| format!(" {corner}")).collect();
        format!("v 0 0 1\nv 1 0 1\nv 0 1 1\n{vertices}v {last} 0\nf 1 2 3\nf{corners} 10005\n")
    };
    let convex = parse_obj(many("0 200000000").as_bytes()).expect("convex");
    assert_eq!(convex.triangles.len(), 1 + 10_000);
    let problem = parse_obj(many("5000 30000000").as_bytes()).expect_err("not convex");
    assert!(matches!(problem, MeshFileError::ManyCorners { .. }), "{problem}");
    let text = problem.to_string();
    assert!(text.starts_with("face 1 (counted from 0): a face of 10002 corners"), "{text}");
}

/// Law: sizes near the limits of `f64` change nothing. Oracle: the same polygon of size about 1.
#[test]
fn polygons_of_any_size_are_split_alike() {
    let dart = |size: &str| {
        let points = [[0, 0], [4, 1], [1, 1], [1, 4]];
        let vertices: String = points.map(|[x, y]| format!("v {x}{size} {y}{size} 0\n")).concat();
        parse_obj(format!("{vertices}f 1 2 3 4\n").as_bytes()).expect("readable").triangles
    };
    for size in ["e150", "e300", "e-150", "e-300"] {
        assert_eq!(dart(size), dart("e0"), "{size}");
    }
}
