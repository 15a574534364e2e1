//! How evenly the points of a set lie.

use groundtruth::samplers::{CorrelatedMultiJittered, Hammersley, Kind, NRooks, Sobol};

use crate::prelude::*;
use crate::support::samples::built;

/// The star discrepancy: the largest difference between the share of points in a box at the origin and its
/// area. It occurs where a point lies on each upper side of the box, counted as inside or as outside.
fn star_discrepancy(points: &[[f64; 2]]) -> f64 {
    let sides = |axis: usize| {
        let mut sides: Vec<f64> = points.iter().map(|p| p[axis]).chain([1.0]).collect();
        sides.sort_by(f64::total_cmp);
        sides.dedup();
        sides
    };
    let (xs, ys) = (sides(0), sides(1));
    let mut by_y = points.to_vec();
    by_y.sort_by(|a, b| a[1].total_cmp(&b[1]));
    let n = points.len() as f64;
    let mut worst: f64 = 0.0;
    for &x in &xs {
        // points below y, and up to y, in the open and in the closed box
        let (mut below, mut up_to) = (by_y.iter().peekable(), by_y.iter().peekable());
        let (mut open, mut closed) = (0_u32, 0_u32);
        for &y in &ys {
            while let Some(p) = below.next_if(|p| p[1] < y) {
                open += u32::from(p[0] < x);
            }
            while let Some(p) = up_to.next_if(|p| p[1] <= y) {
                closed += u32::from(p[0] <= x);
            }
            worst = worst.max(x * y - f64::from(open) / n).max(f64::from(closed) / n - x * y);
        }
    }
    worst
}

/// Law: `star_discrepancy` is right: for one point in the middle it is 3/4 (the closed box up to it), for one
/// at the origin 1 (the box of no area), for four centres `1 − (3/4)²`. Oracle: by hand.
#[test]
fn the_star_discrepancy_is_what_it_should_be() {
    assert_eq!(star_discrepancy(&[[0.5, 0.5]]), 0.75);
    assert_eq!(star_discrepancy(&[[0.0, 0.0]]), 1.0);
    let centers = [[0.25, 0.25], [0.75, 0.25], [0.25, 0.75], [0.75, 0.75]];
    assert_eq!(star_discrepancy(&centers), 7.0 / 16.0);
    assert_eq!(star_discrepancy(&[[0.9, 0.1], [0.9, 0.1]]), 0.91);
}

/// Law: of 256 points the star discrepancy is 0.0615 for regular ones, `1 − (1 − 1/(2·16))²` (a box that just
/// leaves out the last row and column), and on average 0.076 for random ones, 0.038 for n rooks, 0.035 for
/// jittered, 0.020 for multi-jittered, 0.017 for correlated ones and 0.013 for Sobol's. Oracle: the closed
/// form; for the others means of 24 sets made by another program from the definitions (8 for the random
/// ones), and their spread from set to set. The mean of 16 sets here may be off by four standard errors of
/// the two.
/// Book: what makes a pattern good.
#[test]
fn star_discrepancies_are_those_of_the_patterns() {
    let mut random = Pcg32::new(256, 0);
    let regular = star_discrepancy(&built(Regular {}).fill(256, &mut random));
    let corner = 1.0 - 1.0 / 32.0;
    assert!((regular - (1.0 - corner * corner)).abs() < 1e-15, "{regular}");
    let spread_of_mean = (1.0 / 24.0_f64 + 1.0 / 16.0).sqrt();
    for (kind, measured, spread) in [
        (Kind::from(Random {}), 0.0762, 0.0166),
        (NRooks {}.into(), 0.0381, 0.0074),
        (Jittered {}.into(), 0.0349, 0.0045),
        (MultiJittered {}.into(), 0.0196, 0.0019),
        (CorrelatedMultiJittered {}.into(), 0.0167, 0.0026),
        (Sobol {}.into(), 0.0129, 0.0006),
    ] {
        let sampler = built(kind);
        let mean =
            (0..16).map(|_| star_discrepancy(&sampler.fill(256, &mut random))).sum::<f64>() / 16.0;
        assert!((mean - measured).abs() < 4.0 * spread * spread_of_mean, "{sampler:?}: {mean}");
    }
}

/// Law: Hammersley's set of `N = 2^m ≥ 4` points has the star discrepancy
/// `(m/3 + 13/9 − (−1)^m 4/(9 N)) / N`; 0.0161 for 256. Oracle: this theorem (Halton & Zaremba, "The
/// Extreme and L² Discrepancies of Some Plane Sets", 1969).
/// Book: Hammersley sampling: the radical inverse.
#[test]
fn hammersleys_star_discrepancy_is_the_theorems() {
    let sampler = built(Hammersley { shifted: false });
    for m in 2..=9 {
        let n = power_of_two(m);
        let sign = if m % 2 == 0 { 1.0 } else { -1.0 };
        let exact = (f64::from(m) / 3.0 + 13.0 / 9.0 - sign * 4.0 / (9.0 * n)) / n;
        let found = star_discrepancy(&sampler.fill(1 << m, &mut Pcg32::new(0, 0)));
        assert!((found - exact).abs() < 1e-14, "m = {m}: {found} for {exact}");
    }
}

/// Law: the least distance between two of 256 points is 1/16 for regular points, on average `1/(√2 N)` for random
/// ones, and for jittered ones `Γ(4/3) c^(−1/3)`, where `c d³` pairs of neighbouring cells are expected to have points
/// nearer than d. Oracle: those values, from the area within d of a point or of a common side; pairs at corners make
/// jittered points a little closer. The means of 332 sets are known to 3 %.
/// Book: what makes a pattern good.
#[test]
fn least_distances_are_those_of_the_patterns() {
    let least = |points: &[[f64; 2]]| {
        let pairs =
            points.iter().enumerate().flat_map(|(i, p)| points[..i].iter().map(move |q| (p, q)));
        pairs
            .map(|(p, q)| (p[0] - q[0]) * (p[0] - q[0]) + (p[1] - q[1]) * (p[1] - q[1]))
            .fold(f64::INFINITY, f64::min)
            .sqrt()
    };
    let mut random = Pcg32::new(256, 1);
    near!(least(&built(Regular {}).fill(256, &mut random)), 1.0 / 16.0, 1e-15);
    // 480 pairs of cells with a common side of 1/16; two points as dense as 256 each
    let c = 480.0 * 256.0 * 256.0 / 16.0 * 2.0 / 3.0;
    for (kind, expected) in [
        (Kind::from(Random {}), 1.0 / (2.0_f64.sqrt() * 256.0)),
        (Jittered {}.into(), 0.892_979_5 * power(c, -1.0 / 3.0)),
    ] {
        let sampler = built(kind);
        let mean = (0..332).map(|_| least(&sampler.fill(256, &mut random))).sum::<f64>() / 332.0;
        near!(mean / expected, 1.0, 0.15, "{sampler:?}");
    }
}
