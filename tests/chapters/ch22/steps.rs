//! The cost of a search, counted rather than timed.

use groundtruth::accel::{Accel, Counts};
use groundtruth::math::cbrt;
use groundtruth::shapes::RandomSpheres;

use crate::prelude::*;

const RAYS: usize = 400;

/// The mean numbers of steps and tests of a ray through random spheres, and of the planes between cells
/// of the book's grid that it crosses in the cube.
fn cost(method: Method, count: u32, radius: f64) -> [f64; 3] {
    let data = RandomSpheres { count, radius, half_side: 1.0, seed: 15, accel: None };
    let sphere =
        |data: Sphere| Kind::from(data).build(&mut Context::default()).expect("a valid sphere");
    let spheres: Vec<_> = data.spheres().into_iter().map(sphere).collect();
    let bounds: Vec<Aabb> = spheres.iter().map(|sphere| sphere.bounds()).collect();
    let accel = Accel::build(method, &bounds);
    let mut draw = Draw::new(2298);
    let (mut counts, mut planes) = (Counts::default(), 0.0);
    for _ in 0..RAYS {
        // from one face of the cube to the opposite one
        let mut place = || draw.between(-1.0, 1.0);
        let (from, to) = (Point::new(place(), place(), -1.0), Point::new(place(), place(), 1.0));
        let ray = Ray::new(from - 2.0 * (to - from), to - from);
        let hit = |index, span| spheres[index as usize].hit(&ray, span);
        let _ = accel.nearest(&ray, Span::AHEAD, &mut counts, hit);
        let cells = 2.0 * cbrt(f64::from(count));
        let way: Vector = to - from;
        planes += way.to_array().iter().map(|x| x.abs() * cells / 2.0).sum::<f64>();
    }
    [counts.steps as f64, counts.tests as f64, planes].map(|sum| sum / RAYS as f64)
}

/// Law: a ray past small spheres passes as many cells as it crosses planes, so that steps and tests grow
/// like `n^(1/3)`; the list tests all. Oracle: the planes between cells by the book's formula; twice as
/// many for eight times as many spheres.
/// Book: rendering times.
#[test]
fn a_grid_takes_as_many_steps_as_planes_are_crossed() {
    let costs = [1_000, 8_000, 64_000].map(|n| cost(Method::Grid, n, 1e-9));
    for [steps, _, planes] in costs {
        // the grid has at most one cell more on each axis than 2 n^(1/3), and the first cell counts, too
        assert!((0.93..1.1).contains(&(steps / planes)), "{steps} of {planes}");
    }
    for pair in costs.windows(2) {
        let [steps, tests] = [0, 1].map(|i| pair[1][i] / pair[0][i]);
        assert!((1.9..2.1).contains(&steps), "steps grow {steps}-fold: {costs:?}");
        assert!((1.7..2.3).contains(&tests), "tests grow {tests}-fold: {costs:?}");
    }
    assert_eq!(cost(Method::List, 1_000, 1e-9)[1], 1_000.0);
}

/// Law: in the book's scene, where the spheres fill the same share of the cube however many they are,
/// steps grow more slowly than `n^0.3`, because rays end sooner, and few spheres are tested. Oracle:
/// eight times as many spheres may take 8^0.3 = 1.866 times as many steps; tests of a thousandth of all
/// spheres.
/// Book: rendering times.
#[test]
fn steps_grow_slowly_in_the_books_scene() {
    let radius = |n: u32| cbrt(0.75 * 0.1 / (std::f64::consts::PI * f64::from(n)));
    for method in [Method::Grid, Method::Bvh] {
        let costs = [1_000, 8_000, 64_000].map(|n| cost(method, n, radius(n)));
        for pair in costs.windows(2) {
            let steps = pair[1][0] / pair[0][0];
            assert!(steps < 1.866, "{method:?}: {steps}-fold: {costs:?}");
        }
        assert!(costs[2][1] < 64.0, "{method:?} tests {}", costs[2][1]);
    }
}
