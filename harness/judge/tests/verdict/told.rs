//! Numbers that are told of a picture: each is recomputed from what it is of.

use groundtruth::math::Pcg32;
use judge::verdict::{
    Areas, DifferenceKind, DifferingRegion, Evaluation, Finding, Map, Pool, PoolContext, Ranking,
    Strictness, Verdict, smallest_gains,
};
use pictures::compare::Picture;
use text::percent::of_pixels;

use super::noise::noisy;
use super::shared::FLOATS;
use crate::verbs::{between, equal, near};

/// A pool of five pictures with noise of this part of the mean, the last of which has these gains of its channels.
fn pool(random: &mut Pcg32, size: [usize; 2], noise: f64, gains: [f32; 3]) -> Pool {
    let pixels = size[0] * size[1];
    let mut pictures: Vec<Vec<f32>> = (0..5).map(|_| noisy(random, pixels, noise)).collect();
    (0..).zip(&mut pictures[4]).for_each(|(at, value): (usize, _)| *value *= gains[at % 3]);
    Pool::new(size, FLOATS, pictures)
}

/// Law: a region has the box of its pixels, the mean of theirs and of ours over them, and as its worst the pixel that is
/// farthest off, with either sign; it is called after the object that most of its pixels show. Oracle: the pixels, one by one.
#[test]
fn regions_have_the_box_of_their_pixels() {
    const SIZE: [usize; 2] = [7, 5];
    let random = &mut Pcg32::new(1, 61);
    let mut areas = Areas::tiles(SIZE);
    areas.object_of = (0..35).map(|at| u32::from(at % 7 >= 3)).collect();
    areas.objects = vec![("left".into(), 15), ("right".into(), 20)];
    for case in 0..40 {
        let pool = pool(random, SIZE, 0.1, [1.0; 3]);
        let mut pixels: Vec<usize> = (0..35).filter(|_| random.below(4) == 0).collect();
        if pixels.is_empty() {
            pixels.push(case % 35);
        }
        let shown = pool.picture(4);
        let found = DifferingRegion::of_pixels(&pool, &areas, &pixels, shown);
        let along = |of: fn(usize) -> usize| {
            let all = || pixels.iter().map(|at| of(*at));
            let [least, most] = [all().min(), all().max()].map(|it| it.expect("some"));
            (least, 1 + most - least)
        };
        let ((x, w), (y, h)) = (along(|at| at % 7), along(|at| at / 7));
        equal("box", found.bounds, [x, y, w, h]);
        let mean = |of: &dyn Fn(usize) -> f64| {
            pixels.iter().map(|at| of(*at)).sum::<f64>() / pixels.len() as f64
        };
        let ours = |at: usize| (0..4).map(|it| f64::from(pool.picture(it)[at])).sum::<f64>() / 4.0;
        for channel in 0..3 {
            near("mean of ours", found.ours[channel], mean(&|at| ours(3 * at + channel)), 1e-9);
            near(
                "mean of theirs",
                found.theirs[channel],
                mean(&|at| f64::from(shown[3 * at + channel])),
                1e-9,
            );
        }
        let apart = |at: usize| {
            (3 * at..3 * at + 3)
                .map(|it| (f64::from(shown[it]) - ours(it)).abs())
                .fold(0.0, f64::max)
        };
        let most = pixels.iter().map(|at| apart(*at)).fold(0.0, f64::max);
        near("difference of the worst", apart(found.worst[1] * 7 + found.worst[0]), most, 1e-9);
        let left = pixels.iter().filter(|at| *at % 7 < 3).count();
        if 2 * left != pixels.len() {
            let object = if 2 * left > pixels.len() { "left" } else { "right" };
            let word = if pixels.len() == 1 { "pixel" } else { "pixels" };
            equal("name", &*found.name, &*format!("{} {word} of {object}", pixels.len()));
        }
    }
}

/// The verdict on the last picture of a pool.
fn verdict(pool: &Pool, areas: &Areas, level: f64) -> Verdict {
    let mut known: Vec<Vec<f32>> = (0..4).map(|it| pool.picture(it).to_vec()).collect();
    let strictness = Strictness { level, first: 4 };
    let subject = PoolContext { areas, stored: FLOATS, reference: None };
    let judged = Evaluation::of(pool.picture(4), subject, strictness, &mut known, |_| None);
    let size = areas.size.map(|side| side as u32);
    let (theirs, slack) = (pool.picture(4), vec![0.0; pool.picture(4).len()]);
    let (judged, shown) = (judged.expect("enough"), (theirs.to_vec(), Vec::new()));
    let picture = Picture::of_radiance(theirs, size);
    Finding::of(judged, (areas, strictness), shown, &slack, &picture).verdict(areas, strictness)
}

/// Law: a picture that differs by its mean alone is told with that percentage, too dark or too bright, and never agrees; the
/// areas beyond a margin are those whose interval reaches beyond it. Oracle: the means.
#[test]
fn a_mean_outside_is_told() {
    let random = &mut Pcg32::new(4, 61);
    let areas = Areas::tiles([8, 8]);
    let mut told = 0;
    for gain in [0.97, 0.99, 1.01, 1.03] {
        // of so few pictures the rank says nothing at this level
        let found = verdict(&pool(random, [8, 8], 0.02, [gain; 3]), &areas, 0.2);
        for margin in [0.001, 0.005, 0.011, 0.02, 0.04] {
            let mut held = found.clone();
            held.hold_to(margin);
            let text = held.to_string();
            for means in &held.means {
                let relative = means.relative.expect("not black");
                let is_beyond = relative.abs() + means.half > margin;
                let line = format!("  {}, ", means.name);
                equal(
                    format!("`{line}` is beyond {margin} in {text}"),
                    text.contains(&line),
                    is_beyond,
                );
            }
        }
        if found.decided_by.is_some() {
            let relative = found.means[0].relative.expect("not black");
            let direction = if relative < 0.0 { "dark" } else { "bright" };
            let words = format!("is too {direction}, by {} on average", of_pixels(relative.abs()));
            assert!(
                found.sentence().contains(&words),
                "expected `{words}`, found {}",
                found.sentence()
            );
            told += 1;
        }
    }
    between("verdicts by the mean alone", f64::from(told), [1.0, 4.0]);
}

/// Law: with the smallest gain that is promised for tiles of a side, a picture without noise of its own is just farther out
/// than all of ours, in the tile of median noise. Oracle: the gain, planted in the mean of ours; the noise of the pool's last
/// picture has a part in the variance, for which a half is allowed.
#[test]
fn the_promised_gain_stands_out() {
    const SIDE: usize = 32;
    let areas = Areas::tiles([SIDE; 2]);
    let random = &mut Pcg32::new(5, 61);
    for noise in [0.01, 0.04] {
        // a quarter of the picture has six times the noise; the median tile is outside of it; green has a third
        let factor = |at: usize| {
            let wild = if at / 3 % SIDE >= 24 { 6.0 } else { 1.0 };
            if at % 3 == 1 { wild / 3.0 } else { wild }
        };
        let mut one = || -> Vec<f32> {
            let values = noisy(random, SIDE * SIDE, noise);
            (0..).zip(values).map(|(at, x)| 10.0 + factor(at) * (x - 10.0)).collect()
        };
        let pictures: Vec<Vec<f32>> = (0..12).map(|_| one()).collect();
        let pool = Pool::new([SIDE; 2], FLOATS, pictures.clone());
        let ranking = Ranking::of(&pool, &areas, 0);
        let limits: Vec<(usize, f64)> = ranking.limits(11).collect();
        let gains = smallest_gains(&pool, &areas, &ranking);
        equal("sides of tiles", [gains.len(), limits.len()], [1 + SIDE.ilog2() as usize; 2]);
        for ((side, gain), (of_limit, limit)) in gains.into_iter().zip(limits) {
            equal("side", side, of_limit);
            let gain = gain.expect("there is noise and light");
            let level = side.trailing_zeros() as usize;
            let mean =
                |at: usize| (0..11).map(|it| f64::from(pictures[it][at])).sum::<f64>() / 11.0;
            let planted = (0..3 * SIDE * SIDE).map(|at| (mean(at) * (1.0 + gain)) as f32).collect();
            let with = pictures[..11].iter().cloned().chain([planted]).collect();
            let map = Map::of(&Pool::new([SIDE; 2], FLOATS, with), &areas, 11, 1.0);
            let sums = map.sums(&areas, &[DifferenceKind::Tiles(level)]);
            let all: Vec<f64> = sums[0].differences(&areas).map(|it| it.z).collect();
            // of each tile, the channel that is farthest out
            let tiles = all.len() / 3;
            let farthest =
                |tile: usize| all[tile].max(all[tiles + tile]).max(all[2 * tiles + tile]);
            let mut z: Vec<f64> = (0..tiles).map(farthest).collect();
            z.sort_by(f64::total_cmp);
            let median = z[z.len() / 2];
            between(
                format!("noise {noise}, side {side}: z of the gain over the limit"),
                median / limit,
                [0.75, 1.5],
            );
        }
    }
}
