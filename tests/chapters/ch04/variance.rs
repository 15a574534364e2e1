//! How fast errors of known integrals fall with the number of samples.

use groundtruth::samplers::{Kind, Purpose, SETS, SampleSets, SetKey};
use statistics::means::one_sample;
use statistics::slope::power_law;

use crate::prelude::*;

/// The probability, over random seeds, that at least one rate is rejected although all are right.
const LEVEL: f64 = 0.01;

const COUNTS: [u32; 6] = [4, 16, 64, 256, 1024, 4096];

/// Rates that hold only asymptotically are fitted from this N on: its cells, of side 1/8, are small compared
/// with the disk.
const SMALL_CELLS: f64 = 64.0;

/// The least difference between two rates; a wider interval could not tell them apart.
const APART: f64 = 0.5;

/// How many mean squares of errors are measured for each count, each over [`SETS`] sets.
const BATCHES: u32 = 8;

/// The area of a disk of radius 0.3.
const DISK: f64 = 0.09 * PI;

/// A function of the unit square, and its integral.
type Integrand = (Box<dyn Fn([f64; 2]) -> f64>, f64);

/// Makes an integrand whose edges lie at random positions.
type MakeIntegrand = fn(&mut Pcg32) -> Integrand;

fn inside(region: impl Fn([f64; 2]) -> bool + 'static, area: f64) -> Integrand {
    (Box::new(move |at| if region(at) { 1.0 } else { 0.0 }), area)
}

/// The integrands. The position of an edge is drawn anew each time, uniformly: at a fixed position the
/// variance would depend on how the edge meets the grid of each count.
const INTEGRANDS: [(&str, MakeIntegrand); 7] = [
    ("constant", |_| (Box::new(|_| 0.75), 0.75)),
    ("linear", |_| (Box::new(|[x, y]| x + 0.5 * y), 0.75)),
    // (1 + x)² (1 + y)²; ∫ (1 + x)² = 7/3
    ("smooth", |_| {
        (Box::new(|[x, y]| ((1.0 + x) * (1.0 + y)) * ((1.0 + x) * (1.0 + y))), 49.0 / 9.0)
    }),
    ("upright or level edge", |random| {
        let (axis, c) = (random.below(2) as usize, random.uniform());
        inside(move |at| at[axis] < c, c)
    }),
    ("slanted edge", |random| {
        // the area is a sum of squares of the amounts by which c exceeds x + 0.6 y at the four corners
        let c = 1.6 * random.uniform();
        let square = |x: f64| if x > 0.0 { x * x } else { 0.0 };
        let corners = square(c) - square(c - 1.0) - square(c - 0.6) + square(c - 1.6);
        inside(move |[x, y]| x + 0.6 * y < c, corners / 1.2)
    }),
    ("corner", |random| {
        let [c, d] = [random.uniform(), random.uniform()];
        inside(move |[x, y]| x < c && y < d, c * d)
    }),
    ("disk", |random| {
        let [a, b] = [0.3 + 0.4 * random.uniform(), 0.3 + 0.4 * random.uniform()];
        inside(move |[x, y]| (x - a) * (x - a) + (y - b) * (y - b) < 0.09, DISK)
    }),
];

/// How the mean square of the error falls with N.
#[derive(Clone, Copy, Debug)]
enum Rate {
    /// There is no error.
    None,
    /// `factor · N^e`, for every N.
    Exactly(f64, f64),
    /// As `N^e`.
    Is(f64),
    /// No slower than `N^e`.
    AtMost(f64),
}

/// The rates of theory, in the order of the integrands. For kinds that are not named here: only that they are
/// no worse than random ones.
///
/// - Random: `σ²/N`, with `σ² = ∫ f² − (∫ f)²`, which for a region of area A is `A − A²` (its mean over the
///   random positions: `½ − ⅓` for an edge, `¼ − 1/9` for a corner).
/// - Jittered: `Σ σ²(cell)/N²`, the cells having the side `h = N^−½`. A smooth f has `σ² = h² |∇f|²/12 +
///   O(h⁴)` in each of N cells: N⁻². An edge crosses some `L/h` cells, each with a variance that does not
///   depend on h: `N^½/N²` (Mitchell, "Consequences of Stratified Sampling in Graphics", 1996). For the
///   upright or level edges this is exact, `1/6 N^−1.5`: their positions are uniform, so each cell meets them
///   as the whole square does. For a corner it is `(n/6 − 1/36)/N²` with `n = √N`.
/// - Multi-jittered and n-rooks: x has one point in each of N columns, y in each of N rows, so a sum of
///   functions of x and of y alone is integrated as in one dimension: `N · N⁻² |f'|²/12 / N²`, N⁻³ for a
///   linear one, and for an upright edge, which crosses one column, `1/6 N⁻²`. For the remainder (f minus its
///   means over rows and columns) n-rooks is as good as random, and a multi-jittered set, whose cells are
///   those of a jittered one, as good as stratified. The two parts fall at different rates, so only the
///   slower rate is a bound.
fn theory(module: &str) -> [Rate; 7] {
    use Rate::{AtMost, Exactly, Is, None};
    let linear = |e| Exactly((1.0 + 0.25) / 12.0, e);
    let edge = |e| Exactly(1.0 / 6.0, e);
    match module {
        "random" => {
            let smooth = (31.0 / 5.0) * (31.0 / 5.0) - (49.0 / 9.0) * (49.0 / 9.0);
            let disk = Exactly(DISK * (1.0 - DISK), -1.0);
            let corner = Exactly(1.0 / 4.0 - 1.0 / 9.0, -1.0);
            [None, linear(-1.0), Exactly(smooth, -1.0), edge(-1.0), Is(-1.0), corner, disk]
        }
        "jittered" => [None, linear(-2.0), Is(-2.0), edge(-1.5), Is(-1.5), Is(-1.5), Is(-1.5)],
        "multi_jittered" => {
            let edges = AtMost(-1.5);
            [None, linear(-3.0), AtMost(-2.0), edge(-2.0), edges, edges, edges]
        }
        "n_rooks" => {
            let rest = AtMost(-1.0);
            [None, linear(-3.0), rest, edge(-2.0), rest, rest, rest]
        }
        _ => {
            let any = AtMost(-1.0);
            [None, any, any, any, any, any, any]
        }
    }
}

/// The kinds whose sets differ, or are shifted: the error of one fixed set has no variance.
fn randomising() -> Vec<(&'static str, Kind)> {
    let all = Kind::ENTRIES.iter().flat_map(|e| (e.specimens)().into_iter().map(|k| (e.module, k)));
    all.filter(|(_, kind)| {
        let sampler = kind.build(&mut ()).expect("specimens are valid");
        let sets = SampleSets::new(&*sampler, 16, 1);
        sampler.is_shifted() || sets.set(0) != sets.set(1)
    })
    .collect()
}

/// The mean square of the error of each integrand, over the sets of one seed.
fn mean_squares(kind: &Kind, n: u32, seed: u64) -> [f64; 7] {
    let sampler = kind.build(&mut ()).expect("specimens are valid");
    let sets = SampleSets::new(&*sampler, n, seed);
    let n = sets.per_set();
    let mut random = Pcg32::new(seed, 21);
    let mut squares = [0.0; 7];
    for index in 0..SETS as u32 {
        let key = SetKey::new(seed, [index, 0], Purpose::Pixel);
        let points: Vec<[f64; 2]> = match sampler.is_shifted() {
            true => (0..n).map(|i| sets.draw(key, i)).collect(),
            false => sets.set(index as usize).to_vec(),
        };
        for (square, (_, draw)) in squares.iter_mut().zip(INTEGRANDS) {
            let (f, exact) = draw(&mut random);
            let mean = points.iter().map(|&at| f(at)).sum::<f64>() / f64::from(n);
            *square += (mean - exact) * (mean - exact) / SETS as f64;
        }
    }
    squares
}

/// For each integrand the points `(N, mean square of the error)`.
fn measured(kind: &Kind) -> [Vec<(f64, f64)>; 7] {
    let mut points = [const { Vec::new() }; 7];
    for (i, n) in (0..).zip(COUNTS) {
        for batch in 0..BATCHES {
            // no two batches share random numbers
            let squares = mean_squares(kind, n, u64::from(100 * batch + i));
            for (points, square) in points.iter_mut().zip(squares) {
                points.push((f64::from(n), square));
            }
        }
    }
    points
}

/// Law: the mean square of the error falls at the rate of theory: beside a straight edge as N⁻¹ for random samples
/// and as N^−1.5 for jittered ones, so that stratified samples are better. Oracle: [`theory`]'s slope must lie in
/// the fitted one's interval (99 % for all together), which must be narrow enough to tell the rates apart; where
/// the closed form is known, t tests of the ratios to it. Book: remedies: random and jittered samples.
#[test]
fn errors_of_known_integrals_fall_at_their_rates() {
    let kinds = randomising();
    assert!(kinds.len() >= 3, "{kinds:?}");
    // two tests for each: a slope and a factor
    let level = sidak(LEVEL, 2 * kinds.len() * INTEGRANDS.len());
    for (module, kind) in &kinds {
        for (((name, _), rate), points) in INTEGRANDS.iter().zip(theory(module)).zip(measured(kind))
        {
            if let Rate::None = rate {
                assert!(points.iter().all(|p| p.1 == 0.0), "{module}, {name}: {points:?}");
                continue;
            }
            let from = if let Rate::Exactly(..) = rate { 1.0 } else { SMALL_CELLS };
            let fitted: Vec<_> = points.iter().copied().filter(|p| p.0 >= from).collect();
            let fit = power_law(&fitted, 1.0 - level).expect("there are errors");
            let [low, high] = fit.interval;
            assert!(high - low < APART, "{module}, {name}: {fit:?} cannot tell rates apart");
            let right = match rate {
                Rate::None => false,
                Rate::Exactly(_, e) | Rate::Is(e) => low <= e && e <= high,
                Rate::AtMost(e) => low <= e,
            };
            assert!(right, "{module}, {name}: {fit:?} is not {rate:?}");
            if let Rate::Exactly(factor, e) = rate {
                let ratio = |&(n, square): &(f64, f64)| square * power(n, -e) / factor;
                let p = one_sample(&points.iter().map(ratio).collect::<Vec<_>>(), 1.0);
                assert!(p > level, "{module}, {name}: {fit:?} is not {rate:?}, p = {p:e}");
            }
        }
    }
}
