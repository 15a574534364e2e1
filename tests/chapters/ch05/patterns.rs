//! The patterns of single sets.

use groundtruth::samplers::{CorrelatedMultiJittered, Kind, NRooks, Sobol};
use testkit::properties::*;

use crate::prelude::*;
use crate::support::samples::{assert_once_each, built};

proptest! {
    #![proptest_config(laws())]

    /// Law: a set has exactly the number of points it states, at least as many as requested (squares are not
    /// rounded), all in [0, 1)².
    /// Book: the class Sampler: sets of samples.
    #[test]
    fn sets_are_complete_and_in_the_unit_square(n in 1..300_u32, seed: u64) {
        for kind in
            [Kind::from(Regular {}), Random {}.into(), Jittered {}.into(), MultiJittered {}.into()]
        {
            let sampler = built(kind);
            let rounded = sampler.round_up(n);
            at_least!(rounded, n);
            prop_assert_eq!(sampler.round_up(rounded), rounded);
            let root = (1..).find(|i| i * i >= n).unwrap_or(0);
            prop_assert!(rounded == n || rounded == root * root, "{rounded} for {n}");
            let points = sampler.fill(rounded, &mut Pcg32::new(seed, 0));
            prop_assert_eq!(points.len(), rounded as usize);
            prop_assert!(points.iter().flatten().all(|x| (0.0..1.0).contains(x)), "{points:?}");
        }
    }

    /// Law: a count without a correlated multi-jittered grid is rounded up to the next that has one, at most
    /// the next square. Oracle: a search for the grid of `m` columns and m, m + 1 or m + 2 rows with the
    /// fewest cells.
    #[test]
    fn correlated_sets_are_rounded_up_to_their_grid(n in 1..5000_u32) {
        let grids = (1..100).flat_map(|m: u32| (0..3).map(move |more| m * (m + more)));
        let best = grids.filter(|&cells| cells >= n).min();
        let rounded = built(CorrelatedMultiJittered {}).round_up(n);
        prop_assert_eq!(Some(rounded), best);
        let square = built(Jittered {}).round_up(n);
        prop_assert!(rounded <= square, "{rounded}, beyond {square}");
    }

    /// Law: jittered and multi-jittered sets have one point in each cell of the n × n grid;
    /// multi-jittered ones and n rooks at the same time one in each of the n² columns and rows.
    /// Book: jittered, n-rooks and multi-jittered sampling.
    #[test]
    fn sets_are_stratified(side in 1..20_u32, seed: u64) {
        let random = &mut Pcg32::new(seed, 0);
        let n = side * side;
        let jittered = built(Jittered {}).fill(n, random);
        let multi = built(MultiJittered {}).fill(n, random);
        assert_once_each("jittered", &jittered, side, side);
        assert_once_each("multi", &multi, side, side);
        assert_once_each("columns", &multi, n, 1);
        assert_once_each("rows", &multi, 1, n);
        let rooks = built(NRooks {}).fill(n, random);
        assert_once_each("columns of rooks", &rooks, n, 1);
        assert_once_each("rows of rooks", &rooks, 1, n);
    }
}

/// Law: in a multi-jittered set the fine column of a cell's point is independent of its fine row, and all are
/// equally likely. Oracle: χ² over the 4 × 4 positions in two cells of a 4 × 4 grid.
/// Book: jittered, n-rooks and multi-jittered sampling.
#[test]
fn multi_jittered_points_are_anywhere_in_their_cell() {
    let (sampler, mut random) = (built(MultiJittered {}), Pcg32::new(5, 5));
    let mut positions = [[0_u64; 16]; 2];
    for _ in 0..4000 {
        for [x, y] in sampler.fill(16, &mut random) {
            let (i, j) = ((x * 16.0) as usize, (y * 16.0) as usize);
            let cells = [(0, 0), (2, 1)];
            for (cell, counts) in cells.into_iter().zip(&mut positions) {
                if (i / 4, j / 4) == cell {
                    counts[j % 4 * 4 + i % 4] += 1;
                }
            }
        }
    }
    for counts in positions {
        crate::support::statistics::assert_all_equal("counts", &counts, 250.0, 2);
    }
}

/// Law: x and y of a point are uncorrelated: `E (x − ½)(y − ½) = 0`. Oracle: z test over sets, which are
/// independent of one another.
/// Book: what makes a pattern good.
#[test]
fn coordinates_do_not_depend_on_each_other() {
    for kind in [
        Kind::from(Random {}),
        Jittered {}.into(),
        NRooks {}.into(),
        MultiJittered {}.into(),
        CorrelatedMultiJittered {}.into(),
        Sobol {}.into(),
    ] {
        let (sampler, mut random) = (built(kind), Pcg32::new(8, 8));
        let covariance = |set: Vec<[f64; 2]>| {
            set.iter().map(|[x, y]| (x - 0.5) * (y - 0.5)).sum::<f64>() / set.len() as f64
        };
        let sets: Vec<_> = (0..4000).map(|_| covariance(sampler.fill(25, &mut random))).collect();
        assert!(sigmas(&sets, 0.0).abs() < most_sigmas(6), "{sampler:?}");
    }
}

/// Law: n rooks are a random permutation: the 24 permutations of four rooks are equally likely. Oracle: χ².
/// Book: jittered, n-rooks and multi-jittered sampling.
#[test]
fn rooks_take_every_order() {
    let (sampler, mut random) = (built(NRooks {}), Pcg32::new(24, 5));
    let mut orders = std::collections::BTreeMap::new();
    for _ in 0..24_000 {
        let points = sampler.fill(4, &mut random);
        let row_of = |column: usize| {
            let point = points.iter().find(|p| (4.0 * p[0]) as usize == column);
            point.map(|p| (4.0 * p[1]) as usize)
        };
        *orders.entry([0, 1, 2, 3].map(row_of)).or_insert(0_u64) += 1;
    }
    let counts: Vec<u64> = orders.into_values().collect();
    assert_eq!(counts.len(), 24);
    crate::support::statistics::assert_all_equal("counts", &counts, 1000.0, 1);
}

/// Law: in a correlated multi-jittered set, all cells of one row have their point in the same of the n fine
/// columns, and all of one column in the same of the m fine rows, so that neighbours in a row or column keep
/// their distance; all orders are equally likely. Oracle: whole numbers, and χ² over the 3! orders.
#[test]
fn correlated_sets_have_one_order_for_all() {
    let (sampler, mut random) = (built(CorrelatedMultiJittered {}), Pcg32::new(13, 1));
    let mut orders = std::collections::BTreeMap::new();
    // 12 points: 3 columns, 4 rows
    for _ in 0..6000 {
        let (mut fine_columns, mut fine_rows) = ([None; 4], [None; 3]);
        for [x, y] in sampler.fill(12, &mut random) {
            let (column, row) = ((x * 12.0) as usize, (y * 12.0) as usize);
            let (i, j) = (column / 4, row / 3);
            let first = *fine_columns[j].get_or_insert(column % 4);
            assert_eq!(first, column % 4, "row {j} of cells");
            let first = *fine_rows[i].get_or_insert(row % 3);
            assert_eq!(first, row % 3, "column {i} of cells");
        }
        *orders.entry(fine_rows).or_insert(0_u64) += 1;
    }
    let counts: Vec<u64> = orders.into_values().collect();
    assert_eq!(counts.len(), 6);
    crate::support::statistics::assert_all_equal("counts", &counts, 1000.0, 1);
}
