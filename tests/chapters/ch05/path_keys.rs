//! Each path from the eye has a name of its own, so that no two rays of one tree use the same random numbers.

use std::collections::HashMap;

use groundtruth::lobes::Branch;
use groundtruth::samplers::{PathKey, Purpose, SampleSets, SetKey};
use groundtruth::shapes::Sampling;

use crate::prelude::*;
use crate::support::samples::built as sampler;
use crate::support::stage::ray;

const BRANCHES: [Branch; 5] =
    [Branch::Diffuse, Branch::Highlight, Branch::Mirror, Branch::Gloss, Branch::Refraction];

/// All sequences of at most this many branches, with the path of each.
fn paths(length: u32) -> Vec<(Vec<Branch>, PathKey)> {
    let mut all = vec![(vec![], PathKey::CAMERA)];
    let mut first = 0;
    for _ in 0..length {
        let longer: Vec<_> = all[first..]
            .iter()
            .flat_map(|(taken, key)| {
                BRANCHES.map(|branch| ([&taken[..], &[branch]].concat(), key.then(branch)))
            })
            .collect();
        first = all.len();
        all.extend(longer);
    }
    all
}

/// Law: whatever branches a path takes, and in whatever order, its draws are its own: those for a light, for
/// the choice of a lobe and for the direction of each branch differ from the draws of every other path.
/// Oracle: the number of different draws of all 3906 paths of up to five branches. One sample per set, shifted,
/// has 2¹⁰⁴ values, of which two do not agree by chance.
#[test]
fn no_two_paths_share_a_draw() {
    let sets = SampleSets::new(&*sampler(Random {}), 1, 5).centered();
    let mut seen = HashMap::new();
    for (taken, path) in paths(5) {
        let light = Purpose::Light { path, light: 0, pair: 0 };
        let direction = BRANCHES.map(|branch| Purpose::Direction { path, branch });
        for purpose in [light, Purpose::Lobe { path }].into_iter().chain(direction) {
            let draw = sets.draw(SetKey::new(1, [3, 4], purpose), 0).map(f64::to_bits);
            if let Some(other) = seen.insert(draw, (taken.clone(), purpose)) {
                panic!("{purpose:?} after {taken:?} draws the same as {other:?}");
            }
        }
    }
    assert_eq!(seen.len(), 3906 * 7);
}

/// Three panes of half-silvered glass at angles to each other, in a matte room with a lamp. Each is a single
/// surface, so that both its branches lead to points that the lamp lights.
fn room_of_panes() -> Scene {
    let mut scene = deep_stage(Rgb::BLACK, 6);
    let matte = Matte { ka: 0.0.into(), kd: 0.5.into(), cd: Rgb::WHITE.into() };
    put(&mut scene, Sphere { center: Point::ORIGIN, radius: 9.0, inward: true }, matte);
    for (z, slope) in [(0.0, 0.6), (-2.0, -0.5), (-4.0, 0.1)] {
        let half = Transparent {
            phong: Phong::default(),
            kr: 0.5.into(),
            cr: Rgb::WHITE.into(),
            kt: 0.5.into(),
            eta: 1.0,
        };
        let (a, b) = (Vector::new(6.0, 0.0, 6.0 * slope), Vector::new(0.0, 6.0, 0.0));
        let corner = Point::new(0.0, 0.0, z) - 0.5 * (a + b);
        put(&mut scene, Rectangle { corner, a, b }, half);
    }
    let corner = Point::new(-2.0, 7.0, -2.0);
    let lamp = Rectangle { corner, a: 4.0 * Vector::X, b: 4.0 * Vector::Z };
    let lamp = put(&mut scene, lamp, Emissive::new(1.0, Rgb::WHITE)).to_string();
    shine(&mut scene, Area { object: lamp, sampling: Some(Sampling::Area) });
    scene
}

/// Law: in a tree of reflected and refracted rays, each hit draws its own point of the lamp: the two branches
/// of a hit, and paths that take the same branches in another order, are independent. Oracle: the points to
/// which the shadow rays lead; all of a tree are different.
#[test]
fn each_hit_of_a_glass_tree_draws_its_own_point_of_the_lamp() {
    /// Points of the lamp are known to a few roundings of coordinates near 10. That two of the hundreds
    /// of pairs of all trees are so close by chance has the probability 1e-14.
    const APART: f64 = 1e-9;
    let world = built(&room_of_panes());
    let mut pairs = 0;
    for i in 0..24 {
        let x = 0.2 * f64::from(i) - 2.3;
        let eye = Point::new(0.2, 1.0, 6.0);
        let towards = ray(eye, Point::new(x, 0.3, 0.0) - eye);
        let mut tree = RayTree::of(&world);
        radiance(&world, &towards, world.draws([i, 0], 0), &mut tree);
        let rays = tree.rays().into_iter();
        let to_lamp = rays.filter(|it| matches!(it.kind, RayKind::Shadow { .. }));
        let points: Vec<Point> = to_lamp.map(|it| it.ray.at(1.0)).collect();
        for (j, p) in points.iter().enumerate() {
            for q in &points[..j] {
                assert!(p.distance(*q) > APART, "ray {i}: two hits draw {p:?}");
                pairs += 1;
            }
        }
    }
    at_least!(pairs, 200);
}
