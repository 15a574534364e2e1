//! 83 sets, shuffled indices, and draws that depend on nothing but their key.

use std::collections::{HashMap, HashSet};

use groundtruth::lobes::Branch;
use groundtruth::samplers::{Hammersley, Kind, PathKey, Purpose, SampleSets, SetKey, Sobol};
use statistics::correlation::pearson;

use crate::prelude::*;
use crate::support::samples::{assert_once_each, built};
use crate::support::stage::built as world;
use crate::support::statistics::assert_all_equal;

fn sets(kind: impl Into<Kind>, n: u32, seed: u64) -> SampleSets {
    SampleSets::new(&*built(kind), n, seed)
}

fn key(x: u32, y: u32) -> SetKey {
    SetKey::new(3, [x, y], Purpose::Pixel)
}

fn run(sets: &SampleSets, key: SetKey, run: u32) -> Vec<[f64; 2]> {
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

/// Another pixel, or the same, and the index of its draw.
type Partner = fn([u32; 2]) -> ([u32; 2], u32);

/// The index of the draw that is tested.
const INDEX: u32 = 5;

/// Law: what one pixel draws for two purposes is not correlated, in x, y or across: pixel and lens, two lights,
/// two pairs of one light, a light on two paths, a light and a direction; nor is what it draws with what others
/// draw beside it, mirrored or far away, or in the next run. Oracle: Pearson's correlations of 10⁴ pairs, at one
/// level for all together. Book: shuffled indices.
#[test]
fn draws_for_different_purposes_are_not_correlated() {
    const SIDE: u32 = 100;
    let first = PathKey::CAMERA;
    let [mirrored, refracted] = [Branch::Mirror, Branch::Refraction].map(|it| first.then(it));
    let light = |path, light, pair| Purpose::Light { path, light, pair };
    let gloss = |path| Purpose::Direction { path, branch: Branch::Gloss };
    let purposes = [
        (Purpose::Pixel, Purpose::Lens),
        (Purpose::Lens, light(first, 0, 0)),
        (light(first, 0, 0), light(first, 0, 1)),
        (light(first, 0, 0), light(first, 1, 0)),
        (light(first, 0, 1), light(first, 1, 0)),
        (light(first, 0, 0), light(mirrored, 0, 0)),
        (light(mirrored, 0, 0), light(refracted, 0, 0)),
        (
            light(mirrored.then(Branch::Refraction), 0, 0),
            light(refracted.then(Branch::Mirror), 0, 0),
        ),
        (light(refracted, 0, 0), gloss(refracted)),
        (gloss(first), Purpose::Lobe { path: first }),
    ];
    let partners: [Partner; 5] = [
        |[x, y]| ([x + 1, y], INDEX),
        |[x, y]| ([x, y + 1], INDEX),
        |[x, y]| ([y, x], INDEX),
        |[x, y]| ([x, y + 2049], INDEX),
        |at| (at, INDEX + 16),
    ];
    let same: Partner = |at| (at, INDEX);
    let purposes = purposes.map(|(one, other)| (one, other, same));
    let pixel = partners.map(|partner| (Purpose::Pixel, Purpose::Pixel, partner));
    let level = sidak(1e-3, 5 * 15 * 4);
    for kind in [
        Kind::from(Random {}),
        Jittered {}.into(),
        MultiJittered {}.into(),
        Hammersley { shifted: true }.into(),
        Sobol {}.into(),
    ] {
        let sets = sets(kind.clone(), 16, 1);
        for (i, (one, other, partner)) in purposes.into_iter().chain(pixel).enumerate() {
            // no draw is in two pairs
            let all = pixels(SIDE, SIDE).map(|[x, y]| [2 * x, 2 * y + 1]);
            let draw = |(at, index), purpose| sets.draw(SetKey::new(3, at, purpose), index);
            let draws: Vec<[[f64; 2]; 2]> =
                all.map(|at| [draw(same(at), one), draw(partner(at), other)]).collect();
            for axes in [[0, 0], [0, 1], [1, 0], [1, 1]] {
                let [a, b] =
                    [0, 1].map(|k| draws.iter().map(|it| it[k][axes[k]]).collect::<Vec<_>>());
                let found = pearson(&a, &b).expect("they differ");
                assert!(
                    found.p > level,
                    "{kind:?}, pair {i}, {one:?} {other:?} {axes:?}: {found:?}"
                );
            }
        }
    }
}

/// Law: all samples of a pixel are paired with its lens samples as a random permutation pairs them:
/// correlations have the mean 0 and the mean square `1/(n − 1)`. Oracle: t tests over both axes of 4000
/// pixels. In one of 83 · 64 pixels both use the same order from the same start, which pairs equal cells and
/// adds 1.2 % to the mean square; the test detects 6 %. Orders that all have the same start would add 76 %.
/// Book: shuffled indices.
#[test]
fn a_pixels_samples_are_paired_at_random() {
    const PIXELS: u32 = 4000;
    let n = 64;
    let sets = sets(MultiJittered {}, n, 5);
    let (mut correlations, mut squares) = (Vec::new(), Vec::new());
    for at in 0..PIXELS {
        let draws = |purpose| -> Vec<[f64; 2]> {
            let key = SetKey::new(9, [at % 100, at / 100], purpose);
            (0..n).map(|i| sets.draw(key, i)).collect()
        };
        let [pixel, lens] = [Purpose::Pixel, Purpose::Lens].map(draws);
        for axis in 0..2 {
            let column = |points: &[[f64; 2]]| points.iter().map(|p| p[axis]).collect::<Vec<_>>();
            let r = pearson(&column(&pixel), &column(&lens)).expect("they differ").r;
            correlations.push(r);
            squares.push(r * r * f64::from(n - 1));
        }
    }
    let level = sidak(1e-3, 2);
    for (values, expected) in [(correlations, 0.0), (squares, 1.0)] {
        let p = means::one_sample(&values, expected);
        assert!(p > level, "p = {p:e} for {expected}");
    }
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
