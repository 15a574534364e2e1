//! No dimension is used twice: what a pixel draws for its place, the lens, each light and each bounce
//! has nothing to do with each other, nor with what other pixels draw.
//!
//! Pairs are counted against their own marginals: 83 sets of n points are not the whole square.

use groundtruth::samplers::{Branch, Key, Kind, PathKey, Purpose, SampleSets};
use groundtruth::verify::chi_square::independence;
use groundtruth::verify::correlation::pearson;
use groundtruth::verify::means;
use groundtruth::verify::significance::sidak;

/// The chance that one of the laws of this file is called broken if all hold, had the seeds been
/// drawn anew.
const LEVEL: f64 = 1e-3;

/// Pairs are taken from as many pixels: 10⁶ of them.
const SIDE: u32 = 1000;

/// Samples a pixel, and which of them is looked at.
const SAMPLES: u32 = 16;
const INDEX: u32 = 5;

/// What may be drawn for one sample. A light and a pair exchanged are another light's other pair.
fn uses() -> [Purpose; 8] {
    let first = PathKey::CAMERA;
    let mirrored = first.then(Branch::Mirror);
    let light = |path, light, pair| Purpose::Light { path, light, pair };
    [
        Purpose::Pixel,
        Purpose::Lens,
        light(first, 0, 0),
        light(first, 0, 1),
        light(first, 1, 0),
        light(mirrored, 0, 0),
        Purpose::Direction { path: first, branch: Branch::Gloss },
        Purpose::Direction { path: mirrored, branch: Branch::Gloss },
    ]
}

/// Every sampler whose draws are random: all but those that have one set, not shifted. Two draws of a
/// run of `n` in different pixels are the same points then, in some order.
fn randomising() -> Vec<Kind> {
    let all = Kind::ENTRIES.iter().flat_map(|entry| (entry.specimens)());
    let points = |kind: &Kind, x: u32| -> Vec<[u64; 2]> {
        let sets = sets(kind);
        let key = Key::new(1, [x, 0], Purpose::Pixel);
        let mut points: Vec<_> =
            (0..sets.per_set()).map(|i| sets.draw(key, i).map(f64::to_bits)).collect();
        points.sort_unstable();
        points
    };
    all.filter(|kind| (1..5).any(|x| points(kind, x) != points(kind, 0))).collect()
}

fn sets(kind: &Kind) -> SampleSets {
    SampleSets::new(&*kind.build(&mut ()).expect("specimens are valid"), SAMPLES, 11)
}

/// What one use draws in each of many pixels.
struct Draws {
    x: Vec<f64>,
    y: Vec<f64>,
    /// The cell of a 7 × 7 grid, which lines up with no pattern.
    odd: Vec<u16>,
    /// The cell of the grid of as many rows and columns as samples, of which every stratum of 16
    /// samples is made.
    fine: Vec<u16>,
}

impl Draws {
    fn new(points: impl Iterator<Item = [f64; 2]>) -> Self {
        let (x, y): (Vec<f64>, Vec<f64>) = points.map(|[x, y]| (x, y)).unzip();
        let cells = |side: u16| -> Vec<u16> {
            let part = |u: f64| (u * f64::from(side)) as u16;
            x.iter().zip(&y).map(|(&x, &y)| part(y) * side + part(x)).collect()
        };
        Self { odd: cells(7), fine: cells(SAMPLES as u16), x, y }
    }

    /// The draws of this use and index in a million pixels.
    fn of(
        sets: &SampleSets,
        purpose: Purpose,
        pixel: impl Fn(u32, u32) -> [u32; 2],
        i: u32,
    ) -> Self {
        let places = (0..SIDE * SIDE).map(|at| pixel(at % SIDE, at / SIDE));
        Self::new(places.map(|at| sets.draw(Key::new(3, at, purpose), i)))
    }
}

/// The tests of one pair of uses: 4 pairs of coordinates and 2 tables.
const TESTS: usize = 6;

/// What is wrong, if any of a pair's tests is below this level.
fn dependence(a: &Draws, b: &Draws, level: f64) -> Option<String> {
    for (of_a, xs) in [("x", &a.x), ("y", &a.y)] {
        for (of_b, ys) in [("x", &b.x), ("y", &b.y)] {
            let found = pearson(xs, ys).expect("they differ");
            if found.p < level {
                return Some(format!("{of_a} and {of_b}: {found:?}"));
            }
        }
    }
    let cells = u32::from(u8::MAX) + 1;
    for (grid, side, a, b) in [("7 × 7", 49, &a.odd, &b.odd), ("strata", cells, &a.fine, &b.fine)]
    {
        let side = side as usize;
        let mut table = vec![0; side * side];
        a.iter().zip(b).for_each(|(&a, &b)| table[usize::from(a) * side + usize::from(b)] += 1);
        let p = independence(&table, side);
        if p < level {
            return Some(format!("{grid}: p = {p:e}"));
        }
    }
    None
}

/// Holds that each of these pairs is independent, at one level for all.
fn holds(kinds: &[Kind], pairs: &[(usize, usize)]) {
    let level = sidak(LEVEL, kinds.len() * pairs.len() * TESTS);
    for kind in kinds {
        let sets = sets(kind);
        let used = |use_: usize| pairs.iter().any(|&(a, b)| a == use_ || b == use_);
        let draws: Vec<Option<Draws>> = uses()
            .iter()
            .enumerate()
            .map(|(i, &purpose)| used(i).then(|| Draws::of(&sets, purpose, |x, y| [x, y], INDEX)))
            .collect();
        for &(a, b) in pairs {
            let [(of_a, a), (of_b, b)] = [a, b].map(|i| (uses()[i], draws[i].as_ref()));
            let wrong = a.zip(b).and_then(|(a, b)| dependence(a, b, level));
            assert_eq!(wrong, None, "{kind:?}: {of_a:?} and {of_b:?}");
        }
    }
}

fn all_pairs() -> Vec<(usize, usize)> {
    (0..uses().len()).flat_map(|b| (0..b).map(move |a| (a, b))).collect()
}

/// Law: no two uses in a pixel have to do with each other. Oracle: correlations and χ² of
/// independence over 10⁶ pixels, for the sampler of most structure and the uses most alike; they find
/// a correlation of 0.007 and a φ² of 5e-4 on the odd grid and of 3e-3 in the strata. At one index of
/// one sample; what all of a pixel's samples have to do with each other is the last law's.
#[test]
fn no_two_uses_in_a_pixel_depend_on_each_other() {
    let kind = Kind::from(groundtruth::samplers::MultiJittered {});
    holds(&[kind], &[(0, 1), (1, 2), (2, 3), (2, 4), (3, 4), (2, 5), (5, 6)]);
}

/// Law: as above, of every two uses and every sampler that randomises.
#[test]
#[ignore = "cost: cargo test ch05 -- --ignored"]
fn no_two_uses_in_a_pixel_depend_on_each_other_with_any_sampler() {
    let kinds = randomising();
    assert!(kinds.len() >= 3, "{kinds:?}");
    holds(&kinds, &all_pairs());
}

/// A pixel's partner: what it is, its pixel and the index of its draw.
type Partner = (&'static str, fn(u32, u32) -> [u32; 2], u32);

/// Pixels beside, farther away and mirrored, other runs and other samples; the pixel itself is at
/// `(2 x, 2 y + 1)`, so that no draw is in two pairs.
const PARTNERS: [Partner; 8] = [
    ("beside", |x, y| [2 * x + 1, 2 * y + 1], INDEX),
    ("below", |x, y| [2 * x, 2 * y + 2], INDEX),
    ("across the corner", |x, y| [2 * x + 1, 2 * y + 2], INDEX),
    ("83 to the right", |x, y| [2 * x + 83, 2 * y + 1], INDEX),
    ("a power of two below", |x, y| [2 * x, 2 * y + 1 + 2049], INDEX),
    ("mirrored", |x, y| [2 * y + 1, 2 * x], INDEX),
    ("the next run", |x, y| [2 * x, 2 * y + 1], INDEX + SAMPLES),
    ("the run of 16 on", |x, y| [2 * x, 2 * y + 1], INDEX + 16 * SAMPLES),
];

fn pixels_hold(kind: &Kind, partners: &[Partner], tests: usize) {
    let level = sidak(LEVEL, tests * TESTS);
    let sets = sets(kind);
    let here = Draws::of(&sets, Purpose::Pixel, |x, y| [2 * x, 2 * y + 1], INDEX);
    for (what, pixel, index) in partners {
        let there = Draws::of(&sets, Purpose::Pixel, pixel, *index);
        assert_eq!(dependence(&here, &there, level), None, "{kind:?}: {what}");
    }
}

/// Law: what one pixel draws has nothing to do with its neighbours, nor one run with the next. Oracle:
/// as above.
#[test]
fn pixels_and_runs_do_not_depend_on_each_other() {
    let chosen = [PARTNERS[1], PARTNERS[5], PARTNERS[6]];
    pixels_hold(&groundtruth::samplers::MultiJittered {}.into(), &chosen, chosen.len());
}

/// Law: as above, for all partners and every sampler that randomises; and the first use's samples with
/// another use's of another index.
#[test]
#[ignore = "cost: cargo test ch05 -- --ignored"]
fn pixels_and_runs_do_not_depend_on_each_other_with_any_sampler() {
    let kinds = randomising();
    for kind in &kinds {
        pixels_hold(kind, &PARTNERS, kinds.len() * (PARTNERS.len() + 1));
        let sets = sets(kind);
        let level = sidak(LEVEL, kinds.len() * (PARTNERS.len() + 1) * TESTS);
        let a = Draws::of(&sets, Purpose::Pixel, |x, y| [x, y], 0);
        let b = Draws::of(&sets, Purpose::Lens, |x, y| [x, y], 1);
        assert_eq!(dependence(&a, &b, level), None, "{kind:?}: another index");
    }
}

/// Law: all samples of a pixel are paired with its lens samples as a random permutation pairs them:
/// correlations have the mean 0 and the mean square `1/(n − 1)`. Oracle: t tests over both axes of
/// 4000 pixels. The same order begun at the same place pairs equal cells, once in 83 · 64 pixels, and
/// adds 1.2 % to the square, of which the test sees 6 %; orders that all begin at the same place would
/// add 76 %.
#[test]
fn a_pixels_samples_are_paired_at_random() {
    const PIXELS: u32 = 4000;
    let n = 64;
    let sampler = Kind::from(groundtruth::samplers::MultiJittered {}).build(&mut ());
    let sets = SampleSets::new(&*sampler.expect("it has no settings"), n, 5);
    let (mut correlations, mut squares) = (Vec::new(), Vec::new());
    for at in 0..PIXELS {
        let draws = |purpose| -> Vec<[f64; 2]> {
            let key = Key::new(9, [at % 100, at / 100], purpose);
            (0..n).map(|i| sets.draw(key, i)).collect()
        };
        let [pixel, lens] = [Purpose::Pixel, Purpose::Lens].map(draws);
        for axis in 0..2 {
            let column = |points: &[[f64; 2]]| points.iter().map(|p| p[axis]).collect::<Vec<_>>();
            let r = pearson(&column(&pixel), &column(&lens)).expect("they differ").r;
            correlations.push(r);
            squares.push(r * r * f64::from(n - 1));
        }
    }
    let level = sidak(LEVEL, 2);
    for (values, expected) in [(correlations, 0.0), (squares, 1.0)] {
        let p = means::one_sample(&values, expected);
        assert!(p > level, "p = {p:e} for {expected}");
    }
}
