//! Hammersley's and Sobol's points, digit by digit.

use groundtruth::samplers::{Hammersley, Purpose, SampleSets, SetKey, Sobol, permuted};

use crate::prelude::*;
use crate::support::samples::{assert_once_each, built, occupied};
use crate::support::statistics::assert_all_equal;

fn hammersley(n: u32) -> Vec<[f64; 2]> {
    built(Hammersley { shifted: false }).fill(n, &mut Pcg32::new(0, 0))
}

/// Law: Hammersley's point i is `(i/N, Φ(i))`, with `Φ(1) = 1/2`, `Φ(2) = 1/4`, `Φ(3) = 3/4`, `Φ(6) = 3/8`.
/// Oracle: the book's table, and the binary digits of i written as text and mirrored.
/// Book: Hammersley sampling: the radical inverse.
#[test]
fn hammersley_points_are_the_mirrored_digits() {
    let points = hammersley(1000);
    for (i, y) in [(0, 0.0), (1, 0.5), (2, 0.25), (3, 0.75), (6, 0.375)] {
        assert_eq!(points[i][1], y);
    }
    for (i, &[x, y]) in (0_u32..).zip(&points) {
        assert_eq!(x, f64::from(i) / 1000.0);
        let digits = format!("{i:b}");
        let read = |sum: f64, digit: char| 0.5 * (sum + f64::from(u8::from(digit == '1')));
        assert_eq!(y, digits.chars().fold(0.0, read), "{i}");
    }
}

/// Law: Hammersley's set is the same for every set, seed and pixel; shifted, it is the same set still,
/// but draws of two pixels have no point in common. Oracle: the set.
/// Book: Hammersley sampling: the radical inverse.
#[test]
fn hammersley_has_one_set() {
    let fixed = hammersley(10);
    for shifted in [false, true] {
        for seed in [1, 2] {
            let sets = SampleSets::new(&*built(Hammersley { shifted }), 10, seed);
            (0..83).for_each(|i| assert_eq!(sets.set(i), fixed, "set {i}"));
            for x in 0..20 {
                let key = SetKey::new(seed, [x, 0], Purpose::Pixel);
                let drawn: Vec<_> = (0..10).map(|i| sets.draw(key, i)).collect();
                assert_eq!(
                    drawn.iter().filter(|p| fixed.contains(p)).count(),
                    10 * usize::from(!shifted)
                );
            }
        }
    }
}

/// The first two dimensions of Sobol's sequence, as words of `m` digits. The first mirrors i; digit r of
/// the second is the sum of the digits k of i times `(k over r)`, without carries: Pascal's triangle
/// modulo 2, which the polynomial 1 + x generates.
fn sobol(i: u32, m: u32) -> [u32; 2] {
    // (k over r) is odd if and only if every binary digit 1 of r is also 1 in k (Lucas)
    let odd = |k: u32, r: u32| k & r == r;
    let digit = |r: u32| (0..m).filter(|&k| i >> k & 1 == 1 && odd(k, r)).count() as u32 & 1;
    let mirrored = (0..m).fold(0, |word, k| 2 * word + (i >> k & 1));
    [mirrored, (0..m).fold(0, |word, r| 2 * word + digit(r))]
}

/// The first `m` digits of a number.
fn digits(x: f64, m: u32) -> u32 {
    (x * f64::from(1_u32 << m)) as u32
}

/// Law: the scramble is nested: two points of Sobol's that share exactly their first k digits share exactly k
/// digits after scrambling, in both dimensions. Oracle: Pascal's triangle for the points, and whole numbers.
#[test]
fn the_scramble_is_nested() {
    let shared = |a: u32, b: u32| (a ^ b).leading_zeros();
    let mut random = Pcg32::new(20, 20);
    for m in std::iter::repeat_n(7, 20).chain([10]) {
        let scrambled = built(Sobol {}).fill(1 << m, &mut random);
        for axis in 0..2 {
            let words: Vec<(u32, u32)> = (0..)
                .zip(&scrambled)
                .map(|(i, point)| (sobol(i, m)[axis], digits(point[axis], m)))
                .collect();
            for &(a, found) in &words {
                for &(b, other) in &words {
                    assert_eq!(shared(a, b), shared(found, other), "axis {axis}: {a} and {b}");
                }
            }
        }
    }
}

/// Law: the random bits of the scramble are fair and independent: all 256 values of the eight bits for the
/// fourth digit are equally likely, and so are those of the bits for the first three digits with one for the
/// fourth; the bits of x and y are independent. Oracle: χ² over 25 600 sets.
#[test]
fn the_coins_of_the_scramble_are_fair_and_independent() {
    let (sampler, mut random) = (built(Sobol {}), Pcg32::new(95, 95));
    let mut counts = [[0_u64; 256]; 5];
    for _ in 0..25_600 {
        let set = sampler.fill(16, &mut random);
        // coins[axis][node]: node 1 decides on the first digit, the children of node i are 2 i and 2 i + 1
        let mut coins = [[0_usize; 16]; 2];
        for (i, point) in (0..).zip(&set) {
            for axis in 0..2 {
                let (word, found) = (sobol(i, 4)[axis], digits(point[axis], 4));
                for k in 0..4 {
                    let node = 1 << k | word >> (4 - k);
                    coins[axis][node as usize] = ((word ^ found) >> (3 - k) & 1) as usize;
                }
            }
        }
        let pattern = |coins: &[usize]| coins.iter().fold(0, |word, coin| 2 * word + coin);
        for axis in 0..2 {
            counts[axis][pattern(&coins[axis][8..])] += 1;
            counts[2 + axis][pattern(&coins[axis][1..9])] += 1;
        }
        counts[4][16 * pattern(&coins[0][1..5]) + pattern(&coins[1][1..5])] += 1;
    }
    for counts in counts {
        assert_all_equal("counts", &counts, 100.0, 5);
    }
}

/// Law: the first 2^m points of Sobol's set lie one in each box `2^−a × 2^(a−m)`, although the set goes on;
/// for other counts the numbers of points in two boxes differ by at most one. Oracle: counting.
#[test]
fn prefixes_of_sobol_are_nets_too() {
    let set = built(Sobol {}).fill(300, &mut Pcg32::new(7, 7));
    for m in 0..=8 {
        for a in 0..=m {
            assert_once_each(&format!("{m}, {a}"), &set[..1 << m], 1 << a, 1 << (m - a));
        }
    }
    for a in 0..=8 {
        let counts = occupied(&set, 1 << a, 1 << (8 - a));
        assert!(counts.iter().all(|count| (1..=2).contains(count)), "{a}");
    }
}

/// Law: Pascal's triangle makes Sobol's points. Oracle: the numbers that Joe & Kuo's
/// program prints for two dimensions, whose order is the Gray code's: their i-th point is
/// `i ⊕ i/2`.
#[test]
fn the_sequence_has_the_published_points() {
    let published = [
        [0.0, 0.0],
        [0.5, 0.5],
        [0.75, 0.25],
        [0.25, 0.75],
        [0.375, 0.375],
        [0.875, 0.875],
        [0.625, 0.125],
        [0.125, 0.625],
        [0.1875, 0.3125],
        [0.6875, 0.8125],
    ];
    for (i, point) in (0..).zip(published) {
        let found = sobol(i ^ i >> 1, 32).map(|bits| f64::from(bits) / 4_294_967_296.0);
        assert_eq!(found, point, "{i}");
    }
}

/// Law: the permutations are the paper's. Oracle: `permute_kensler` of Mitsuba 3.9.1.
#[test]
fn permutations_are_those_of_the_paper() {
    let published: [(u32, &[u32]); 6] = [
        (7, &[0]),
        (1, &[0, 1]),
        (3, &[4, 0, 2, 3, 1]),
        (1, &[5, 1, 0, 7, 3, 2, 4, 6]),
        (0xa511_e9b3, &[5, 2, 0, 10, 11, 9, 4, 7, 6, 8, 3, 1, 12]),
        (u32::MAX, &[10, 4, 1, 11, 7, 0, 9, 3, 6, 13, 15, 5, 14, 12, 8, 2]),
    ];
    for (pattern, expected) in published {
        let n = expected.len() as u32;
        let found: Vec<u32> = (0..n).map(|i| permuted(i, n, pattern)).collect();
        assert_eq!(found, expected, "pattern {pattern}");
    }
}

/// Law: each pattern is a permutation. Oracle: sorting, for every n up to 99 and next to powers
/// of two.
#[test]
fn every_pattern_permutes() {
    let mut random = Pcg32::new(2013, 0);
    for n in (1..100).chain([127, 128, 129, 1023, 1024, 1025]) {
        let pattern = random.next_u32();
        let mut found: Vec<u32> = (0..n).map(|i| permuted(i, n, pattern)).collect();
        found.sort_unstable();
        assert!(found.into_iter().eq(0..n), "{n}, pattern {pattern}");
    }
}
