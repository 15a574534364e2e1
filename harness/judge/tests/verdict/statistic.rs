//! The statistic: ranks are fair, sums are sums.

use groundtruth::film::Film;
use groundtruth::math::Pcg32;
use judge::verdict::{Areas, Evaluation, Evidence, Mean, Pool, PoolContext, Ranking, Strictness};
use statistics::chi_square;

use super::noise::normal as unit;
use super::pictures::{films, scene, world};
use super::shared::FLOATS;

/// Pictures of 9 × 7 pixels whose values are cubes of normal numbers of other sizes: skewed nowhere, heavy-tailed.
fn noise(random: &mut Pcg32) -> Vec<f32> {
    (0..9 * 7 * 3)
        .map(|at| {
            let size = 1.0 + f64::from(at % 5);
            let x = unit(random);
            (10.0 + size * x * x * x) as f32
        })
        .collect()
}

/// Law: of exchangeable pictures the last is as likely to be the farthest out, or the second, third or fourth, as any
/// other, held against the mean of the others or that of pictures outside the pool. (Pictures that are nowhere far out
/// may share a rank.) Oracle: the uniform distribution, χ² at level 1e-3, of two tests.
#[test]
fn each_rank_is_as_likely() {
    for outside in [0, 5] {
        let counts = ranks(outside);
        let p = chi_square::goodness_of_fit(&counts, &[125.0, 125.0, 125.0, 125.0, 500.0]);
        assert!(p > 0.5e-3, "{outside} outside, {counts:?}: p = {p}");
    }
}

/// How often the last of 8 pictures is as far out as 0, 1, 2, 3 or more others, in 1,000 pools that are held against
/// the mean of this many others.
fn ranks(outside: u32) -> [u64; 5] {
    const PICTURES: usize = 8;
    let areas = Areas::tiles([9, 7]);
    let random = &mut Pcg32::new(11, 5);
    let mut counts = [0_u64; 5];
    for _ in 0..1000 {
        let pictures = (0..PICTURES).map(|_| noise(random)).collect();
        let mut mean = vec![0.0; 9 * 7 * 3];
        for _ in 0..outside {
            let values = mean.iter_mut().zip(noise(random));
            values.for_each(|(sum, value)| *sum += f64::from(value) / f64::from(outside));
        }
        let mean = (outside > 0).then(|| Mean { values: mean, pictures: f64::from(outside) });
        let pool = Pool::new([9, 7], FLOATS, pictures).against_mean(mean);
        counts[Ranking::of(&pool, &areas, 0).as_far_as(PICTURES - 1).min(4)] += 1;
    }
    counts
}

/// Law: the same pictures in another unit of radiance are the same evidence: weights are those of its square. Oracle: powers
/// of two, by which all numbers are multiplied without rounding.
#[test]
fn weights_have_the_unit_of_radiance() {
    for name in ["ch03/three-objects", "ch18/rectangle"] {
        let mut world = world(&scene(name, [24, 24], 4), 1);
        let areas = Areas::of(&world);
        let films = films(&mut world, 1..11);
        let weights = |unit: f32| {
            let in_unit = |film: &Film| -> Vec<f32> {
                FLOATS.values(film).into_iter().map(|value| unit * value).collect()
            };
            let mut known: Vec<Vec<f32>> = films[..9].iter().map(in_unit).collect();
            let mut theirs = in_unit(&films[9]);
            theirs[..600].iter_mut().for_each(|value| *value *= 1.25);
            let subject = PoolContext { areas: &areas, stored: FLOATS, reference: None };
            let strictness = Strictness { level: 0.05, first: 9 };
            let judged = Evaluation::of(&theirs, subject, strictness, &mut known, |_| None);
            evidence(&judged.expect("enough"), &areas, &theirs).weights()
        };
        let (whole, small) = (weights(1.0), weights(1.0 / 4096.0));
        assert!(whole.iter().any(|weight| *weight > 0.0), "{name}: nothing has a weight");
        for (index, (a, b)) in whole.iter().zip(&small).enumerate() {
            let b = b / (4096.0 * 4096.0);
            assert!((a - b).abs() <= 1e-9 * a, "{name}, tile {index}: found {b}, expected {a}");
        }
    }
}

/// The evidence of a judgement.
fn evidence<'a>(judged: &Evaluation, areas: &'a Areas, theirs: &[f32]) -> Evidence<'a> {
    let noise = judged.ranking.noise[judged.pool.count() - 1];
    Evidence::of(&judged.pool, noise, areas, theirs)
}
