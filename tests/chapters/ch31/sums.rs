//! Sums of octaves: fractal sum, turbulence, fBm, and their bounds.

use groundtruth::noise::MAX_OCTAVES;
use testkit::properties::*;

use super::oracle::{self, built};
use crate::prelude::*;

/// A coordinate of 20 times 5⁵ is rounded to 7e-12; noise has a slope of at most 7. The slope of a sum grows
/// with the gain, which the bound divides out.
const ROUNDING: f64 = 1e-9;

proptest! {
    #![proptest_config(laws())]

    /// Law: fBm, fractal sum and turbulence, and the sums of vectors, follow their formulas, for any gain and
    /// lacunarity; fractal sum and turbulence have a gain of 1/2 and a lacunarity of 2, whatever those of fBm
    /// are. Oracle: explicit sums of the second implementation, the bounds in closed form.
    /// Book: fractal sums, turbulence and fBm.
    #[test]
    fn octaves_add_up_as_the_formulas_say(p in point(20.0), noise in oracle::noises()) {
        let it = built(noise);
        let lattice = it.lattice();
        let half = oracle::bound(0.5, noise.octaves);
        let sum = |f: &dyn Fn(f64) -> f64| oracle::sum(&noise, (0.5, 2.0), lattice, p, f);
        for (name, found, expected) in [
            ("fBm", it.value_fbm(p), oracle::fbm(&noise, lattice, p)),
            ("fractal sum", it.value_fractal_sum(p), (sum(&|n| n) + half) / (2.0 * half)),
            ("turbulence", it.value_turbulence(p), sum(&f64::abs) / half),
        ] {
            let off = (found - expected).abs();
            prop_assert!(off < ROUNDING, "{} is {}, expected {}", name, found, expected);
        }
        let halved = Noise { gain: 0.5, lacunarity: 2.0, ..noise };
        for (name, found, noise) in [
            ("vector fBm", it.vector_fbm(p), noise),
            ("vector fractal sum", it.vector_fractal_sum(p), halved),
        ] {
            let expected = oracle::vector_fbm(&noise, lattice, p);
            let off = (found - expected).length() / oracle::bound(noise.gain, noise.octaves);
            prop_assert!(off < ROUNDING, "{} is {:?}, expected {:?}", name, found, expected);
        }
    }

    /// Law: one octave of fBm is `(noise + 1)/2`, and of turbulence `|noise|`, whatever the gain; fBm of gain 1/2 and
    /// lacunarity 2 is the fractal sum. Oracle: one function against another.
    /// Book: fractal sums, turbulence and fBm.
    #[test]
    fn one_octave_is_the_noise_and_halving_octaves_are_the_fractal_sum(
        p in point(20.0),
        noise in oracle::noises(),
    ) {
        let one = built(Noise { octaves: 1, ..noise });
        near!(one.value_fbm(p), 0.5 * (one.value(p) + 1.0), 2.0 * U);
        near!(one.value_turbulence(p), one.value(p).abs(), 2.0 * U);
        let halving = built(Noise { gain: 0.5, lacunarity: 2.0, ..noise });
        near!(halving.value_fbm(p), halving.value_fractal_sum(p), 4.0 * U);
    }

    /// Law: fBm, fractal sum and turbulence are from 0 to 1, to the last bit, for any number of octaves
    /// and any gain and lacunarity, near and far.
    /// Book: fractal sums, turbulence and fBm.
    #[test]
    fn sums_are_from_0_to_1(
        p in prop_oneof![point(10.0), point(1e6), point(1e300)],
        octaves in 1..=MAX_OCTAVES,
        exponents in (-3.0..3.0_f64, -3.0..3.0_f64),
    ) {
        let [gain, lacunarity] =
            [exponents.0, exponents.1].map(|e| groundtruth::math::power(10.0, e));
        let noise = built(Noise { gain, lacunarity, ..Noise::of_octaves(octaves) });
        for value in [noise.value_fbm(p), noise.value_fractal_sum(p), noise.value_turbulence(p)] {
            prop_assert!((0.0..=1.0).contains(&value), "{} for {:?}", value, noise);
        }
    }
}

/// Law: the bounds of fBm are 1, 1.5, 1.875, 1.96875, 1.9921875 for 1, 2, 4, 6, 8 octaves of gain 1/2, and 63
/// for 6 of gain 2; n for gain 1. Oracle: those numbers; at integer points, which lacunarity 2 keeps on the
/// lattice, the sum is one of table entries.
/// Book: fractal sums, turbulence and fBm.
#[test]
fn bounds_are_the_books() {
    for (gain, octaves, max) in [
        (0.5, 1, 1.0),
        (0.5, 2, 1.5),
        (0.5, 4, 1.875),
        (0.5, 6, 1.968_75),
        (0.5, 8, 1.992_187_5),
        (2.0, 6, 63.0),
        (1.0, 5, 5.0),
    ] {
        let noise = built(Noise { gain, ..Noise::of_octaves(octaves) });
        let lattice = noise.lattice();
        for i in 1..50 {
            let octave = |j: u32| {
                let knot = [3 * i, -i, 7].map(|c: i64| c << j);
                oracle::power(gain, j) * lattice.values()[oracle::index(lattice, knot)]
            };
            let sum: f64 = (0..octaves).map(octave).sum();
            let found = noise.value_fbm(Point::new(3.0 * i as f64, -i as f64, 7.0));
            let expected = (sum + max) / (2.0 * max);
            assert!((found - expected).abs() < 1e-15, "{found}, expected {expected}");
        }
    }
}

/// Law: a sum as large as it can be is 1 to the last bit, and one as small as it can be 0, for any gain and
/// number of octaves. Oracle: points where cubic noise is clamped, with lacunarity 1, so that every octave is
/// 1 there, or −1. (A bound by the closed form is off by roundings.)
#[test]
fn a_sum_at_its_bound_is_exactly_1_or_0() {
    let one = built(Noise::default());
    let mut random = Pcg32::new(31, 4);
    let mut ends = [0, 0];
    for _ in 0..30_000 {
        let p = Point::from([(); 3].map(|()| 200.0 * random.uniform()));
        let value = one.value(p);
        if value.abs() < 1.0 {
            continue;
        }
        let (gain, octaves) = (3.0 * random.uniform() + 0.01, 2 + random.below(30));
        let noise = built(Noise { gain, lacunarity: 1.0, ..Noise::of_octaves(octaves) });
        let expected = if value > 0.0 { 1.0 } else { 0.0 };
        assert_eq!(noise.value_fbm(p), expected, "gain {gain}, {octaves} octaves at {p:?}");
        ends[usize::from(value > 0.0)] += 1;
    }
    assert!(ends[0] > 10 && ends[1] > 10, "the bounds were met {ends:?} times");
}
