//! Random numbers: published vectors, and uniform where it matters.

use groundtruth::math::{hash, splitmix};
use testkit::properties::*;

use crate::prelude::*;
use crate::support::statistics::{assert_all_equal, moments};

/// Law: PCG32 is the published generator. Oracle: the demo of O'Neill's minimal C library (seed 42,
/// stream 54).
#[test]
fn pcg32_gives_the_published_numbers() {
    let mut random = Pcg32::new(42, 54);
    let published = [0xa15c_02b7, 0x7b47_f409, 0xba1d_3330, 0x83d2_f293, 0xbfa4_784b, 0xcbed_606e];
    assert_eq!(published, std::array::from_fn(|_| random.next_u32()));
}

/// Law: SplitMix64 is the published generator. Oracle: its published sequence from the seed 1234567; its
/// state advances by 64 bits of the golden ratio.
#[test]
fn splitmix_gives_the_published_numbers() {
    let published: [u64; 5] = [
        6_457_827_717_110_365_317,
        3_203_168_211_198_807_973,
        9_817_491_932_198_370_423,
        4_593_380_528_125_082_431,
        16_408_922_859_458_223_821,
    ];
    let state = |i: u64| 1_234_567_u64.wrapping_add(i.wrapping_mul(0x9e37_79b9_7f4a_7c15));
    assert_eq!(published, std::array::from_fn(|i| splitmix(state(i as u64))));
}

/// Law: a hash depends on each word, its position, and the number of words. Oracle: the hashes of all
/// sequences of up to three small numbers differ pairwise.
#[test]
fn hashes_of_different_words_differ() {
    let mut seen = std::collections::HashSet::new();
    for a in 0..20 {
        assert!(seen.insert(hash(&[a])), "the hash of {a} is that of other words");
        for b in 0..20 {
            assert!(seen.insert(hash(&[a, b])), "the hash of {a} {b} is that of other words");
            (0..20).for_each(|c| {
                assert!(
                    seen.insert(hash(&[a, b, c])),
                    "the hash of {a} {b} {c} is that of other words"
                )
            });
        }
    }
}

/// Law: about half of a hash's 64 bits change with any bit of any word. Oracle: the binomial
/// distribution of 64 fair coins, whose mean over the 192 changes has the variance 16/192.
#[test]
fn hashes_avalanche() {
    for base in [[0, 0, 0], [1, 5, 9], [u64::MAX, 0, 3]] {
        let changed = (0..192).map(|bit| {
            let mut words = base;
            words[bit / 64] ^= 1 << (bit % 64);
            (hash(&words) ^ hash(&base)).count_ones()
        });
        let mean = changed.sum::<u32>() as f64 / 192.0;
        assert!((mean - 32.0).abs() < most_sigmas(3) * (16.0_f64 / 192.0).sqrt(), "{mean}");
    }
}

/// Law: uniform numbers are in [0, 1), the largest being 1 − 2⁻⁵³ and never 1 (the book's can be 1): the
/// multiples of 2⁻⁵³, each of the 53 bits a fair coin. Oracle: the bits of the number times 2⁵³, an exact
/// product.
/// Book: 2.11, random numbers.
#[test]
fn uniform_numbers_are_half_open_with_53_fair_bits() {
    const DRAWS: u32 = 100_000;
    let mut random = Pcg32::new(3, 1);
    let mut ones = [0_u64; 53];
    for _ in 0..DRAWS {
        let u = random.uniform();
        at_least!(u, 0.0);
        below!(u, 1.0);
        let scaled = u * 9_007_199_254_740_992.0;
        assert_eq!(scaled, scaled.floor());
        let bits = scaled as u64;
        (0..53).for_each(|i| ones[i] += bits >> i & 1);
    }
    for (i, &count) in ones.iter().enumerate() {
        assert_all_equal(&format!("bit {i}: {count}"), &[count, u64::from(DRAWS) - count], 5e4, 53);
    }
}

/// Law: uniform numbers have equally full cells, the mean ½ and the variance 1/12. Oracle: χ² (the book's 10
/// cells of about 100, and 1000 cells of about 1000); the variance of (u − ½)² is 1/180.
/// Book: 2.11, random numbers.
#[test]
fn uniform_numbers_are_uniform() {
    let mut random = Pcg32::new(17, 4);
    for (cells, each) in [(10, 100), (1000, 1000)] {
        let mut counts = vec![0; cells];
        for _ in 0..cells * each {
            counts[(random.uniform() * cells as f64) as usize] += 1;
        }
        assert_all_equal("counts", &counts, each as f64, 4);
    }
    let draws: Vec<f64> = (0..1_000_000).map(|_| random.uniform()).collect();
    near!(sigmas(&draws, 0.5), 0.0, most_sigmas(4));
    let (_, variance) = moments(&draws);
    near!(variance, 1.0 / 12.0, most_sigmas(4) * (1.0_f64 / 180.0 / 1e6).sqrt());
}

/// Law: whole numbers below n are not biased. Oracle: for n = 3·2³⁰ the remainder alone would give
/// the lowest third twice its share.
#[test]
fn whole_numbers_are_not_biased() {
    let mut random = Pcg32::new(5, 0);
    let mut thirds = [0; 3];
    for _ in 0..30_000 {
        thirds[(random.below(3 << 30) >> 30) as usize] += 1;
    }
    assert_all_equal("thirds", &thirds, 10_000.0, 2);
    let mut dice = [0; 6];
    (0..6000).for_each(|_| dice[random.below(6) as usize] += 1);
    assert_all_equal("dice", &dice, 1000.0, 2);
}

/// Law: a shuffle gives every order equally often. Oracle: all 24 orders of four things; swapping with any
/// index (the usual mistake) has 4⁴ = 256 equally likely outcomes, not a multiple of 24.
#[test]
fn every_order_is_equally_likely() {
    let mut random = Pcg32::new(6, 0);
    let mut orders = std::collections::HashMap::new();
    for _ in 0..48_000 {
        let mut items = [0, 1, 2, 3];
        random.shuffle(&mut items);
        *orders.entry(items).or_insert(0_u64) += 1;
    }
    assert_eq!(orders.len(), 24);
    assert_all_equal("orders", &orders.into_values().collect::<Vec<_>>(), 2000.0, 1);
}

proptest! {
    #![proptest_config(laws())]

    /// Law: the same seed and stream give the same numbers, again and again; the next number, another seed
    /// and another stream give others. A whole number below n is below n. Oracle: two of 2⁵³ numbers are
    /// almost never equal.
    /// Book: 2.11, random numbers.
    #[test]
    fn a_seed_reproduces_its_numbers(seed: u64, stream: u64, n in 1..u32::MAX) {
        let [mut a, mut b] = [(); 2].map(|()| Pcg32::new(seed, stream));
        below!(a.below(n), n);
        b.below(n);
        let (first, second) = (a.uniform(), a.uniform());
        prop_assert_eq!([first, second], [b.uniform(), b.uniform()]);
        prop_assert!(first != second, "{first} twice from seed {seed}, stream {stream}");
        let others =
            [(seed ^ 1, stream), (seed, stream ^ 1)].map(|(s, t)| Pcg32::new(s, t).uniform());
        let own = Pcg32::new(seed, stream).uniform();
        prop_assert!(
            !others.contains(&own),
            "{own} from seed {seed}, stream {stream} and its neighbours"
        );
        prop_assert_eq!(a.below(1), 0);
    }
}
