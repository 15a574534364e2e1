//! A pool by its definition: each picture against all others, added up slowly; ranks of equal pictures; how many of ours
//! are asked for.

use groundtruth::math::Pcg32;
use judge::verdict::{
    Against, Areas, Decision, Evaluation, Mean, Pool, PoolContext, Ranking, Strictness, is_refuted,
};

use super::noise::noisy;
use super::shared::FLOATS;
use crate::verbs::{equal, near};

/// Rounding of nine numbers of magnitude 1.
const ROUNDING: f64 = 1e-12;

/// A value against those of all others: by definition.
fn against(values: &[f64], picture: usize, held: Option<f64>) -> Against {
    if values.iter().any(|value| !value.is_finite()) {
        return Against::Nothing;
    }
    let others: Vec<f64> = values
        .iter()
        .enumerate()
        .filter(|(at, _)| *at != picture)
        .map(|(_, value)| *value)
        .collect();
    if others.iter().all(|value| *value == others[0]) {
        return if values[picture] == others[0] { Against::Same } else { Against::Outlier };
    }
    let count = others.len() as f64;
    let mean = others.iter().sum::<f64>() / count;
    let squares: f64 = others.iter().map(|value| (value - mean) * (value - mean)).sum();
    Against::Varied {
        difference: values[picture] - held.unwrap_or(mean),
        variance: squares / (count - 1.0),
    }
}

/// Law: a value is compared with the mean and the variance of all other pictures, or is the same as all, or an outlier, or left
/// out, for each of three to nine pictures, also with a reference. Oracle: the values of the others, one by one.
#[test]
fn each_picture_is_held_against_all_others() {
    let random = &mut Pcg32::new(1, 41);
    for count in [3, 4, 9] {
        for case in 0..400_u32 {
            // few different values, so that some agree, and sometimes all, or all but one
            let kinds = 1 + random.below(3);
            let mut value = || match random.below(60) {
                0 => f32::NAN,
                1 => f32::INFINITY,
                2..9 => 3.0,
                _ => 1.0 + random.below(kinds) as f32 * 0.25,
            };
            let pictures: Vec<Vec<f32>> =
                (0..count).map(|_| (0..3).map(|_| value()).collect()).collect();
            let held = (case % 3 == 0).then(|| Mean { values: vec![1.5, 2.5, 3.5], pictures: 7.0 });
            let pool = Pool::new([1, 1], FLOATS, pictures.clone()).against_mean(held.clone());
            let of_mean = if held.is_some() { 1.0 / 7.0 } else { 1.0 / (count as f64 - 1.0) };
            near("variance of the mean", pool.variance_of_mean(), of_mean, ROUNDING);
            for channel in 0..3 {
                let values: Vec<f64> = pictures.iter().map(|it| f64::from(it[channel])).collect();
                let held = held.as_ref().map(|mean| mean.values[channel]);
                for picture in 0..count {
                    let what = format!("{values:?}, picture {picture}");
                    match (pool.against(picture, channel), against(&values, picture, held)) {
                        (
                            Against::Varied { difference, variance },
                            Against::Varied { difference: apart, variance: square },
                        ) => {
                            near(format!("{what}: difference"), difference, apart, ROUNDING);
                            near(format!("{what}: variance"), variance, square, ROUNDING);
                            let others = values.iter().sum::<f64>() - values[picture];
                            let mean = held.unwrap_or(others / (count as f64 - 1.0));
                            near(
                                format!("{what}: mean of others"),
                                pool.mean_of_others(picture, channel),
                                mean,
                                ROUNDING,
                            );
                        }
                        (found, expected) => equal(&what, found, expected),
                    }
                }
            }
            for picture in 0..count {
                // all others agree in each value
                let agree = |channel: usize| {
                    let values: Vec<f64> =
                        pictures.iter().map(|it| f64::from(it[channel])).collect();
                    let found = against(&values, picture, None);
                    !matches!(found, Against::Varied { .. })
                };
                let is_fixed = (0..3).all(agree);
                equal(format!("fixed but for {picture}"), pool.is_fixed_but_for(picture), is_fixed);
            }
        }
    }
}

/// Law: equal pictures are equally far out, and each counts for the other; the probability is the share of pictures at least as
/// far out, itself among them. Oracle: a copy of each picture in turn.
#[test]
fn equal_pictures_have_equal_ranks() {
    const OURS: usize = 8;
    let areas = Areas::tiles([6, 5]);
    let random = &mut Pcg32::new(2, 41);
    for copied in 0..OURS {
        let mut pictures: Vec<Vec<f32>> = (0..OURS).map(|_| noisy(random, 30, 0.1)).collect();
        pictures.push(pictures[copied].clone());
        let ranking = Ranking::of(&Pool::new([6, 5], FLOATS, pictures), &areas, 0);
        let [first, copy] = [copied, OURS].map(|picture| ranking.as_far_as(picture));
        equal("ranks of a picture and its copy", first, copy);
        assert!(copy >= 1, "the copied picture is as far out as its copy: found {copy} that are");
        for picture in 0..=OURS {
            let as_far = ranking.scores.iter().filter(|it| **it >= ranking.scores[picture]).count();
            let expected = as_far as f64 / (OURS + 1) as f64;
            near("probability", ranking.probability(picture), expected, ROUNDING);
            equal("others that are as far out", ranking.as_far_as(picture), as_far - 1);
        }
    }
}

/// Law: the most replicas are the fewest with which a picture farther out than all has a probability of at most the level.
/// Oracle: the definition, for levels on both sides of 1/n.
#[test]
fn the_most_replicas_are_those_of_the_level() {
    for n in [5, 10, 20, 100, 1000] {
        for (level, most) in [
            (1.0 / f64::from(n), n - 1),
            (1.0 / (f64::from(n) + 0.5), n),
            (1.0 / (f64::from(n) - 0.5), n - 1),
        ] {
            let found = Strictness { level, first: 3 }.most();
            equal(format!("replicas at level {level}"), found, most as usize);
        }
    }
    equal("replicas if 30 are first", Strictness { level: 0.05, first: 30 }.most(), 30);
    equal("replicas if 19 are first", Strictness { level: 0.05, first: 19 }.most(), 19);
    equal("replicas if 18 are first", Strictness { level: 0.05, first: 18 }.most(), 19);
}

/// Law: 8, 16, 32 … pictures of ours are asked for, up to 1/level − 1, until three are as far out as theirs, or theirs is more
/// than a hundred times as far out as all of 15 or more. It differs if it is then farther out than all. Oracle: the rule, tried
/// at each number of pictures, by ranks of all of them.
#[test]
fn ours_are_asked_for_while_theirs_is_among_the_farthest() {
    const MOST: usize = 99;
    let strictness = Strictness { level: 0.01, first: 8 };
    let areas = Areas::tiles([4, 4]);
    let subject = PoolContext { areas: &areas, stored: FLOATS, reference: None };
    let random = &mut Pcg32::new(3, 41);
    let mut ends = [0; 4];
    for case in 0..36_usize {
        let ours: Vec<Vec<f32>> = (0..MOST).map(|_| noisy(random, 16, 0.1)).collect();
        let gain = [1.0, 1.0, 1.06, 1.15, 60.0, 1.0][case % 6];
        let theirs: Vec<f32> = noisy(random, 16, 0.1).iter().map(|value| gain * value).collect();
        let ranked = |count: usize| {
            let pictures = ours[..count].iter().cloned().chain([theirs.clone()]).collect();
            let pool = Pool::new([4, 4], FLOATS, pictures);
            let usual = Ranking::of(&pool, &areas, 0);
            let is_alike = (0.8..=1.25).contains(&usual.noise[count]);
            if is_alike { usual } else { Ranking::of(&pool, &areas, 2) }
        };
        let (mut count, mut expected) = (8, None);
        while expected.is_none() {
            let ranking = ranked(count);
            let (as_far, times) = (ranking.as_far_as(count), ranking.times_as_far(count));
            expected = match () {
                _ if as_far >= 3 => Some((Decision::Agrees, 0)),
                _ if count >= 15 && times > 100.0 => Some((Decision::Differs, 1)),
                _ if count == MOST && as_far == 0 => Some((Decision::Differs, 2)),
                _ if count == MOST => Some((Decision::Agrees, 3)),
                _ => None,
            };
            if expected.is_none() {
                count = (2 * count).min(MOST);
            }
        }
        let (decision, end) = expected.expect("it ends");
        ends[end] += 1;
        let mut asked = 0;
        let next = |_: Option<&Evaluation>| {
            asked += 1;
            ours.get(asked - 1).cloned()
        };
        let found = Evaluation::of(&theirs, subject, strictness, &mut Vec::new(), next);
        equal(format!("gain {gain}: pictures of ours"), asked, count);
        equal(format!("gain {gain}: decision"), found.expect("enough").decision, decision);
    }
    assert!(ends[..3].iter().all(|count| *count > 0), "each way to end is tried: found {ends:?}");
}

/// Law: 4 or 8 pictures of ours never refute one more of them, and refute one that is many times as bright. Oracle: how the
/// pictures were made; Student's t, by which noise exceeds these borders in at most 2e-5 of the cases.
#[test]
fn few_pictures_refute_what_is_far_out_and_no_picture_of_ours() {
    let areas = Areas::tiles([4, 4]);
    let subject = PoolContext { areas: &areas, stored: FLOATS, reference: None };
    let random = &mut Pcg32::new(3, 43);
    for count in [4, 8] {
        for case in 0..300 {
            let ours: Vec<Vec<f32>> = (0..count).map(|_| noisy(random, 16, 0.1)).collect();
            let theirs = noisy(random, 16, 0.1);
            let bright: Vec<f32> = theirs.iter().map(|value| 1000.0 * value).collect();
            let found = [&theirs, &bright].map(|it| is_refuted(it, subject, &ours));
            assert_eq!(found, [false, true], "case {case} of {count}");
        }
    }
}
