//! Sets by their definition: probabilities, intervals, noise, and sums of areas.

use std::sync::atomic::AtomicBool;

use groundtruth::math::Pcg32;
use judge::sets::{
    AreaMeans, AreaSums, Design, Divisions, Method, Rank, SetsDecision, SumKind, Watch,
};
use judge::verdict::{Answer, Areas};
use pictures::compare::Picture;
use statrs::distribution::{ContinuousCDF, StudentsT};

use super::synthetic::{verdict, verdict_at};
use crate::verbs::{equal, near};
use crate::verdict::noise::normal;

/// The tiles of each level, by their pixels, with the number of tests in the level: one for each tile and channel.
fn areas_by_hand([width, height]: [usize; 2]) -> Vec<(usize, Vec<Vec<usize>>)> {
    let mut levels = Vec::new();
    let mut side = 1;
    loop {
        let of = |x: usize, y: usize| -> Vec<usize> {
            let rows = (y..(y + side).min(height))
                .flat_map(|row| (x..(x + side).min(width)).map(move |x| [x, row]));
            rows.map(|[x, row]| row * width + x).collect()
        };
        let corners =
            (0..height).step_by(side).flat_map(|y| (0..width).step_by(side).map(move |x| [x, y]));
        let tiles: Vec<Vec<usize>> = corners.map(|[x, y]| of(x, y)).collect();
        levels.push((3 * tiles.len(), tiles));
        if side >= width.max(height) {
            return levels;
        }
        side *= 2;
    }
}

/// Law: the probability is the share of all divisions (or signs) whose most improbable area is at least as improbable as that
/// of the given one: Westfall and Young's. Oracle: each division added up anew from the pixels, over tiles of every side and
/// the region that is the whole picture; Student's t with the mean of two variances, that of the sums and that of pixels.
#[test]
fn the_probability_is_the_share_of_divisions_as_far_out() {
    const SIZE: [usize; 2] = [3, 2];
    let (areas, pixels) = (Areas::tiles(SIZE), SIZE[0] * SIZE[1]);
    let random = &mut Pcg32::new(1, 51);
    let never = AtomicBool::new(false);
    for case in 0..24 {
        let is_pairs = case % 2 == 1;
        let (divisions, design, count) = match is_pairs {
            false => (Divisions::sets([3, 4], 1000), Design::means([3, 4]), 7),
            true => (Divisions::signs(6, 1000), Design::differences(6), 6),
        };
        let mut values: Vec<Vec<f64>> =
            (0..count).map(|_| (0..3 * pixels).map(|_| normal(random)).collect()).collect();
        // some of them differ, in a pixel or everywhere
        for (index, picture) in values.iter_mut().enumerate() {
            let shift = if is_pairs || index < 3 { [0.0, 1.0, 2.5][case / 2 % 3] } else { 0.0 };
            let upto = if case % 4 < 2 { 3 } else { 3 * pixels };
            picture[..upto].iter_mut().for_each(|x| *x += shift);
        }
        if !is_pairs {
            for at in 0..3 * pixels {
                let mean = values.iter().map(|it| it[at]).sum::<f64>() / f64::from(count);
                values.iter_mut().for_each(|it| it[at] -= mean);
            }
        }
        let (mean, variance) = (vec![0.0; 3 * pixels], vec![1.3; 3 * pixels]);
        let sums = AreaSums::of(values.iter().cloned(), [&mean, &variance], &areas, design);
        let watch = Watch { tried: &|| (), interrupted: &never };
        let rank = Rank::of(&sums, &divisions, watch, 0.05);

        let (between, freedom) = if is_pairs { (6.0, 5.0) } else { (12.0 / 7.0, 5.0) };
        let student = StudentsT::new(0.0, 1.0, 2.0 * freedom).expect("it is one");
        let mut levels = areas_by_hand(SIZE);
        // the region that is the whole picture
        levels.push((3, vec![(0..pixels).collect()]));
        let score = |weights: &Vec<f64>| {
            let mut most = f64::MIN;
            for (number, tiles) in &levels {
                for (tile, channel) in
                    tiles.iter().flat_map(|tile| (0..3).map(move |channel| (tile, channel)))
                {
                    let of = |it: &Vec<f64>| {
                        tile.iter().map(|pixel| it[3 * pixel + channel]).sum::<f64>()
                    };
                    let all: Vec<f64> = values.iter().map(of).collect();
                    let difference: f64 =
                        all.iter().zip(weights).map(|(sum, weight)| sum * weight).sum();
                    let square = between * difference * difference;
                    let left = all.iter().map(|sum| sum * sum).sum::<f64>() - square;
                    let variance = 0.5 * (left / freedom + 1.3 * tile.len() as f64);
                    let p = 2.0 * student.sf((square / variance).sqrt());
                    most = most.max(-groundtruth::math::ln(*number as f64 * p));
                }
            }
            most
        };
        let scores: Vec<f64> = divisions.weights.iter().map(score).collect();
        let as_far = scores.iter().filter(|score| **score >= scores[0] - 1e-9).count();
        let expected = as_far as f64 / scores.len() as f64;
        near(format!("case {case}: probability"), rank.probability, expected, 1e-9);
        // a level of 5 % of 35 divisions or 32 signs lets one other be as far out: the farthest
        let farthest = scores[1..].iter().copied().fold(f64::MIN, f64::max);
        let needed = design.score(rank.needed[0], levels[0].0);
        near(format!("case {case}: score that is needed"), needed, farthest, 1e-3 * farthest.abs());
    }
}

/// Law: Student's t that is needed for a score has this score, and more has a higher one. Oracle: the score itself.
#[test]
fn the_needed_t_has_its_score() {
    for design in [Design::means([5, 5]), Design::means([3, 9]), Design::differences(7)] {
        for t in [0.1, 1.0, 3.3, 20.0] {
            for count in [1, 12, 4000] {
                let score = design.score(t, count);
                near("t of a score", design.t_of_score(score, count), t, 1e-6 * t);
                assert!(design.score(1.001 * t, count) > score, "a larger t has a larger score");
            }
        }
    }
    // nm/(n + m), n + m − 2; k, k − 1
    let (means, differences) = (Design::means([4, 6]), Design::differences(8));
    near("between of means", means.between, 2.4, 1e-12);
    near("freedom of means", means.freedom, 8.0, 0.0);
    near("between of differences", differences.between, 8.0, 0.0);
    near("freedom of differences", differences.freedom, 7.0, 0.0);
}

const SIZE: [u32; 2] = [16, 16];

/// Pictures with the mean 1 and normal noise.
fn pictures(random: &mut Pcg32, count: usize, noise: f64, gain: f64) -> Vec<Picture> {
    let one = |random: &mut Pcg32| {
        let values: Vec<f32> = (0..3 * 256)
            .map(|at| (gain * (1.0 + 0.01 * f64::from(at % 7) + noise * normal(random))) as f32)
            .collect();
        Picture::of_radiance(&values, SIZE)
    };
    (0..count).map(|_| one(random)).collect()
}

/// Law: the interval of the difference of means leaves out the true one as often as the level says, on either side, for sets
/// and for pairs with equal seeds. Oracle: the binomial distribution: of 300 at 10 %, 15 are left out on each side, give or
/// take 3.8; four times that is allowed.
#[test]
fn intervals_of_sets_have_their_level() {
    let random = &mut Pcg32::new(2, 51);
    let mut outside = [[0.0; 2]; 2];
    for _ in 0..300 {
        let before = pictures(random, 4, 0.1, 1.0);
        let after = pictures(random, 5, 0.1, 1.1);
        // the same seeds: 1.1 times the noise before, and some of their own
        let mut paired = before.clone();
        for picture in &mut paired {
            picture
                .values
                .as_flattened_mut()
                .iter_mut()
                .for_each(|x| *x = (1.1 * f64::from(*x) + 0.02 * normal(random)) as f32);
        }
        for (which, after) in [after, paired].iter().enumerate() {
            let found = verdict_at([&before, after], None, 0.1);
            let [_, low, high] = found.means[0].relative.expect("not black");
            // relative to the mean before, which is known to a hundredth of the interval's width
            outside[which][0] += f64::from(u8::from(0.1 < low));
            outside[which][1] += f64::from(u8::from(0.1 > high));
        }
    }
    for (name, counts) in ["sets", "pairs"].iter().zip(outside) {
        near(format!("{name}: truths below the interval"), counts[0], 15.0, 15.0);
        near(format!("{name}: truths above the interval"), counts[1], 15.0, 15.0);
        assert!(
            counts[0] + counts[1] >= 12.0,
            "{name}: found {counts:?} outside, expected 30 together"
        );
    }
}

/// Law: pictures that have the same noise in one quarter and none elsewhere are pairs, whichever quarter it is. Oracle: the
/// noise that was copied.
#[test]
fn equal_seeds_are_seen_in_every_quarter() {
    let random = &mut Pcg32::new(4, 51);
    for quarter in 0..4 {
        let mut before = pictures(random, 4, 0.0, 1.0);
        for picture in &mut before {
            for (at, value) in picture.values.as_flattened_mut().iter_mut().enumerate() {
                let [x, y] = [at / 3 % 16, at / 3 / 16];
                if y / 8 * 2 + x / 8 == quarter {
                    *value += (0.1 * normal(random)) as f32;
                }
            }
        }
        let after: Vec<Picture> = before.iter().rev().cloned().collect();
        let found = verdict(&before, &after).method;
        let is_pairs =
            matches!(found, Method::Signs { pairs: 4, .. } | Method::PairedAreas { pairs: 4, .. });
        assert!(is_pairs, "quarter {quarter}: found {found:?}, expected 4 pairs");
    }
}

/// Law: noise that is k times as large, pixel by pixel, has the factor k, inside its interval; other noise is told, and is no change
/// of the mean. Oracle: the difference of each picture from the mean of all, multiplied.
#[test]
fn the_noise_of_sets_has_its_factor() {
    let random = &mut Pcg32::new(3, 51);
    for factor in [0.5, 1.0, 2.0, 3.0] {
        let before = pictures(random, 6, 0.05, 1.0);
        // turned by 180°, so that no two pictures look like ones of equal seeds
        let sum = |at: usize| {
            before.iter().map(|it| f64::from(it.values.as_flattened()[at])).sum::<f64>()
        };
        let mean: Vec<f64> = (0..3 * 256).map(|at| sum(at) / 6.0).collect();
        let turned = |picture: &Picture| {
            let values = picture.values.as_flattened();
            let apart = |at: usize| f64::from(values[at]) - mean[at];
            let new: Vec<f32> = (0..3 * 256)
                .map(|at| (mean[at] + factor * apart(3 * 256 - 1 - at)) as f32)
                .collect();
            Picture::of_radiance(&new, SIZE)
        };
        let after: Vec<Picture> = before.iter().map(turned).collect();
        let found = verdict(&before, &after);
        assert_eq!(found.decision, SetsDecision::Agree, "{found}");
        let is_changed = found.to_string().contains("it has changed");
        equal(format!("{factor} times the noise is told"), is_changed, factor != 1.0);
        let noise = found.noise.expect("there is noise");
        near("noise factor", noise.factor / factor, 1.0, 0.03);
        let [low, high] = noise.interval;
        assert!(low <= factor && factor <= high, "factor {factor}: found {low} to {high}");
    }
}

/// Law: sets of unequal sizes with the same noise have the factor 1: each picture is compared with the mean of its own set,
/// which takes 1/n of its variance. Oracle: the noise; its factor varies by 2 % in nine pictures of 256 pixels.
#[test]
fn sets_of_other_sizes_have_the_same_noise() {
    let random = &mut Pcg32::new(7, 51);
    for [n, m] in [[2, 7], [7, 2], [3, 6]] {
        let found = verdict(&pictures(random, n, 0.05, 1.0), &pictures(random, m, 0.05, 1.0));
        let factor = found.noise.expect("there is noise").factor;
        near(format!("noise of {m} after relative to that of {n} before"), factor, 1.0, 0.08);
    }
}

/// Law: a margin holds if it contains the intervals of all areas, is broken if one is outside, and else undecided. Oracle:
/// intervals on both sides of each border.
#[test]
fn a_margin_of_sets_has_borders() {
    let means = |relative: Option<[f64; 3]>, after: f64| AreaMeans {
        name: String::new(),
        before: 1.0,
        after,
        relative,
    };
    let good = means(Some([0.0, -0.01, 0.01]), 1.0);
    for (other, expected) in [
        (means(Some([0.0, -0.01, 0.01]), 1.0), Answer::Agrees),
        (means(Some([0.0, -0.0101, 0.01]), 1.0), Answer::CannotTell),
        (means(Some([0.0, -0.01, 0.0101]), 1.0), Answer::CannotTell),
        (means(Some([0.02, 0.0101, 0.03]), 1.0), Answer::DiffersByMore),
        (means(Some([-0.02, -0.03, -0.0101]), 1.0), Answer::DiffersByMore),
        (means(Some([0.02, 0.01, 0.03]), 1.0), Answer::CannotTell),
        (means(Some([-0.02, -0.03, -0.01]), 1.0), Answer::CannotTell),
        (means(Some([0.0, -0.03, 0.03]), 1.0), Answer::CannotTell),
        (means(None, 1.0), Answer::Agrees),
        (means(None, 1.5), Answer::DiffersByMore),
    ] {
        let what = format!("{:?}", other.relative);
        equal(what, AreaMeans::within(&[good.clone(), other.clone()], 0.01), expected);
        equal("in the other order", AreaMeans::within(&[other, good.clone()], 0.01), expected);
    }
}

/// Law: sums are of each channel over each tile and region, in their order, and the expected variance of each is that of its
/// pixels. Oracle: sums by hand, for pictures of one pixel, one row, one column and odd sizes.
#[test]
fn sums_of_sets_are_sums() {
    let random = &mut Pcg32::new(4, 51);
    for size in [[1, 1], [5, 1], [1, 6], [3, 2], [8, 8], [7, 9], [16, 16], [33, 2]] {
        let (areas, pixels) = (Areas::tiles(size), size[0] * size[1]);
        let mut of = || (0..3 * pixels).map(|_| 1.0 + random.uniform()).collect::<Vec<f64>>();
        let (values, mean, variance) = (of(), of(), of());
        let summed = std::iter::once(values.clone());
        let sums = AreaSums::of(summed, [&mean, &variance], &areas, Design::differences(1));
        for (level, (_, tiles)) in areas_by_hand(size).iter().enumerate() {
            for (number, tile) in tiles.iter().enumerate() {
                let places = sums.places(SumKind::Tiles(level), number);
                for (channel, place) in places.into_iter().enumerate() {
                    let of = |values: &[f64]| {
                        tile.iter().map(|pixel| values[3 * pixel + channel]).sum::<f64>()
                    };
                    let what = format!("{size:?}, level {level}, tile {number}, channel {channel}");
                    near(&what, sums.in_pictures(place)[0], of(&values), 1e-12 * of(&values));
                    near(&what, sums.mean[place], of(&mean), 1e-9);
                    let rounding = 1e-5 * of(&mean);
                    near(&what, sums.expected[place], of(&variance) + rounding * rounding, 1e-9);
                    let found = areas.pixels(sums.area(place));
                    equal(what, &found, tile);
                }
            }
        }
    }
}
