//! 83 sets, shuffled indices, and draws that depend on nothing but their key.

use std::collections::{HashMap, HashSet};

use groundtruth::lobes::Branch;
use groundtruth::samplers::{Hammersley, Key, Kind, PathKey, Purpose, SampleSets, Sobol};
use testkit::properties::*;

use crate::pictures::studio::built as world;
use crate::prelude::*;
use crate::support::samples::{assert_once_each, built};
use crate::support::statistics::assert_all_equal;

fn sets(kind: impl Into<Kind>, n: u32, seed: u64) -> SampleSets {
    SampleSets::new(&*built(kind), n, seed)
}

fn key(x: u32, y: u32) -> Key {
    Key::new(3, [x, y], Purpose::Pixel)
}

fn run(sets: &SampleSets, key: Key, run: u32) -> Vec<[f64; 2]> {
    let n = sets.per_set();
    (run * n..(run + 1) * n).map(|i| sets.draw(key, i)).collect()
}

fn sorted(mut points: Vec<[f64; 2]>) -> Vec<[u64; 2]> {
    points.sort_by(|a, b| a.partial_cmp(b).expect("finite"));
    points.into_iter().map(|p| p.map(f64::to_bits)).collect()
}

/// Law: every pixel's samples are stratified, so that each run of draws uses up one set, each sample
/// exactly once; the next run too. Oracle: one point in each cell, column and row.
/// Book: listings 5.8 and 5.13, sample_unit_square.
#[test]
fn every_pixel_uses_up_one_set() {
    let (jittered, multi) = (sets(Jittered {}, 25, 9), sets(MultiJittered {}, 25, 9));
    for at in 0..500 {
        for index in [0, 1, 5] {
            let points = run(&jittered, key(at, 7), index);
            assert_once_each("points", &points, 5, 5);
            let points = run(&multi, key(at, 7), index);
            assert_once_each("cells", &points, 5, 5);
            assert_once_each("columns", &points, 25, 1);
            assert_once_each("rows", &points, 1, 25);
        }
    }
}

/// Law: 83 sets and 83 orders are used, each order from any starting position, all equally likely and chosen
/// independently. Oracle: χ² over the sets, and the number of orders seen of each; random samples make equal
/// sets recognisable.
/// Book: listings 5.8 and 5.13, sample_unit_square.
#[test]
fn all_sets_and_orders_are_used() {
    let sets = sets(Random {}, 12, 2);
    let (mut seen, mut orders) = (HashMap::new(), HashMap::new());
    for i in 0..16_600 {
        let points = run(&sets, key(i % 129, i / 129), 0);
        let set = sorted(points.clone());
        let index = |p: &[f64; 2]| set.iter().position(|q| *q == p.map(f64::to_bits));
        let order: Vec<_> = points.iter().map(index).collect();
        // the order relative to the sorted set differs from set to set; one set has 83, each from any of 12
        // starting positions
        *seen.entry(set.clone()).or_insert(0_u64) += 1;
        orders.entry(set).or_insert_with(HashSet::new).insert(order);
    }
    assert_eq!(seen.len(), 83);
    let counts: Vec<u64> = seen.into_values().collect();
    assert_all_equal("counts", &counts, 200.0, 1);
    // 200 draws of 996 orders leave out 996 (995/996)²⁰⁰ ≈ 814.7 of them on average, ±4; the mean of 83
    // such numbers is known to 0.45
    let mean = orders.values().map(|of| of.len() as f64).sum::<f64>() / 83.0;
    assert!((mean - 181.3).abs() < 1.5, "{mean}");
}

proptest! {
    #![proptest_config(laws())]

    /// Law: a draw depends on seed, pixel, purpose and index alone: drawn again, in another order,
    /// after others, it is the same.
    #[test]
    fn draws_depend_on_nothing_else(x: u32, y: u32, index in 0..10_000_u32) {
        let sets = sets(MultiJittered {}, 9, 1);
        let first = sets.draw(key(x, y), index);
        sets.draw(key(y, x), index);
        prop_assert_eq!(sets.draw(key(x, y), index), first);
        prop_assert!(first.iter().all(|u| (0.0..1.0).contains(u)), "{first:?} is not in [0, 1)²");
    }
}

/// Law: another seed gives other sets, and other choices of the same sets. Oracle: none of 100 agrees.
#[test]
fn seeds_change_sets_and_choices() {
    let (one, two) = (sets(Random {}, 4, 1), sets(Random {}, 4, 2));
    (0..100).for_each(|x| assert_ne!(one.draw(key(x, 0), 0), two.draw(key(x, 0), 0), "pixel {x}"));
    let other = |x| Key::new(4, [x, 0], Purpose::Pixel);
    let agree = (0..332).filter(|&x| run(&one, key(x, 0), 0) == run(&one, other(x), 0)).count();
    assert!(agree <= 2, "{agree} of 332 pixels choose alike; 332/83² = 0.05 are expected");
}

/// Law: what one pixel draws for two purposes is not correlated, in x, y or across: pixel and lens,
/// two lights, a light on two paths, a light and a direction. Oracle: correlations of 10⁴ pairs are within
/// `1/√10⁴`, Šidák-corrected over the 5 × 4 × 4 of them.
/// Book: shuffled indices.
#[test]
fn draws_for_different_purposes_are_not_correlated() {
    const SIDE: u32 = 100;
    let (first, second) = (PathKey::CAMERA, PathKey::CAMERA.then(Branch::Refraction));
    let light = |path, light| Purpose::Light { path, light, pair: 0 };
    let pairs_of_purposes = [
        (Purpose::Pixel, Purpose::Lens),
        (light(first, 0), light(first, 1)),
        (light(first, 0), light(second, 0)),
        (light(second, 0), Purpose::Direction { path: second, branch: Branch::Gloss }),
    ];
    for kind in [
        Kind::from(Random {}),
        Jittered {}.into(),
        MultiJittered {}.into(),
        Hammersley { shifted: true }.into(),
        Sobol {}.into(),
    ] {
        let sets = sets(kind.clone(), 16, 1);
        for (one, other) in pairs_of_purposes {
            for axes in [[0, 0], [0, 1], [1, 0], [1, 1]] {
                let pairs = pixels(SIDE, SIDE).map(|pixel| {
                    let draw = |purpose| sets.draw(Key::new(3, pixel, purpose), 0);
                    (draw(one)[axes[0]], draw(other)[axes[1]])
                });
                let z = correlation(&pairs.collect::<Vec<_>>()) * f64::from(SIDE);
                assert!(z.abs() < most_sigmas(80), "{kind:?} {one:?} {other:?} {axes:?}: {z}");
            }
        }
    }
}

fn correlation(pairs: &[(f64, f64)]) -> f64 {
    let n = pairs.len() as f64;
    let mean = |of: fn(&(f64, f64)) -> f64| pairs.iter().map(of).sum::<f64>() / n;
    let (a, b) = (mean(|p| p.0), mean(|p| p.1));
    let sum =
        |of: &dyn Fn(f64, f64) -> f64| pairs.iter().map(|p| of(p.0 - a, p.1 - b)).sum::<f64>();
    sum(&|x, y| x * y) / (sum(&|x, _| x * x) * sum(&|_, y| y * y)).sqrt()
}

/// Law: as in the book, one sample is regular unless said otherwise, and more are multi-jittered.
/// Oracle: where the rays go.
/// Book: samplers of the view plane.
#[test]
fn the_default_is_regular_for_one_and_multi_jittered_for_more() {
    let mut scene = from_front(5, 5, 1.0);
    let film = |scene: &Scene, at, i| camera_ray(&world(scene), at, i).1.map(|x| x + 2.5);
    assert_eq!(film(&scene, [2, 2], 0), [2.5, 2.5]);
    scene.image.samples = 9;
    let points: Vec<_> = (0..9).map(|i| film(&scene, [2, 2], i).map(|x| x - 2.0)).collect();
    assert_once_each("points", &points, 3, 3);
    assert_once_each("points", &points, 9, 1);
    assert_once_each("points", &points, 1, 9);
    assert_ne!(points[0], [1.0 / 6.0; 2]);
    assert_eq!(sets(Regular {}, 1, 5).draw(key(1, 1), 77), [power_of_two(-1); 2]);
}
