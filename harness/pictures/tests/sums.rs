//! Exact sums of replicas: numbers, and parts.

mod header;
mod merged;
mod seeds;

use dashu_ratio::RBig;
use groundtruth::film::Film;
use groundtruth::rgb::Rgb;
use pictures::sums::{ChannelSums, Seeds, Sums, fixed};
use testkit::properties::*;

use self::header::header;

/// Values that are easily added wrongly.
fn ugly() -> impl Strategy<Value = f64> {
    let special = prop::sample::select(vec![
        0.0,
        -0.0,
        5e-324,
        -5e-324,
        2.2e-308,
        1e-300,
        1e12,
        -1e12,
        f64::from_bits(0x3af0_0000_0000_0000), // 2⁻⁸⁰
        f64::from_bits(0x3ae0_0000_0000_0000), // 2⁻⁸¹, half a unit
        f64::from_bits(0x3af8_0000_0000_0000), // 3·2⁻⁸¹, one and a half
        -f64::from_bits(0x3af8_0000_0000_0000),
    ]);
    let any_size = (-1.0..1.0_f64, -90..40_i32)
        .prop_map(|(x, e)| x * f64::from_bits(((e + 1023) as u64) << 52));
    prop_oneof![special, any_size, 0.0..10.0_f64]
}

/// `2^80` as a rational number.
fn unit() -> RBig {
    RBig::from(1_u128 << 80)
}

fn rational(x: f64) -> RBig {
    RBig::try_from(x).expect("it is finite")
}

/// `x·2⁸⁰`, rounded to an integer, halves to even.
fn exact_fixed(x: f64) -> RBig {
    let scaled = rational(x) * unit();
    let down = RBig::from(scaled.floor());
    let (rest, half) = (scaled - down.clone(), RBig::from(1) / RBig::from(2));
    let is_odd = !(down.clone() / RBig::from(2)).is_int();
    if rest > half || rest == half && is_odd { down + RBig::from(1) } else { down }
}

/// The number of `ChannelSums::squares`.
fn squares(sums: ChannelSums) -> RBig {
    let [low, high] = sums.squares.halves();
    RBig::from(low) + RBig::from(high) * unit() * RBig::from(1_u128 << 48)
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(2000) })]

    /// Law: the sums are those of the values, each rounded once to a multiple of 2⁻⁸⁰; the mean is rounded once.
    /// Oracle: rational numbers.
    #[test]
    fn sums_are_those_of_rational_numbers(values in prop::collection::vec(ugly(), 1..40)) {
        let mut sums = ChannelSums::default();
        let (mut first, mut second) = (RBig::from(0), RBig::from(0));
        for &x in &values {
            let k = exact_fixed(x);
            prop_assert_eq!(RBig::from(fixed(x).expect("it fits")), k.clone(), "{:e}", x);
            first += k.clone();
            second += k.clone() * k;
            sums = sums.checked_add(ChannelSums::of(x).expect("it fits")).expect("they fit");
        }
        prop_assert_eq!(RBig::from(sums.sum), first.clone());
        prop_assert_eq!(squares(sums), second.clone());

        let n = RBig::from(values.len() as u64);
        let mean = first.clone() / n.clone() / unit();
        prop_assert_eq!(sums.mean(values.len() as u64), mean.to_f64().value());
        if values.len() > 1 {
            let below = n.clone() * n.clone() * (n.clone() - RBig::from(1)) * unit() * unit();
            let variance = ((n * second - first.clone() * first) / below).to_f64().value();
            let found = sums.standard_error(values.len() as u64);
            let expected = variance.sqrt();
            prop_assert!((found - expected).abs() <= SEVERAL_ULPS * expected, "{} {}", found, expected);
        }
    }
}

/// The quotient, the root and the powers of `n` are each rounded, at most five times.
const SEVERAL_ULPS: f64 = 5.0 * f64::EPSILON;

/// Law: the mean is rounded once where the quotient is just above the middle of two numbers. Oracle: rational numbers.
#[test]
fn a_mean_just_above_the_middle_is_rounded_up() {
    let middle = ((3_i128 << 52) + 1) << 71;
    for past in [-1, 0, 1] {
        let sums = ChannelSums { sum: 3 * middle + past, ..ChannelSums::default() };
        let exact = RBig::from(sums.sum) / RBig::from(3) / unit();
        assert_eq!(sums.mean(3), exact.to_f64().value(), "{past}");
    }
}

/// Law: what does not fit is refused, with its pixel: 2⁴⁷, also as a sum; not what is just below. Oracle: the limit.
#[test]
fn a_pixel_that_does_not_fit_is_named() {
    let limit = 140_737_488_355_328.0; // 2⁴⁷
    assert_eq!(fixed(limit), None);
    assert_eq!(fixed(-limit), None);
    assert_eq!(fixed(f64::MAX), None);
    assert!(fixed(limit.next_down()).is_some() && fixed((-limit).next_up()).is_some());
    let mut film = Film::new(3, 2);
    film.set([1, 1], Rgb::new(0.0, 0.6 * limit, 0.0));
    let mut sums = Sums::new(header([3, 2]));
    sums.add(&film, 0).expect("it fits");
    let error = sums.add(&film, 1).expect_err("the sum does not fit");
    assert_eq!(error.to_string(), "pixel 1, 1: the sum of the green channel reaches 2^47");
}

/// Law: the mean of a channel with a value that is not finite is that of floating-point numbers, and its standard
/// error is NaN; other channels are not touched. Oracle: the rules of IEEE 754.
#[test]
fn values_that_are_not_finite_count_as_such() {
    let mut sums = Sums::new(header([1, 1]));
    for (seed, red) in [f64::INFINITY, 1.0, -f64::NAN].into_iter().enumerate() {
        let mut film = Film::new(1, 1);
        film.set([0, 0], Rgb::new(red, f64::INFINITY, 3.0));
        sums.add(&film, seed as u64).expect("they fit");
    }
    assert_eq!(sums.not_finite().collect::<Vec<_>>(), [[0, 0]]);
    let [r, g, b] = sums.mean().get([0, 0]).to_array();
    assert!(r.is_nan() && g == f64::INFINITY && b == 3.0);
    let [r, g, b] = sums.standard_error().expect("three").get([0, 0]).to_array();
    assert!(r.is_nan() && g.is_nan() && b == 0.0);
}

/// Law: sums are read back as they were written, with each field of the header of any value. Oracle: the sums.
#[test]
fn sums_are_read_back() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("a.sums");
    let mut other = header([3, 2]);
    (other.made.max_depth, other.samples) = (None, 1);
    other.arguments = vec!["a \"b\"".to_owned(), "ü\n".to_owned()];
    let far = Seeds::range(u64::MAX - 1, 1).expect("it fits");
    other.wanted = far.union(&Seeds::range(0, 2).expect("they fit"));
    for header in [header([3, 2]), other] {
        let mut sums = Sums::new(header);
        let mut film = Film::new(3, 2);
        film.set([2, 1], Rgb::new(-1.5, f64::NAN, f64::NEG_INFINITY));
        sums.add(&film, u64::MAX - 1).expect("it fits");
        sums.write(&file).expect("written");
        assert_eq!(Sums::read(&file).expect("whole"), sums);
    }
}

/// Law: a file of no replica or of no pixel is refused with its name, though its digest is right. Oracle: its header.
#[test]
fn a_file_of_nothing_is_refused() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("a.sums");
    let mut of_no_pixel = Sums::new(header([0, 2]));
    of_no_pixel.add(&Film::new(0, 2), 1).expect("it fits");
    for sums in [Sums::new(header([3, 2])), of_no_pixel] {
        sums.write(&file).expect("written");
        let problem = Sums::read(&file).expect_err("it is of nothing").to_string();
        assert!(problem.ends_with("it is of no replica or of no pixel"), "{problem}");
        assert!(problem.contains("a.sums"), "{problem}");
    }
}
