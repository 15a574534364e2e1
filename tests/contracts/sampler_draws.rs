//! The contract of the draws from the sets of a [`Sampler`](groundtruth::samplers::Sampler) (Suffern,
//! ch. 5).

use std::collections::BTreeSet;

use groundtruth::math::{Pcg32, floor};
use groundtruth::samplers::{Kind, Purpose, SETS, SampleSets, SetKey};
use statistics::chi_square;
use statistics::ks;

use super::sampler::{built, each_level, is_fixed};
use super::{Holds, ensure};

/// Law: a single draw of a kind that is random is uniform over the square, whatever its index: over all seeds
/// nothing of the pattern remains. Oracle: the Kolmogorov–Smirnov test for x and for y, χ² for 5 × 5 cells,
/// which are not strata of the pattern. An error of the density of 18 % is found.
pub fn a_draw_is_uniform_over_the_square(kind: &Kind) -> Holds {
    const SEEDS: u32 = 2000;
    let sampler = built(kind);
    if is_fixed(kind) && !sampler.is_shifted() {
        return Ok(());
    }
    for n in [1, 16] {
        let draw = |seed: u32| {
            let key = SetKey::new(seed.into(), [seed % 7, 3], Purpose::Pixel);
            SampleSets::new(&*sampler, n, seed.into()).draw(key, seed % n)
        };
        let draws: Vec<[f64; 2]> = (0..SEEDS).map(draw).collect();
        for axis in 0..2 {
            let p = ks::uniform(&draws.iter().map(|draw| draw[axis]).collect::<Vec<_>>());
            ensure!(p > each_level(), "{n} points, axis {axis}: p = {p:e}");
        }
        let mut cells = [0; 25];
        for [x, y] in draws {
            cells[(floor(5.0 * x) + 5.0 * floor(5.0 * y)) as usize] += 1;
        }
        let p = chi_square::goodness_of_fit(&cells, &[f64::from(SEEDS) / 25.0; 25]);
        ensure!(p > each_level(), "{n} points, cells: p = {p:e}");
    }
    Ok(())
}

/// Law: each run of `per_set` draws returns every point of one set exactly once, and the next run
/// those of another set; if draws are shifted, all by the same vector. Oracle: the sets filled here
/// with the same generator.
pub fn a_run_of_draws_uses_up_one_set(kind: &Kind) -> Holds {
    let sampler = built(kind);
    for n in [1, 4, 10] {
        let sets = SampleSets::new(&*sampler, n, 3);
        let per_set = sets.per_set();
        ensure!(per_set == sampler.round_up(n), "{per_set} in a set of {n}");
        // the same sets: like SampleSets, shuffle as many indices after each fill
        let mut random = Pcg32::new(3, 0);
        let mut known = Vec::new();
        for _ in 0..SETS {
            known.push(sampler.fill(per_set, &mut random));
            random.shuffle(&mut (0..per_set).collect::<Vec<u32>>());
        }
        let mut used = BTreeSet::new();
        let mut shifts = BTreeSet::new();
        for x in 0..50 {
            let key = SetKey::new(3, [x, 7], Purpose::Pixel);
            for run in 0..3 {
                let draws: Vec<_> =
                    (0..per_set).map(|i| sets.draw(key, run * per_set + i)).collect();
                let shift = |set: &Vec<[f64; 2]>| match sampler.is_shifted() {
                    true => common_shift(set, &draws),
                    false => (bits(set) == bits(&draws)).then_some([0.0; 2]),
                };
                let found = known.iter().enumerate().find_map(|(i, set)| Some((i, shift(set)?)));
                let Some((set, shift)) = found else {
                    return Err(format!("pixel {x}, run {run}: not one of the 83 sets"));
                };
                used.insert(set);
                shifts.insert(shift.map(f64::to_bits));
            }
        }
        // 150 choices of 83 sets leave about 13 out
        let enough = used.len() > 50 || is_fixed(kind);
        ensure!(enough, "only {} sets are used", used.len());
        ensure!(!sampler.is_shifted() || shifts.len() == 150, "{} shifts", shifts.len());
    }
    Ok(())
}

/// The vector by which these draws are the points of this set, moved across the edges of the square.
fn common_shift(set: &[[f64; 2]], draws: &[[f64; 2]]) -> Option<[f64; 2]> {
    /// Two sums of numbers below 2.
    const ROUNDING: f64 = 1e-15;
    let apart = |a: f64, b: f64| (a - b) - floor(a - b);
    // the first draw is one of the points: try each of them
    set.iter().map(|p| [apart(draws[0][0], p[0]), apart(draws[0][1], p[1])]).find(|shift| {
        let is_moved = |p: &[f64; 2], draw: &[f64; 2]| {
            (0..2).all(|axis| {
                let rest = apart(p[axis] + shift[axis], draw[axis]);
                rest.min(1.0 - rest) <= ROUNDING
            })
        };
        set.iter().all(|p| draws.iter().filter(|draw| is_moved(p, draw)).count() == 1)
    })
}

fn bits(points: &[[f64; 2]]) -> Vec<[u64; 2]> {
    let mut bits: Vec<_> = points.iter().map(|p| p.map(f64::to_bits)).collect();
    bits.sort_unstable();
    bits
}

/// Law: the same key and index give the same point, in any order; another seed, column, row or run gives
/// other points.
pub fn draws_are_pure(kind: &Kind) -> Holds {
    let sampler = built(kind);
    let (sets, again) = (SampleSets::new(&*sampler, 16, 1), SampleSets::new(&*sampler, 16, 1));
    let key = |seed: u64, x: u32, y: u32| SetKey::new(seed, [x, y], Purpose::Pixel);
    let draws = |key: SetKey, start: u32| -> Vec<[f64; 2]> {
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
