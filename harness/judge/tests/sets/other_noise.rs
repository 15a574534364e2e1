//! Sets whose noise is not the same before and after: false alarms, and what is found in single pixels.

use groundtruth::math::{Pcg32, hash};
use judge::sets::{Method, Reason, SetsDecision};
use pictures::compare::Picture;
use rayon::prelude::*;
use testkit::as_many;

use super::synthetic::{Noise, SIZE, brighter, differ, mean, pictures, verdict};

/// A picture; the numbers of neighbouring seeds of the generator itself are no independent noise.
fn picture(noise: Noise, seed: u64) -> Picture {
    pictures(noise, std::iter::once(hash(&[seed]))).swap_remove(0)
}

/// Pictures of which each is the mean of so many: of the same mean, with less noise.
fn calm(of: impl Fn(u64) -> Picture, seeds: std::ops::Range<u64>, each: u64) -> Vec<Picture> {
    seeds.map(|seed| mean(&(each * seed..each * (seed + 1)).map(&of).collect::<Vec<_>>())).collect()
}

/// One sample of each pixel: an edge runs through a third of the columns, where a sample is bright as often as the pixel is
/// covered; beside it there is even noise.
fn edge(seed: u64) -> Picture {
    let mut picture = picture(Noise::Even, seed);
    let mut random = Pcg32::new(hash(&[seed]), 5);
    for (at, color) in (0..).zip(&mut picture.values) {
        let x = at % SIZE[0];
        if x % 12 < 4 {
            let covered = f64::from(x % 12 * SIZE[1] + at / SIZE[0]) / f64::from(4 * SIZE[1]);
            *color = [if random.uniform() < covered { 1.0 } else { 0.1 }; 3];
        }
    }
    picture
}

/// Law: sets of equal means and other noise hardly ever differ, though each pixel is tested, and even where a sample has one of
/// two values, which chance repeats in all pictures of a set. Oracle: the mean of four pictures has the mean of one; the
/// binomial distribution at the level: of 30, more than 4 have a probability below 2e-5, so that it is below 2e-4 for all.
#[test]
fn few_honest_sets_with_other_noise_differ() {
    let of = |noise: Noise| move |seed: u64| picture(noise, seed);
    let kinds: [(&str, &(dyn Fn(u64) -> Picture + Sync)); 4] = [
        ("even", &of(Noise::Even)),
        ("filtered", &of(Noise::Filtered)),
        ("fireflies", &of(Noise::Fireflies)),
        ("edge", &edge),
    ];
    for (name, of) in kinds {
        for sizes in as_many(&[[4, 7]][..], &[[5, 5], [4, 7]]) {
            let alarm = |seed: &u64| {
                let start = 1000 * seed;
                let before = (start..start + sizes[0]).map(of).collect::<Vec<_>>();
                let after = calm(of, start + 100..start + 100 + sizes[1], 4);
                differ(&before, &after)
            };
            let alarms = (1..31).into_par_iter().filter(alarm).count();
            assert!(alarms <= 4, "{name}, {sizes:?}: {alarms} of 30");
        }
    }
}

/// Law: a pixel that has one value in all pictures before and another in all after differs, whatever the noise around it, and is
/// the first that is named; with the same value it does not. Oracle: it is planted.
#[test]
fn a_pixel_without_noise_is_certain() {
    let even = |seed: u64| picture(Noise::Even, seed);
    let with = |mut set: Vec<Picture>, at: [u32; 2], value: f32| {
        for picture in &mut set {
            let index = picture.index(at);
            picture.values[index] = [value; 3];
        }
        set
    };
    let (before, after) = (pictures(Noise::Even, 0..5), calm(even, 10..15, 4));
    for at in [[3, 5], [0, 0], [31, 39], [20, 12]] {
        for (value, expected) in
            [(0.1, SetsDecision::Agree), (0.11, SetsDecision::Differ), (1.0, SetsDecision::Differ)]
        {
            let found = verdict(&with(before.clone(), at, 0.1), &with(after.clone(), at, value));
            assert_eq!(found.method, Method::Areas { because: Reason::Noise });
            assert_eq!(found.decision, expected, "{at:?} is {value}: {found}");
            if expected == SetsDecision::Differ {
                let [x, y] = at.map(|at| at as usize);
                assert_eq!(found.areas[0].bounds, [x, y, 1, 1], "{found}");
                let [a, b] = [found.areas[0].before, found.areas[0].after];
                assert!((a - 0.1).abs() < 1e-6 && (b - f64::from(value)).abs() < 1e-6, "{a}, {b}");
            }
        }
    }
}

/// Law: of a large area that is a little brighter and a small one that is much brighter the small one is named first, also if
/// the noise has changed. Oracle: both are planted, apart from each other.
#[test]
fn the_largest_difference_is_named_first() {
    let even = |seed: u64| picture(Noise::Even, seed);
    let changed = |all: &[Picture]| {
        let all = brighter(all, 1.1, |[_, y]| y >= 16);
        brighter(&all, 2.0, |[x, y]| (4..6).contains(&x) && (8..10).contains(&y))
    };
    let before = pictures(Noise::Even, 0..5);
    for after in [pictures(Noise::Even, 5..10), calm(even, 10..15, 4)] {
        let found = verdict(&before, &changed(&after));
        let [x, y, w, h] = found.areas.first().expect("they differ").bounds;
        assert!(x >= 4 && y >= 8 && x + w <= 6 && y + h <= 10, "{found}");
        assert!(found.areas.iter().any(|area| area.bounds[1] >= 16), "{found}");
    }
}
