//! The contract of [`Sampler`] and of the sets made of it (Suffern, ch. 5).

use std::sync::Arc;

use groundtruth::math::{Pcg32, floor};
use groundtruth::samplers::{Key, Kind, Purpose, SampleSets, Sampler};
use groundtruth::verify::ks;
use groundtruth::verify::significance::sidak;
use libtest_mimic::Trial;

use super::{Holds, ensure};

pub fn trials() -> Vec<Trial> {
    super::trials(
        Kind::ENTRIES,
        &[
            ("points_lie_in_the_unit_square", points_lie_in_the_unit_square),
            ("a_set_has_as_many_points_as_it_says", a_set_has_as_many_points_as_it_says),
            ("points_are_spread_as_promised", points_are_spread_as_promised),
            ("places_in_a_stratum_are_uniform", places_in_a_stratum_are_uniform),
            ("a_run_of_draws_uses_up_one_set", a_run_of_draws_uses_up_one_set),
            ("draws_are_pure_and_depend_on_every_part_of_the_key", draws_are_pure),
        ],
    )
}

fn built(kind: &Kind) -> Arc<dyn Sampler> {
    kind.build(&mut ()).expect("specimens are valid")
}

const COUNTS: [u32; 8] = [1, 2, 3, 4, 9, 10, 25, 256];

fn points_lie_in_the_unit_square(kind: &Kind) -> Holds {
    let sampler = built(kind);
    let mut random = Pcg32::new(5, 0);
    for n in COUNTS {
        for _ in 0..20 {
            for point in sampler.fill(sampler.round_up(n), &mut random) {
                let inside = point.iter().all(|x| (0.0..1.0).contains(x));
                ensure!(inside, "{point:?} of {n}");
            }
        }
    }
    Ok(())
}

/// Law: `round_up(n)` is at least `n`, rounds up no further, and `fill` makes as many points.
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

/// What a kind promises about `n` points.
struct Promise {
    /// One point in each cell of a `√n × √n` grid.
    cells: bool,
    /// One point in each of `n` rows and of `n` columns.
    rows: bool,
}

fn promise(kind: &Kind) -> Promise {
    match kind {
        Kind::Regular(_) | Kind::Jittered(_) => Promise { cells: true, rows: false },
        Kind::MultiJittered(_) => Promise { cells: true, rows: true },
        _ => Promise { cells: false, rows: false },
    }
}

/// Law: each stratum that the kind promises to fill has exactly one point.
fn points_are_spread_as_promised(kind: &Kind) -> Holds {
    let sampler = built(kind);
    let promise = promise(kind);
    let mut random = Pcg32::new(5, 2);
    for n in [1, 4, 9, 16, 25, 256] {
        let points = sampler.fill(n, &mut random);
        let strata = |columns: u32, rows: u32| -> bool {
            let mut counts = vec![0; (columns * rows) as usize];
            for [x, y] in &points {
                let column = floor(x * f64::from(columns)) as usize;
                let row = floor(y * f64::from(rows)) as usize;
                counts[row * columns as usize + column] += 1;
            }
            counts.iter().all(|&count| count == 1)
        };
        let side = n.isqrt();
        ensure!(!promise.cells || strata(side, side), "{n} points do not fill {side} × {side}");
        ensure!(!promise.rows || strata(n, 1), "{n} points do not fill {n} columns");
        ensure!(!promise.rows || strata(1, n), "{n} points do not fill {n} rows");
    }
    Ok(())
}

/// Law: where in its finest stratum a point lies is uniform and independent, for kinds that are
/// random. Oracle: Kolmogorov and Smirnov; a distribution function off by 4 % is found.
fn places_in_a_stratum_are_uniform(kind: &Kind) -> Holds {
    const LEVEL: f64 = 1e-3;
    const TESTS: usize = 20;
    if let Kind::Regular(_) = kind {
        return Ok(()); // it has no choice
    }
    let sampler = built(kind);
    let strata = match promise(kind) {
        Promise { rows: true, .. } => 16.0,
        Promise { cells: true, .. } => 4.0,
        _ => 1.0,
    };
    let mut random = Pcg32::new(5, 3);
    let mut places = [Vec::new(), Vec::new()];
    for _ in 0..1000 {
        for point in sampler.fill(16, &mut random) {
            for (places, x) in places.iter_mut().zip(point) {
                places.push(strata * x - floor(strata * x));
            }
        }
    }
    for places in places {
        let p = ks::uniform(&places);
        ensure!(p > sidak(LEVEL, TESTS), "p = {p:e}");
    }
    Ok(())
}

fn bits(points: impl IntoIterator<Item = [f64; 2]>) -> Vec<[u64; 2]> {
    let mut bits: Vec<_> = points.into_iter().map(|p| p.map(f64::to_bits)).collect();
    bits.sort_unstable();
    bits
}

/// Law: each run of `per_set` draws returns every point of one set exactly once, and the next run
/// those of another set. Oracle: the sets filled here with the same generator.
fn a_run_of_draws_uses_up_one_set(kind: &Kind) -> Holds {
    let sampler = built(kind);
    for n in [1, 4, 10] {
        let sets = SampleSets::new(&*sampler, n, 3);
        let per_set = sets.per_set();
        ensure!(per_set == sampler.round_up(n), "{per_set} in a set of {n}");
        // the same sets: SampleSets shuffles as many indices after each fill
        let mut random = Pcg32::new(3, 0);
        let mut known = Vec::new();
        for _ in 0..83 {
            known.push(bits(sampler.fill(per_set, &mut random)));
            random.shuffle(&mut (0..per_set).collect::<Vec<u32>>());
        }
        let mut used = std::collections::BTreeSet::new();
        for x in 0..50 {
            let key = Key::new(3, [x, 7], Purpose::Pixel);
            for run in 0..3 {
                let draws = (0..per_set).map(|i| sets.draw(key, run * per_set + i));
                let draws = bits(draws);
                let set = known.iter().position(|set| *set == draws);
                ensure!(set.is_some(), "pixel {x}, run {run}: not one of the 83 sets");
                used.insert(set);
            }
        }
        // 150 choices of 83 sets leave about 13 out; sets of a regular grid are all the same
        let enough = used.len() > 50 || matches!(kind, Kind::Regular(_));
        ensure!(enough, "only {} sets are used", used.len());
    }
    Ok(())
}

/// Law: the same key and index give the same point, in any order; another seed, column, row or run
/// gives others.
fn draws_are_pure(kind: &Kind) -> Holds {
    let sampler = built(kind);
    let (sets, again) = (SampleSets::new(&*sampler, 16, 1), SampleSets::new(&*sampler, 16, 1));
    let key = |seed: u64, x: u32, y: u32| Key::new(seed, [x, y], Purpose::Pixel);
    let draws = |key: Key, start: u32| -> Vec<[f64; 2]> {
        (start..start + 64).map(|i| sets.draw(key, i)).collect()
    };
    let here = draws(key(1, 3, 5), 0);
    for i in (0..64).rev() {
        let draw = again.draw(key(1, 3, 5), i);
        ensure!(draw == here[i as usize], "draw {i} depends on those before it");
    }
    for (what, other) in [
        ("seed", draws(key(2, 3, 5), 0)),
        ("column", draws(key(1, 4, 5), 0)),
        ("row", draws(key(1, 3, 4), 0)),
        ("columns and rows exchanged", draws(key(1, 5, 3), 0)),
        ("run", draws(key(1, 3, 5), 16)),
    ] {
        ensure!(other != here, "the draws do not depend on the {what}");
    }
    Ok(())
}
