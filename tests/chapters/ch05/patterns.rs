//! The patterns of single sets.

use std::sync::Arc;

use groundtruth::math::Pcg32;
use groundtruth::samplers::{Jittered, Kind, MultiJittered, Random, Regular, Sampler};
use proptest::prelude::*;

use crate::ch02::statistics::{most_sigmas, sigmas};
use crate::support::laws;

pub fn built(kind: impl Into<Kind>) -> Arc<dyn Sampler> {
    kind.into().build(&mut ()).expect("a valid sampler")
}

/// How many points fall into each of `columns × rows` cells.
pub fn occupied(points: &[[f64; 2]], columns: u32, rows: u32) -> Vec<u32> {
    let mut cells = vec![0; (columns * rows) as usize];
    for [x, y] in points {
        let (i, j) = ((x * f64::from(columns)) as u32, (y * f64::from(rows)) as u32);
        cells[(j * columns + i) as usize] += 1;
    }
    cells
}

pub fn once_each(cells: &[u32]) -> bool {
    cells.iter().all(|&count| count == 1)
}

proptest! {
    #![proptest_config(laws())]

    /// Law: a set has exactly the points it promises, at least as many as asked for, all in [0, 1)²;
    /// squares are not rounded.
    #[test]
    fn sets_are_complete_and_in_the_unit_square(n in 1..300_u32, seed: u64) {
        for kind in [Kind::from(Regular {}), Random {}.into(), Jittered {}.into(), MultiJittered {}.into()] {
            let sampler = built(kind);
            let rounded = sampler.round_up(n);
            prop_assert!(rounded >= n && sampler.round_up(rounded) == rounded);
            let root = (1..).find(|i| i * i >= n).unwrap_or(0);
            prop_assert!(rounded == n || rounded == root * root, "{rounded} for {n}");
            let points = sampler.fill(rounded, &mut Pcg32::new(seed, 0));
            prop_assert_eq!(points.len(), rounded as usize);
            prop_assert!(points.iter().flatten().all(|x| (0.0..1.0).contains(x)));
        }
    }

    /// Law: jittered and multi-jittered sets have one point in each cell of the n × n grid;
    /// multi-jittered ones at the same time one in each of the n² columns and rows.
    #[test]
    fn sets_are_stratified(side in 1..20_u32, seed: u64) {
        let random = &mut Pcg32::new(seed, 0);
        let n = side * side;
        let jittered = built(Jittered {}).fill(n, random);
        let multi = built(MultiJittered {}).fill(n, random);
        prop_assert!(once_each(&occupied(&jittered, side, side)));
        prop_assert!(once_each(&occupied(&multi, side, side)));
        prop_assert!(once_each(&occupied(&multi, n, 1)), "columns");
        prop_assert!(once_each(&occupied(&multi, 1, n)), "rows");
    }
}

/// Law: in a multi-jittered set, which fine column a cell's point is in has nothing to do with its
/// fine row, and each is as likely. Oracle: χ² over the 4 × 4 places in one cell of a 4 × 4 grid.
#[test]
fn multi_jittered_points_are_anywhere_in_their_cell() {
    let (sampler, mut random) = (built(MultiJittered {}), Pcg32::new(5, 5));
    let mut places = [[0_u64; 16]; 2];
    for _ in 0..4000 {
        for [x, y] in sampler.fill(16, &mut random) {
            let (i, j) = ((x * 16.0) as usize, (y * 16.0) as usize);
            let cells = [(0, 0), (2, 1)];
            for (cell, counts) in cells.into_iter().zip(&mut places) {
                if (i / 4, j / 4) == cell {
                    counts[j % 4 * 4 + i % 4] += 1;
                }
            }
        }
    }
    for counts in places {
        assert!(crate::ch02::statistics::all_equal(&counts, 250.0, 2), "{counts:?}");
    }
}

/// Law: the mean of x over a set has the variance `1/(12 N)` for random points, `1/(12 N²)` for
/// jittered ones (N strata of width N^−½, √N in each column) and `1/(12 N³)` for multi-jittered ones
/// (N strata of width 1/N). Oracle: these closed forms; the mean is ½.
#[test]
fn means_have_the_variance_of_their_strata() {
    for n in [16_u32, 64] {
        let count = f64::from(n);
        for (kind, variance) in [
            (Kind::from(Random {}), 1.0 / (12.0 * count)),
            (Jittered {}.into(), 1.0 / (12.0 * count * count)),
            (MultiJittered {}.into(), 1.0 / (12.0 * count * count * count)),
        ] {
            let (sampler, mut random) = (built(kind), Pcg32::new(12, u64::from(n)));
            let sets: Vec<_> = (0..4000).map(|_| sampler.fill(n, &mut random)).collect();
            for axis in 0..2 {
                let means = sets.iter().map(|set| set.iter().map(|p| p[axis]).sum::<f64>() / count);
                let errors: Vec<f64> = means.map(|mean| mean - 0.5).collect();
                let squares: Vec<f64> = errors.iter().map(|e| e * e).collect();
                let (bias, spread) = (sigmas(&errors, 0.0), sigmas(&squares, variance));
                assert!(bias.abs() < most_sigmas(24), "{sampler:?} {n}: {bias}");
                assert!(spread.abs() < most_sigmas(24), "{sampler:?} {n}: {spread}");
            }
        }
    }
}

/// Law: x and y of a point have nothing to do with each other: `E (x − ½)(y − ½) = 0`. Oracle: z test
/// over sets, which are independent of one another.
#[test]
fn coordinates_do_not_depend_on_each_other() {
    for kind in [Kind::from(Random {}), Jittered {}.into(), MultiJittered {}.into()] {
        let (sampler, mut random) = (built(kind), Pcg32::new(8, 8));
        let covariance = |set: Vec<[f64; 2]>| {
            set.iter().map(|[x, y]| (x - 0.5) * (y - 0.5)).sum::<f64>() / set.len() as f64
        };
        let sets: Vec<_> = (0..4000).map(|_| covariance(sampler.fill(25, &mut random))).collect();
        assert!(sigmas(&sets, 0.0).abs() < most_sigmas(3), "{sampler:?}");
    }
}

/// The star discrepancy: the largest difference between the share of points in a box at the origin
/// and its area. It is taken where the box has a point at each upper side, just in it or just out.
fn star_discrepancy(points: &[[f64; 2]]) -> f64 {
    let mut xs: Vec<f64> = points.iter().map(|p| p[0]).chain([1.0]).collect();
    xs.sort_by(f64::total_cmp);
    let mut by_y = points.to_vec();
    by_y.sort_by(|a, b| a[1].total_cmp(&b[1]));
    let n = points.len() as f64;
    let mut worst: f64 = 0.0;
    for &x in &xs {
        let (mut open, mut closed) = (0, 0);
        for (rank, &[px, y]) in by_y.iter().enumerate() {
            // the open box ends below y: points of a smaller y, and x
            if rank == 0 || by_y[rank - 1][1] < y {
                open = by_y[..rank].iter().filter(|p| p[0] < x).count();
            }
            closed += usize::from(px <= x);
            let last = by_y.get(rank + 1).is_none_or(|next| next[1] > y);
            worst = worst.max(x * y - f64::from(open as u32) / n);
            if last {
                worst = worst.max(f64::from(closed as u32) / n - x * y);
            }
        }
        let below = points.iter().filter(|p| p[0] < x).count();
        worst = worst.max(x - below as f64 / n);
    }
    worst
}

/// Law: of 256 points the regular ones have the star discrepancy `1 − (1 − 1/(2·16))²` (a box that
/// just leaves out the last row and column), and random, jittered and multi-jittered ones about 0.081,
/// 0.035 and 0.021. Oracle: the closed form; for the others independent measurements (means of 8
/// sets, a set being off by about a fifth: the means of 16 and of 8 agree within 15 %).
#[test]
fn star_discrepancies_are_those_of_the_patterns() {
    let mut random = Pcg32::new(256, 0);
    let regular = star_discrepancy(&built(Regular {}).fill(256, &mut random));
    let corner = 1.0 - 1.0 / 32.0;
    assert!((regular - (1.0 - corner * corner)).abs() < 1e-15, "{regular}");
    for (kind, measured) in [
        (Kind::from(Random {}), 0.081),
        (Jittered {}.into(), 0.035),
        (MultiJittered {}.into(), 0.021),
    ] {
        let sampler = built(kind);
        let mean =
            (0..16).map(|_| star_discrepancy(&sampler.fill(256, &mut random))).sum::<f64>() / 16.0;
        assert!((mean / measured - 1.0).abs() < 0.15, "{sampler:?}: {mean}");
    }
}
