//! Two sets of pictures: false alarms, what is found, and what is said of it.

mod divisions;
mod exact;
mod odd;
mod other_noise;
mod synthetic;

use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

use groundtruth::math::Pcg32;
use judge::sets::{Method, Pairs, Reason, Sets, SetsDecision, SetsVerdict, Watch};
use judge::verdict::Answer;
use pictures::compare::Picture;
use rayon::prelude::*;

use synthetic::{Noise, SIZE, brighter, differ, pictures, verdict, verdict_at, without_a_lamp};
use testkit::as_many;

const LEVEL: f64 = 0.01;

/// The number of honest pairs of sets, and of those that are said to differ.
fn alarms(noise: Noise, sizes: [u64; 2], pairs: u64) -> u64 {
    let differs = |seed: &u64| {
        let start = 1000 * seed;
        let before = pictures(noise, start..start + sizes[0]);
        let after = pictures(noise, start + 500..start + 500 + sizes[1]);
        differ(&before, &after)
    };
    (0..pairs).into_par_iter().filter(differs).count() as u64
}

/// Law: sets of pictures of one renderer hardly ever differ, whatever their noise and their number. Oracle: the binomial
/// distribution at the level: of 30, more than 4 have a probability below 2e-5, so that it is below 2e-4 for all 12.
#[test]
fn few_honest_sets_differ() {
    let all = [Noise::Even, Noise::Fireflies, Noise::Filtered];
    for (noise, usual) in all.into_iter().zip([[3, 3], [5, 5], [4, 7]]) {
        for sizes in as_many(&[usual][..], &[[5, 5], [4, 7], [3, 3], [1, 1]]) {
            let alarms = alarms(noise, *sizes, 30);
            assert!(alarms <= 4, "{noise:?}, {sizes:?}: {alarms} of 30");
        }
    }
}

/// Law: a change that the power line promises is seen in other pictures with it. Oracle: it is planted, the lamp by another
/// fall-off; of 40, fewer than 34 have a probability below 1e-3 if each is seen in 95 of 100.
#[test]
fn what_the_power_line_promises_is_seen() {
    for noise in [Noise::Fireflies, Noise::Even].into_iter().take(as_many(1, 2)) {
        let seen = |seed: u64| {
            let start = 1000 * seed;
            let [before, honest, after] =
                [0, 200, 400].map(|from| pictures(noise, start + from..start + from + 5));
            let power = verdict(&before, &honest).power?;
            let whole = brighter(&after, 1.0 + power.gain?, |_| true);
            let patch = brighter(&after, 1.0 + power.gain_of_patch?, |at| {
                (0..2).all(|axis| {
                    (power.corner[axis]..power.corner[axis] + power.patch)
                        .contains(&(at[axis] as usize))
                })
            });
            let unlit = without_a_lamp(&after);
            let is_seen = |after: &[Picture]| differ(&before, after);
            Some([is_seen(&whole), is_seen(&patch), !power.lamp || is_seen(&unlit)])
        };
        let all: Vec<[bool; 3]> = (100..140).into_par_iter().filter_map(seen).collect();
        assert!(all.len() >= 38, "{noise:?}: {} honest sets agree", all.len());
        let counts = [0, 1, 2].map(|which| all.iter().filter(|found| found[which]).count());
        println!("{noise:?}: whole, patch, lamp {counts:?} of {}", all.len());
        assert!(counts.iter().all(|count| *count >= 34), "{noise:?}: {counts:?} of {}", all.len());
    }
}

/// Law: a shift by half a pixel is promised along the axis along which the picture changes, and not along the other.
/// Oracle: pictures of stripes.
#[test]
fn a_shift_is_promised_along_the_axis_of_change() {
    for axis in [0, 1] {
        let striped = |seed: u64| {
            let mut picture = pictures(Noise::Even, seed..seed + 1).swap_remove(0);
            let width = picture.size[0];
            for (index, color) in (0..).zip(&mut picture.values) {
                let at = [index % width, index / width][axis];
                // the noise about 1, much smaller than the stripes
                let value = 1.0 + 0.1 * (color[0] % 0.1) + (at / 4 % 2) as f32;
                *color = [value; 3];
            }
            picture
        };
        let [before, after] = [0..5, 5..10].map(|seeds| seeds.map(striped).collect::<Vec<_>>());
        let power = verdict(&before, &after).power.expect("they agree");
        assert_eq!(power.shift, [axis == 0, axis == 1], "{power:?}");
    }
}

/// Law: that one lamp of twelve is missing, which takes a twelfth of the light of an even picture, is promised where a gain of
/// 2 % is, and not where no gain below 50 % is. Oracle: a twelfth lies far between them.
#[test]
fn a_lamp_is_promised_where_a_twelfth_is_seen() {
    // one pixel in a hundred is a thousand times as bright
    let wild = |seed: u64| {
        let mut random = Pcg32::new(seed, 9);
        let mut value = || if random.below(100) == 0 { 1000.0 } else { 1.0 };
        let pixels = (0..SIZE[0] * SIZE[1]).flat_map(|_| [value(); 3]);
        Picture::of_radiance(&pixels.collect::<Vec<f32>>(), SIZE)
    };
    let power = |before: &[Picture], after: &[Picture]| {
        verdict(before, after).power.expect("they agree, or it cannot be told")
    };
    let seen = power(&pictures(Noise::Even, 0..5), &pictures(Noise::Even, 5..10));
    assert!(seen.lamp && seen.gain.is_some_and(|gain| gain <= 0.02), "{seen:?}");
    let hidden = power(&[wild(1)], &[wild(2)]);
    assert!(!hidden.lamp && hidden.gain.is_none_or(|gain| gain >= 0.5), "{hidden:?}");
}

/// Law: an interrupted comparison says nothing, and each division that is tried is told. Oracle: the number of divisions,
/// of the sets themselves and of each planted change.
#[test]
fn an_interrupted_comparison_says_nothing() {
    let (before, after) = (pictures(Noise::Even, 0..5), pictures(Noise::Even, 5..10));
    let (tried, interrupted) = (AtomicUsize::new(0), AtomicBool::new(false));
    let compared = || {
        let count = || _ = tried.fetch_add(1, Ordering::Relaxed);
        let watch = Watch { tried: &count, interrupted: &interrupted };
        let sets = Sets::new([before.clone(), after.clone()], None).expect("one size");
        SetsVerdict::of(sets, LEVEL, watch)
    };
    assert!(compared().is_some());
    let all = tried.swap(0, Ordering::Relaxed);
    assert!(all > 126 && all % 126 == 0, "{all}");
    interrupted.store(true, Ordering::Relaxed);
    assert!(compared().is_none());
    assert_eq!(tried.load(Ordering::Relaxed), 0);
}

/// Law: equal seeds are noticed, and show a change far below the noise; the changed place is named. Oracle: the change.
#[test]
fn pairs_with_equal_seeds_show_small_changes() {
    let before = pictures(Noise::Even, 0..8);
    let same = verdict(&before, &before.iter().rev().cloned().collect::<Vec<_>>());
    assert_eq!(same.decision, SetsDecision::Agree, "{same}");
    let is_inside = |at: [u32; 2]| at.iter().all(|at| (8..16).contains(at));
    let after = brighter(&before, 1.001, is_inside);
    let found = verdict(&before, &after);
    assert!(
        matches!(found.method, Method::Signs { pairs: 8, count: 128, is_all: true }),
        "{found}"
    );
    assert_eq!(found.decision, SetsDecision::Differ, "{found}");
    let [x, y, w, h] = found.areas[0].bounds;
    assert!(x >= 8 && y >= 8 && x + w <= 16 && y + h <= 16, "{found}");
    let few = verdict(&before[..5], &brighter(&before[..5], 1.001, |_| true));
    assert!(
        matches!(few.method, Method::PairedAreas { pairs: 5, because: Reason::Few(_) }),
        "{few}"
    );
    assert_eq!(few.decision, SetsDecision::Differ, "{few}");
    // other seeds do not show it
    let other = verdict(&pictures(Noise::Even, 20..28), &after);
    assert_eq!(other.decision, SetsDecision::Agree, "{other}");
}

/// Law: each picture is of one pair, with its own seed's, and sets in which one of the smaller has no partner have none. Oracle:
/// the seeds.
#[test]
fn each_picture_has_one_partner() {
    type Expected<'a> = &'a [[usize; 2]];
    let cases: [([&[u64]; 2], Expected<'_>); 5] = [
        ([&[1, 2, 3], &[3, 1, 2]], &[[0, 1], [1, 2], [2, 0]]),
        ([&[1, 2, 3, 4], &[3, 1]], &[[0, 1], [2, 0]]),
        ([&[3, 1], &[1, 2, 3, 4]], &[[0, 2], [1, 0]]),
        ([&[1, 2, 3], &[1, 2, 4]], &[]),
        // two of them are there twice, and two have no partner
        ([&[1, 2, 3, 4], &[1, 1, 2, 2]], &[]),
    ];
    for (seeds, expected) in cases {
        let [before, after] = seeds.map(|all| pictures(Noise::Even, all.iter().copied()));
        let sets = Sets::new([before, after], None).expect("one size");
        assert_eq!(Pairs::of(&sets).0, expected, "pairs of the seeds {seeds:?}");
    }
}

/// Law: pictures without noise agree if their values do, and differ by a thousandth in one pixel. Oracle: the change.
#[test]
fn without_noise_each_value_counts() {
    let one = pictures(Noise::Even, 0..1);
    let two = [one[0].clone(), one[0].clone()];
    assert_eq!(verdict(&one, &one).decision, SetsDecision::Agree);
    assert_eq!(verdict(&two, &one).decision, SetsDecision::Agree);
    let changed = brighter(&one, 1.001, |at| at == [3, 5]);
    let found = verdict(&two, &changed);
    assert_eq!((found.decision, found.method.clone()), (SetsDecision::Differ, Method::Rounding));
    assert_eq!(found.areas[0].bounds, [3, 5, 1, 1]);
}

/// Law: one picture a side differs if it is far brighter, and else cannot be told; a margin wide enough is kept. Oracle: the
/// gain.
#[test]
fn one_picture_a_side_can_tell_little() {
    let before = pictures(Noise::Even, 0..1);
    let after = pictures(Noise::Even, 1..2);
    let mut found = verdict(&before, &after);
    assert_eq!(found.decision, SetsDecision::CannotTell, "{found}");
    let gain = found.power.as_ref().and_then(|power| power.gain).expect("some gain is seen");
    for (margin, answer) in [(0.5, Answer::Agrees), (1e-4, Answer::CannotTell)] {
        found.hold_to(margin);
        assert_eq!(found.margin, Some((margin, answer)), "{found}");
    }
    let mut bright = verdict(&before, &brighter(&after, 1.0 + gain, |_| true));
    assert_eq!(bright.decision, SetsDecision::Differ, "{bright}");
    // where the picture is brighter, the map is
    assert!(bright.z.iter().filter(|z| **z > 0.0).count() > bright.z.len() / 2, "{bright}");
    bright.hold_to(0.1 * gain);
    assert_eq!(bright.margin.map(|it| it.1), Some(Answer::DiffersByMore), "{bright}");
}

/// Law: a flip, a factor, exchanged channels are named as the cause, and nothing else than they. Oracle: the change.
#[test]
fn harmless_changes_are_named() {
    let before = pictures(Noise::Even, 0..5);
    let after = pictures(Noise::Even, 5..10);
    let moved = |from: &dyn Fn([u32; 2]) -> [u32; 2]| {
        after.iter().map(|picture| synthetic::moved(picture, from)).collect::<Vec<_>>()
    };
    let [width, height] = SIZE;
    for (changed, words) in [
        (brighter(&after, 2.0, |_| true), "2"),
        (moved(&|[x, y]| [x, height - 1 - y]), "upside down"),
        (moved(&|[x, y]| [(x + 1).min(width - 1), y]), "pixel"),
    ] {
        let found = verdict(&before, &changed);
        let named = found.explained_by.as_deref().unwrap_or("nothing");
        assert!(named.contains(words), "{words}: {found}");
    }
    let found = verdict(&before, &brighter(&after, 3.0, |[x, _]| x < 10));
    assert_eq!(found.explained_by, None, "{found}");
}

/// Law: a region that has changed is named by its colour, and its mean has changed by so much. Oracle: the change.
#[test]
fn regions_are_named() {
    let before = pictures(Noise::Even, 0..5);
    let is_inside = |[x, y]: [u32; 2]| (x + y) % 3 == 0;
    let after = brighter(&pictures(Noise::Even, 5..10), 1.2, is_inside);
    let pixels = (0..SIZE[1]).flat_map(|y| (0..SIZE[0]).map(move |x| [x, y]));
    let colors: Vec<f32> =
        pixels.flat_map(|at| if is_inside(at) { [1.0, 0.0, 0.0] } else { [0.0; 3] }).collect();
    let regions = Picture::of_radiance(&colors, SIZE);
    let found = verdict_at([&before, &after], Some(&regions), LEVEL);
    assert_eq!(found.areas[0].name, "region #ff0000", "{found}");
    let red = found.means.iter().find(|means| means.name == "region #ff0000").expect("listed");
    let [_, low, high] = red.relative.expect("it is not black");
    assert!(low < 0.2 && 0.2 < high && low > 0.1, "{red:?}");
    let black = found.means.iter().find(|means| means.name == "region #000000").expect("listed");
    let [_, low, high] = black.relative.expect("it is not black");
    assert!(low < 0.0 && 0.0 < high, "{black:?}");
}
