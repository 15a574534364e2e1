//! Intervals of means, Welch's tests of several pictures and the noise factor, by their definition.

use groundtruth::math::Pcg32;
use judge::verdict::{Area, Areas, Finding, Mean, Means, Pool, Ranking, Strictness, several};
use pictures::compare::Picture;
use statistics::means::{difference, two_samples};

use super::noise::noisy;
use super::shared::FLOATS;
use crate::verbs::{between, equal, near};

/// Columns and rows of small pictures.
const SIZE: [usize; 2] = [3, 2];

const PIXELS: usize = SIZE[0] * SIZE[1];

/// Rounding of sums of a few numbers near 10.
const SUMS: f64 = 1e-9;

/// How often the mean of a correct picture is below, and above, its interval: of all channels, and of green. The confidence is
/// 80 % for both together, so that each holds with 90 %.
fn outside(cases: u32, mut of: impl FnMut() -> Means) -> [[f64; 2]; 2] {
    let mut counts = [[0.0; 2]; 2];
    for _ in 0..cases {
        let means = of();
        let both =
            [(means.relative, means.half), (means.channels[1].relative, means.channels[1].half)];
        for ((relative, half), counts) in both.into_iter().zip(&mut counts) {
            let relative = relative.expect("ours is not black");
            counts[0] += f64::from(u8::from(relative < -half));
            counts[1] += f64::from(u8::from(relative > half));
        }
    }
    counts
}

/// Law: the mean of a correct picture is outside its interval as often as the level says, on either side; also of noise that
/// is twice ours, and against the mean of many others. Oracle: the binomial distribution: of 2,000 at 90 %, 100 are on each
/// side, give or take 9.7; five times that is allowed.
#[test]
fn intervals_of_means_have_their_level() {
    let areas = Areas::tiles(SIZE);
    let random = &mut Pcg32::new(1, 42);
    let slack = vec![0.0; 3 * PIXELS];
    for (times, others) in [(1.0, 0), (2.0, 0), (1.0, 40)] {
        let mut means = || {
            let mut pictures: Vec<Vec<f32>> = (0..5).map(|_| noisy(random, PIXELS, 0.05)).collect();
            pictures.push(noisy(random, PIXELS, 0.05 * times));
            let mut sum = vec![0.0; 3 * PIXELS];
            for _ in 0..others {
                let values = noisy(random, PIXELS, 0.05);
                sum.iter_mut().zip(values).for_each(|(sum, x)| *sum += f64::from(x) / 40.0);
            }
            let mean = (others > 0).then_some(Mean { values: sum, pictures: 40.0 });
            let pool = Pool::new(SIZE, FLOATS, pictures).against_mean(mean);
            Means::of((&pool, pool.picture(5)), None, &areas, (times, &slack), 0.8).swap_remove(0)
        };
        for (name, counts) in ["all", "green"].iter().zip(outside(2_000, &mut means)) {
            for (side, count) in ["below", "above"].iter().zip(counts) {
                let what = format!("{name} {side} the interval, noise × {times}, {others} others");
                near(what, count, 100.0, 48.5);
            }
        }
    }
}

/// Law: the same for several pictures on each side with noise of their own; the interval is Welch's. Oracle: as above, where
/// 20 more are allowed, because Welch's degrees are an estimate; and Welch's interval of the pictures' means.
#[test]
fn intervals_of_several_pictures_have_their_level() {
    let areas = Areas::tiles(SIZE);
    let random = &mut Pcg32::new(2, 42);
    let slack = vec![0.0; 3 * PIXELS];
    // three standard deviations of the mean of values that are rounded to a part of 1e-5
    let rounding = 3.0 * 1e-5 / (12.0 * 3.0 * PIXELS as f64).sqrt();
    let mut outside = [0.0; 2];
    for _ in 0..2_000 {
        let ours: Vec<Vec<f32>> = (0..8).map(|_| noisy(random, PIXELS, 0.05)).collect();
        let theirs: Vec<Vec<f32>> = (0..4).map(|_| noisy(random, PIXELS, 0.1)).collect();
        let sum = |at: usize| theirs.iter().map(|it| f64::from(it[at])).sum::<f64>();
        let mean: Vec<f32> = (0..3 * PIXELS).map(|at| (sum(at) / 4.0) as f32).collect();
        let pool = Pool::new(SIZE, FLOATS, ours.iter().cloned().chain([mean]).collect());
        let (both, held) = ([&*theirs, &*ours], (&pool, pool.picture(8)));
        let means = Means::of(held, Some(both), &areas, (1.0, &slack), 0.8).swap_remove(0);
        let relative = means.relative.expect("ours is not black");
        outside[0] += f64::from(u8::from(relative < -means.half));
        outside[1] += f64::from(u8::from(relative > means.half));
        let of_picture =
            |it: &Vec<f32>| it.iter().copied().map(f64::from).sum::<f64>() / it.len() as f64;
        let [a, b] = [&theirs, &ours].map(|all| all.iter().map(of_picture).collect::<Vec<f64>>());
        let [_, low, high] = difference(&a, &b, 0.9).expect("four and eight");
        let half = 0.5 * (high - low) * 8.0 / b.iter().sum::<f64>();
        near("half of the interval", means.half, half + rounding, 0.01 * rounding);
    }
    outside.iter().for_each(|count| near("means outside", *count, 100.0, 68.5));
}

/// Law: a mean is that of the pixels of its area, and the relative difference is theirs over ours less 1: of all channels and
/// of each. Oracle: sums, area by area.
#[test]
fn means_are_means() {
    let random = &mut Pcg32::new(3, 42);
    let mut areas = Areas::tiles(SIZE);
    areas.object_of = vec![0, 1, 1, 0, 2, 1];
    areas.objects = vec![("a".into(), 2), ("b".into(), 3), ("c".into(), 1)];
    let pictures: Vec<Vec<f32>> = (0..4).map(|_| noisy(random, PIXELS, 0.2)).collect();
    let pool = Pool::new(SIZE, FLOATS, pictures.clone());
    let all = Means::of((&pool, pool.picture(3)), None, &areas, (1.0, &[0.0; 3 * PIXELS]), 0.99);
    let expected = [
        ("the picture", vec![0, 1, 2, 3, 4, 5]),
        ("a", vec![0, 3]),
        ("b", vec![1, 2, 5]),
        ("c", vec![4]),
    ];
    equal("number of areas", all.len(), expected.len());
    for (means, (name, pixels)) in all.iter().zip(expected) {
        equal("area", (&*means.name, means.pixels), (name, pixels.len()));
        let of = |pictures: &[Vec<f32>], channel: usize| {
            let values = pictures
                .iter()
                .flat_map(|it| pixels.iter().map(move |at| f64::from(it[3 * at + channel])));
            values.sum::<f64>() / (pictures.len() * pixels.len()) as f64
        };
        let (mut ours, mut theirs) = (0.0, 0.0);
        for channel in 0..3 {
            let [a, b] = [of(&pictures[..3], channel), of(&pictures[3..], channel)];
            near(format!("{name}: ours"), means.ours[channel], a, SUMS);
            near(format!("{name}: theirs"), means.theirs[channel], b, SUMS);
            let relative = means.channels[channel].relative.expect("not black");
            near(format!("{name}: relative"), relative, b / a - 1.0, SUMS);
            (ours, theirs) = (ours + a, theirs + b);
        }
        let relative = means.relative.expect("not black");
        near(format!("{name}: relative, of all channels"), relative, theirs / ours - 1.0, SUMS);
    }
}

/// Law: the probabilities of Welch's tests of several pictures are those of Holm's procedure. Oracle: closed testing: the
/// adjusted probability of a test is the largest, over all sets of tests that it is in, of the number of the set times its
/// least probability (Marcus, Peritz & Gabriel, "On closed testing procedures", 1976).
#[test]
fn probabilities_of_several_are_those_of_closed_testing() {
    let areas = Areas::tiles([2, 1]);
    let random = &mut Pcg32::new(4, 42);
    for case in 0..12 {
        let mut pictures = |count: usize, gain: f32| -> Vec<Vec<f32>> {
            let one = |random: &mut Pcg32| {
                noisy(random, 2, 0.02)
                    .iter()
                    .enumerate()
                    .map(|(at, x)| if at == 1 { gain * x } else { *x })
                    .collect()
            };
            (0..count).map(|_| one(random)).collect()
        };
        let (theirs, ours) = (pictures(3 + case % 3, [1.0, 1.05, 1.2][case % 3]), pictures(5, 1.0));
        let raw = |area: Area, channel: usize| {
            let pixels = areas.pixels(area);
            let mean = |it: &Vec<f32>| {
                pixels.iter().map(|at| f64::from(it[3 * at + channel])).sum::<f64>()
                    / pixels.len() as f64
            };
            let [a, b] = [&theirs, &ours].map(|all| all.iter().map(mean).collect::<Vec<f64>>());
            two_samples(&a, &b)
        };
        let found = several(&theirs, &ours, &areas);
        // two pixels, the picture, and the object that is the whole picture
        equal("number of tests", found.len(), 3 * 4);
        let raw: Vec<f64> = found.iter().map(|test| raw(test.area, test.channel)).collect();
        for (index, test) in found.iter().enumerate() {
            let sets = (1_u32..1 << raw.len()).filter(|set| set >> index & 1 == 1);
            let of_set = |set: u32| {
                let least = (0..raw.len())
                    .filter(|at| set >> at & 1 == 1)
                    .map(|at| raw[at])
                    .fold(1.0, f64::min);
                (f64::from(set.count_ones()) * least).min(1.0)
            };
            let adjusted = sets.map(of_set).fold(0.0, f64::max);
            near(format!("{:?}", test.area), test.probability, adjusted, 1e-12);
        }
        assert!(found.windows(2).all(|two| two[0].probability <= two[1].probability), "in order");
    }
}

/// Law: the noise factor of a picture is found to 2 % (¼ and 4 to 6 %), with few or many of ours, or the mean of others; also
/// if single pixels are bright, in theirs and in ours. Oracle: the factor of normal noise in 12,288 blocks, which chance
/// changes by 0.8 %.
#[test]
fn twice_the_noise_is_twice() {
    const SIDE: usize = 128;
    let areas = Areas::tiles([SIDE; 2]);
    let random = &mut Pcg32::new(6, 42);
    for (count, outside) in [(8, 0), (20, 0), (8, 50)] {
        let of = |noise: f64, random: &mut Pcg32| -> Vec<f32> {
            let values = noisy(random, SIDE * SIDE, noise);
            values
                .into_iter()
                .map(|x| if random.below(3_000) == 0 { 40.0 * x } else { x })
                .collect()
        };
        let known: Vec<Vec<f32>> = (0..count).map(|_| of(0.05, random)).collect();
        let mean = (outside > 0).then(|| {
            let deviation = 0.05 / f64::from(outside).sqrt();
            let values = noisy(random, SIDE * SIDE, deviation).into_iter().map(f64::from).collect();
            Mean { values, pictures: f64::from(outside) }
        });
        for (factor, allowed) in [(0.25, 0.06), (0.5, 0.02), (1.0, 0.02), (2.0, 0.02), (4.0, 0.06)]
        {
            let pictures = known.iter().cloned().chain([of(0.05 * factor, random)]).collect();
            let pool = Pool::new([SIDE; 2], FLOATS, pictures).against_mean(mean.clone());
            let found = Ranking::of(&pool, &areas, areas.levels() - 1).noise[count];
            near(
                format!("{factor} times the noise of {count}, {outside} outside"),
                found / factor,
                1.0,
                allowed,
            );
        }
    }
}

/// Law: an area of several pictures differs if its probability is at most the level. Oracle: the least probability of the
/// tests as level, and a little less.
#[test]
fn the_level_is_a_border() {
    let areas = Areas::tiles(SIZE);
    let random = &mut Pcg32::new(7, 42);
    let ours: Vec<Vec<f32>> = (0..8).map(|_| noisy(random, PIXELS, 0.05)).collect();
    // pixels are too bright or too dark by turns, so that the mean of the picture stays
    let theirs: Vec<Vec<f32>> = (0..4)
        .map(|_| {
            let gain = |at: usize| if (at / 3).is_multiple_of(2) { 1.12 } else { 0.88 };
            noisy(random, PIXELS, 0.05).iter().enumerate().map(|(at, x)| gain(at) * x).collect()
        })
        .collect();
    let tests = several(&theirs, &ours, &areas);
    let least = tests[0].probability;
    between("least probability", least, [1e-9, 0.5]);
    let read: Vec<Picture> = theirs
        .iter()
        .map(|it| Picture::of_radiance(it, [SIZE[0] as u32, SIZE[1] as u32]))
        .collect();
    for (level, differs) in [(least, true), (least * 0.999, false)] {
        let strictness = Strictness { level, first: 8 };
        let subject = (FLOATS, &areas, strictness);
        let slack = [0.0; 3 * PIXELS];
        let found = Finding::of_several(subject, [&theirs, &ours], &tests, &slack, &read);
        let verdict = found.verdict(&areas, strictness);
        equal(format!("regions at level {level}"), !verdict.regions.is_empty(), differs);
    }
}
