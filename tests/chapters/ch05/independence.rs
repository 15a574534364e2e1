//! No dimension is used twice: the draws of a pixel for its film point, the lens, each light and each bounce
//! are independent of each other, and of the draws of other pixels.
//!
//! The χ² tests use the observed marginals: 83 sets of n points do not fill the square uniformly.

use groundtruth::lobes::Branch;
use groundtruth::samplers::{Key, Kind, PathKey, Purpose, SampleSets};
use statistics::chi_square::independence;
use statistics::correlation::pearson;

use crate::prelude::*;

/// The probability, over random seeds, that at least one law of this file is rejected although all hold.
const LEVEL: f64 = 1e-3;

/// Pairs are taken from `SIDE` × `SIDE` pixels: 10⁶ of them.
const SIDE: u32 = 1000;

/// Samples per pixel, and the index of the one that is tested.
const SAMPLES: u32 = 16;
const INDEX: u32 = 5;

/// Uses of the draws of one sample. Exchanging the indices of light and pair gives a different use, and so does
/// exchanging two branches of a path.
fn uses() -> [Purpose; 12] {
    let first = PathKey::CAMERA;
    let [mirrored, refracted] = [Branch::Mirror, Branch::Refraction].map(|it| first.then(it));
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
        light(refracted, 0, 0),
        light(mirrored.then(Branch::Refraction), 0, 0),
        light(refracted.then(Branch::Mirror), 0, 0),
        Purpose::Lobe { path: first },
    ]
}

/// Every sampler whose draws are random: all but those with a single set that is not shifted, for which every
/// pixel draws the same points in some order.
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

/// The draws of one use in many pixels.
struct Draws {
    x: Vec<f64>,
    y: Vec<f64>,
    /// The cell of a 7 × 7 grid, which lines up with no pattern.
    odd: Vec<u16>,
    /// The cell of the grid with as many rows and as many columns as samples; every stratum of 16 samples is
    /// a union of its cells.
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
        let pixels = (0..SIDE * SIDE).map(|at| pixel(at % SIDE, at / SIDE));
        Self::new(pixels.map(|at| sets.draw(Key::new(3, at, purpose), i)))
    }
}

/// The tests of one pair of uses: 4 pairs of coordinates and 2 tables.
const TESTS: usize = 6;

/// The first test of this pair with a p-value below `level`, if there is one.
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

/// Asserts that each of these pairs is independent, at one level for all tests together.
fn assert_independent(kinds: &[Kind], pairs: &[(usize, usize)]) {
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

/// The pairs of uses whose names differ least.
const NEAREST: [(usize, usize); 10] =
    [(0, 1), (1, 2), (2, 3), (2, 4), (3, 4), (2, 5), (5, 6), (5, 8), (9, 10), (6, 11)];

/// Law: no two uses in a pixel depend on each other. Oracle: correlations and χ² of independence over 10⁶
/// pixels, for the most structured sampler and the most similar uses; they detect a correlation of 0.007 and
/// a φ² of 5e-4 on the odd grid and of 3e-3 in the strata; thoroughly, every two uses and every sampler that randomises. This tests one index of a pixel; the last law of
/// this file tests all samples of a pixel together.
#[test]
fn no_two_uses_in_a_pixel_depend_on_each_other() {
    if !is_thorough() {
        return assert_independent(&[groundtruth::samplers::MultiJittered {}.into()], &NEAREST);
    }
    let kinds = randomising();
    assert!(kinds.len() >= 3, "{kinds:?}");
    assert_independent(&kinds, &all_pairs());
}

/// A pixel's partner: its name, its pixel and the index of its draw.
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
    ("16 runs later", |x, y| [2 * x, 2 * y + 1], INDEX + 16 * SAMPLES),
];

fn assert_pixels(kind: &Kind, partners: &[Partner], tests: usize) {
    let level = sidak(LEVEL, tests * TESTS);
    let sets = sets(kind);
    let here = Draws::of(&sets, Purpose::Pixel, |x, y| [2 * x, 2 * y + 1], INDEX);
    for (what, pixel, index) in partners {
        let there = Draws::of(&sets, Purpose::Pixel, pixel, *index);
        assert_eq!(dependence(&here, &there, level), None, "{kind:?}: {what}");
    }
}

/// Law: the draws of one pixel are independent of its neighbours', and those of one run of the next run's;
/// thoroughly, for all partners and every sampler that randomises, and film samples with lens samples of another index. Oracle: as above.
#[test]
fn pixels_and_runs_do_not_depend_on_each_other() {
    if !is_thorough() {
        let chosen = [PARTNERS[1], PARTNERS[5], PARTNERS[6]];
        return assert_pixels(&groundtruth::samplers::MultiJittered {}.into(), &chosen, 3);
    }
    let kinds = randomising();
    for kind in &kinds {
        assert_pixels(kind, &PARTNERS, kinds.len() * (PARTNERS.len() + 1));
        let sets = sets(kind);
        let level = sidak(LEVEL, kinds.len() * (PARTNERS.len() + 1) * TESTS);
        let a = Draws::of(&sets, Purpose::Pixel, |x, y| [x, y], 0);
        let b = Draws::of(&sets, Purpose::Lens, |x, y| [x, y], 1);
        assert_eq!(dependence(&a, &b, level), None, "{kind:?}: another index");
    }
}

/// Law: all samples of a pixel are paired with its lens samples as a random permutation pairs them:
/// correlations have the mean 0 and the mean square `1/(n − 1)`. Oracle: t tests over both axes of 4000
/// pixels. In one of 83 · 64 pixels both use the same order from the same start, which pairs equal cells and
/// adds 1.2 % to the mean square; the test detects 6 %. Orders that all have the same start would add 76 %.
/// Book: shuffled indices.
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
