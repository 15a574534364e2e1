//! The contract of [`Sampler`] and of the sets made with it (Suffern, ch. 5).

use std::sync::Arc;

use groundtruth::math::{Pcg32, floor};
use groundtruth::samplers::{Kind, SETS, SampleSets, Sampler};
use libtest_mimic::Trial;
use statistics::ks;
use statistics::significance::sidak;

use super::sampler_draws::{
    a_draw_is_uniform_over_the_square, a_run_of_draws_uses_up_one_set, draws_are_pure,
};
use super::{Holds, ensure};

pub fn trials() -> Vec<Trial> {
    super::trials(
        Kind::ENTRIES,
        &[
            ("a_set_has_as_many_points_as_it_says", a_set_has_as_many_points_as_it_says),
            ("points_are_spread_as_promised", points_are_spread_as_promised),
            ("places_in_a_stratum_are_uniform", places_in_a_stratum_are_uniform),
            ("a_draw_is_uniform_over_the_square", a_draw_is_uniform_over_the_square),
            ("a_run_of_draws_uses_up_one_set", a_run_of_draws_uses_up_one_set),
            ("draws_are_pure_and_depend_on_every_part_of_the_key", draws_are_pure),
        ],
    )
}

pub fn built(kind: &Kind) -> Arc<dyn Sampler> {
    kind.build(&mut ()).expect("specimens are valid")
}

/// Law: `round_up(n)` is at least `n` and is unchanged by rounding up again, and `fill` makes that many
/// points.
fn a_set_has_as_many_points_as_it_says(kind: &Kind) -> Holds {
    let sampler = built(kind);
    let mut random = Pcg32::new(5, 1);
    for n in 1..=300 {
        let rounded = sampler.round_up(n);
        ensure!(rounded >= n, "{n} rounded up to {rounded}");
        ensure!(sampler.round_up(rounded) == rounded, "{rounded} is rounded up again");
        for between in n..=rounded {
            ensure!(sampler.round_up(between) == rounded, "{n} to {rounded} skips {between}");
        }
        let count = sampler.fill(rounded, &mut random).len();
        ensure!(count == rounded as usize, "{count} points for {rounded}");
    }
    Ok(())
}

/// The grids, as columns and rows, in which each cell has exactly one of the `n` points, where `n` is a count
/// that the pattern can have.
fn promised(kind: &Kind, n: u32) -> Vec<[u32; 2]> {
    let side = n.isqrt();
    // the elementary intervals in base 2
    let boxes = || -> Vec<[u32; 2]> {
        let m = n.is_power_of_two().then(|| n.ilog2());
        m.into_iter().flat_map(|m| (0..=m).map(move |a| [1 << a, 1 << (m - a)])).collect()
    };
    match kind {
        Kind::Regular(_) | Kind::Jittered(_) => vec![[side, side]],
        Kind::NRooks(_) => vec![[n, 1], [1, n]],
        Kind::MultiJittered(_) => vec![[side, side], [n, 1], [1, n]],
        Kind::CorrelatedMultiJittered(_) => vec![[side, n / side], [n, 1], [1, n]],
        Kind::Hammersley(_) => [vec![[n, 1]], boxes()].concat(),
        Kind::Sobol(_) => boxes(),
        Kind::Random(_) => Vec::new(),
        _ => panic!("write here which strata {kind:?} promises to fill"),
    }
}

/// Whether all sets are the same: the pattern has no choice.
pub fn is_fixed(kind: &Kind) -> bool {
    matches!(kind, Kind::Regular(_) | Kind::Hammersley(_))
}

/// Law: each stratum that the kind promises to fill has exactly one point, in each of the 83 sets.
fn points_are_spread_as_promised(kind: &Kind) -> Holds {
    let sampler = built(kind);
    for n in [1, 2, 3, 4, 6, 8, 9, 13, 16, 25, 30, 32, 64, 256] {
        let sets = SampleSets::new(&*sampler, n, 2);
        for [columns, rows] in promised(kind, sets.per_set()) {
            for set in 0..SETS {
                let mut counts = vec![0; (columns * rows) as usize];
                for [x, y] in sets.set(set) {
                    let column = floor(x * f64::from(columns)) as usize;
                    let row = floor(y * f64::from(rows)) as usize;
                    counts[row * columns as usize + column] += 1;
                }
                let filled = counts.iter().all(|&count| count == 1);
                ensure!(filled, "set {set} of {n} does not fill {columns} × {rows}");
            }
        }
    }
    Ok(())
}

/// Law: the position of a point in its finest stratum is uniform and independent, for kinds that are random.
/// Oracle: the Kolmogorov–Smirnov test; it finds a distribution function that is off by 4 %.
fn places_in_a_stratum_are_uniform(kind: &Kind) -> Holds {
    if is_fixed(kind) {
        return Ok(());
    }
    let sampler = built(kind);
    let grids = promised(kind, 16);
    let finest = |axis: usize| grids.iter().map(|grid| grid[axis]).max().unwrap_or(1);
    let strata = [finest(0), finest(1)].map(f64::from);
    let mut random = Pcg32::new(5, 3);
    let mut places = [Vec::new(), Vec::new()];
    for _ in 0..1000 {
        for point in sampler.fill(16, &mut random) {
            for (axis, x) in point.into_iter().enumerate() {
                places[axis].push(strata[axis] * x - floor(strata[axis] * x));
            }
        }
    }
    for places in places {
        let p = ks::uniform(&places);
        ensure!(p > each_level(), "p = {p:e}");
    }
    Ok(())
}

/// The level of each statistical test of samplers: 1e-3 for all of them, about ten for each of nine
/// specimens.
pub fn each_level() -> f64 {
    sidak(1e-3, 100)
}
