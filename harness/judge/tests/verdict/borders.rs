//! Borders of what is judged: values that are refused, negative ones, seeds, and the numbers that stored values stand for.

use groundtruth::film::{Film, OutOfGamut};
use groundtruth::math::power_of_two;
use groundtruth::rgb::Rgb;
use judge::verdict::{
    Bright, Negative, Quantiser, Reference, Stored, refusal, refusal_of_alpha, refusal_of_seed,
};
use pictures::compare::{Picture, Transfer};
use pictures::sums::{Header, Seeds, Sums};

use super::header::header;
use crate::verbs::{equal, near};

/// Law: a value that is no finite number is refused, by the first pixel that has one, whichever channel it is in, and alpha
/// below 1 too. Oracle: where it is put.
#[test]
fn values_that_are_no_radiance_are_refused() {
    let good = Picture::of_radiance(&[0.5; 3 * 12], [4, 3]);
    equal("refusal of a good picture", refusal(&good), None);
    for value in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        for at in 0..12 {
            for channel in 0..3 {
                let mut bad = good.clone();
                bad.values[at][channel] = value;
                bad.values[11] = [value; 3];
                let said = refusal(&bad).unwrap_or_default();
                let place = format!("pixel {}, {} is ", at % 4, at / 4);
                assert!(said.starts_with(&place), "found `{said}`, expected `{place}…`");
            }
        }
    }
    for (transparent, is_refused) in [(0, false), (1, true), (7, true)] {
        let picture = Picture { transparent, ..good.clone() };
        equal("alpha is refused", refusal_of_alpha(&picture).is_some(), is_refused);
        equal("the picture is refused", refusal(&picture).is_some(), is_refused);
    }
}

/// Law: negative values are counted, the lowest is located, and counts if it is more than 1e-5 of the mean below 0. Oracle:
/// where they are put, on both sides of the border.
#[test]
fn negative_values_begin_below_rounding() {
    let with = |values: &[(usize, f32)]| {
        let mut picture = Picture::of_radiance(&[0.5; 3 * 12], [4, 3]);
        for (at, value) in values {
            picture.values.as_flattened_mut()[*at] = *value;
        }
        picture
    };
    let of = |pictures: &[Picture]| Negative::of(pictures, (0.0, 2.0));
    assert!(of(&[with(&[(0, 0.0), (1, -0.0), (2, f32::NAN)])]).is_none(), "nothing is negative");
    for (lowest, counts) in [(-1.99e-5, false), (-2.01e-5, true), (-1e-30, false), (-7.0, true)] {
        let values = [(5, 0.5 * lowest), (3 * 6 + 2, lowest), (35, 0.9 * lowest)];
        let found = of(&[with(&[]), with(&values)]).expect("three");
        equal(format!("{lowest}: values"), found.values, 3);
        equal(format!("{lowest}: place"), found.at, [2, 1]);
        equal(format!("{lowest}: lowest"), found.lowest, lowest);
        equal(format!("{lowest} counts"), found.counts, counts);
    }
    let single = of(&[with(&[(34, -1.0)])]).expect("one");
    equal("place of the only one", (single.values, single.at), (1, [3, 2]));
}

/// Law: seeds are refused if fewer than a million numbers follow. Oracle: numbers on both sides of the border.
#[test]
fn the_last_seed_is_a_border() {
    let last = u64::MAX - 1_000_000;
    for (seed, is_refused) in [(0, false), (last, false), (last + 1, true), (u64::MAX, true)] {
        equal(format!("seed {seed} is refused"), refusal_of_seed(seed).is_some(), is_refused);
    }
}

/// Sums of a picture of one pixel with these seeds; the replica of a seed is that seed.
fn sums(seeds: &Seeds) -> (Sums, Header) {
    let header = header([1, 1]);
    let mut sums = Sums::new(header.clone());
    for seed in seeds.iter() {
        let mut film = Film::new(1, 1);
        film.set([0, 0], Rgb::grey(seed as f64));
        sums.add(&film, seed).expect("it fits");
    }
    (sums, header)
}

/// Law: our seeds begin at the least one, not below the one asked for, such that it and all later ones are missing in the
/// reference: no picture of ours is in its mean. The mean is that of its pictures, and has their number. Oracle: all sets of
/// seeds below 6, tried one by one.
#[test]
fn seeds_of_a_reference_never_come_again() {
    let stored = Stored::Floats { bits: 24 };
    for bits in 1_u64..64 {
        let all: Vec<u64> = (0..6).filter(|seed| bits >> seed & 1 == 1).collect();
        let one = |seed: &u64| Seeds::range(*seed, 1).expect("it fits");
        let seeds = all.iter().map(one).fold(Seeds::default(), |all, it| all.union(&it));
        let (sums, header) = sums(&seeds);
        let reference = Reference::new(&sums, &header).expect("of one scene");
        for asked in 0..8 {
            let is_free = |from: &u64| (*from..10).all(|seed| !all.contains(&seed));
            let expected = (asked..).find(is_free).expect("there is one");
            let what = format!("first seed from {asked} on, reference of {all:?}");
            equal(what, reference.first_free(asked), expected);
        }
        let mean = reference.mean(stored);
        near("pictures of the mean", mean.pictures, all.len() as f64, 0.0);
        let expected = all.iter().sum::<u64>() as f64 / all.len() as f64;
        near("mean", mean.values[0], expected, 1e-6);
    }
}

/// Law: a reference of another scene, size, number of samples or version is refused, and one with a value that is no number.
/// Oracle: each field changed.
#[test]
fn a_reference_is_of_the_scene() {
    let (sums, header) = sums(&Seeds::range(3, 2).expect("they fit"));
    let others = [
        Header { program: "2".to_owned(), ..header.clone() },
        Header { scene: "6".repeat(64), ..header.clone() },
        Header { size: [1, 2], ..header.clone() },
        Header { samples: 5, ..header.clone() },
    ];
    for other in others {
        assert!(Reference::new(&sums, &other).is_err(), "it is taken for one of {other:?}");
    }
    let mut bad = sums.clone();
    let mut film = Film::new(1, 1);
    film.set([0, 0], Rgb::new(1.0, 1.0, f64::NAN));
    bad.add(&film, 9).expect("it is listed");
    let said = Reference::new(&bad, &header).err().unwrap_or_default();
    equal("error", &*said, "a replica has a value that is no number at pixel 0, 0");
}

/// All ways to store integers.
fn ways() -> Vec<(Stored, f64)> {
    let transfers = [1.8, 2.0, 2.2, 2.4].map(Transfer::Gamma).into_iter();
    let transfers: Vec<Transfer> = transfers.chain([Transfer::Srgb, Transfer::Linear]).collect();
    let of = |largest: f64| {
        let transfers = transfers.clone();
        transfers.into_iter().flat_map(move |transfer| {
            let stored = move |quantiser| {
                let bright = Bright::Clamped;
                (Stored::Integers { step: 1.0 / largest, transfer, quantiser, bright }, largest)
            };
            Quantiser::ALL.map(stored)
        })
    };
    [255.0, 65_535.0].into_iter().flat_map(of).collect()
}

/// Law: in each way to store integers, the radiance that an integer is read as is stored as that integer again, and grows with
/// the integer. Oracle: the integers, all of 8 bits and some of 16.
#[test]
fn what_is_read_is_stored_so_again() {
    for (stored, largest) in ways() {
        let step = if largest > 255.0 { 251 } else { 1 };
        let integers = || (0..=largest as u32).step_by(step);
        let mut before = -1.0;
        for integer in integers() {
            let value = (f64::from(integer) / largest) as f32;
            let radiance = f64::from(stored.read(value));
            let what = format!("{stored}: integer {integer}");
            let again = stored.integers(Rgb::grey(radiance)).expect("integers")[0];
            // of truncated sRGB, only values from 1 on have the largest
            if f64::from(integer) < largest {
                near(&what, again, f64::from(integer), 0.0);
            }
            assert!(radiance > before, "{what}: read as {radiance}, the one before as {before}");
            before = radiance;
        }
    }
}

/// Law: the tolerance of an integer is a thousandth more than the distance of the farther neighbour, and 1e-5 of the radiance.
/// Oracle: the radiances that the neighbours are read as, for all integers of 8 bits.
#[test]
fn the_tolerance_reaches_the_farther_neighbour() {
    for (stored, largest) in ways().into_iter().filter(|it| it.1 == 255.0) {
        let read =
            |integer: f64| f64::from(stored.read((integer.clamp(0.0, largest) / largest) as f32));
        // of truncated sRGB, only values from 1 on have the largest
        for integer in (0..254).map(f64::from) {
            let [below, here, above] = [-1.0, 0.0, 1.0].map(|by| read(integer + by));
            let expected = 1.001 * (above - here).max(here - below) + 1e-5 * here;
            let what = format!("{stored}, {integer}: tolerance");
            near(what, stored.tolerance(here), expected, 1e-4 * expected);
        }
    }
}

/// Law: with a shared exponent, channels are cut to multiples of the power of two of which the largest has from 128 to 255 (Ward,
/// 1991). Oracle: that power, searched from the smallest on.
#[test]
fn a_shared_exponent_keeps_eight_bits_of_the_largest_channel() {
    for exponent in -60..60 {
        for [r, g, b] in [[1.0, 0.7, 0.003], [0.3, 1.99, 1.0], [0.01, 0.02, 1.4], [1.0, 1.0, 1.0]] {
            let color = [r, g, b].map(|x| x * power_of_two(exponent));
            let largest = color.into_iter().fold(0.0, f64::max);
            let mut units = (-90..90).map(power_of_two);
            let unit = units.find(|unit| largest / unit < 256.0).expect("one of them");
            let mut film = Film::new(1, 1);
            film.set([0, 0], Rgb::from(color));
            let found = Stored::SharedExponent.values(&film);
            let expected = color.map(|x| ((x / unit).floor() * unit) as f32);
            equal(format!("{color:?} with a shared exponent"), found, expected.to_vec());
        }
    }
}

/// Law: rounding to integers has the standard deviation of a uniform error over the radiances that are stored as one integer,
/// and the slack of means is a tenth of their range. Oracle: the ends of that range by bisection, and its length over √12.
#[test]
fn rounding_is_that_of_an_interval() {
    for (stored, largest) in ways().into_iter().filter(|it| it.1 == 255.0) {
        for integer in [5.0, 60.0, 128.0, 250.0] {
            let radiance = f64::from(stored.read((integer / largest) as f32));
            let of = |radiance: f64| stored.integers(Rgb::grey(radiance)).expect("integers")[0];
            let border = |wanted: f64| {
                let [mut low, mut high] = [0.0, 1.0];
                for _ in 0..60 {
                    let middle = 0.5 * (low + high);
                    if of(middle) < wanted { low = middle } else { high = middle }
                }
                high
            };
            let length = border(integer + 1.0) - border(integer);
            let expected = length / 12.0_f64.sqrt();
            near(
                format!("{stored}, {integer}"),
                stored.rounding(radiance),
                expected,
                0.01 * expected,
            );
            let mut film = Film::new(1, 1);
            film.set([0, 0], Rgb::grey(radiance));
            let slack = stored.slack(&film)[0];
            near(format!("{stored}, {integer}: slack"), slack, 0.1 * length, 0.002 * length);
        }
    }
}

/// Law: floats of 24 and 11 bits and shared exponents are told by their values, and display values are put in the order of
/// the likeliest: the scene's own gamma first, rounded first; or only the stated curve. Oracle: numbers with so many bits.
#[test]
fn ways_are_told_by_the_bits_of_values() {
    let tone = (2.2, OutOfGamut::MaxToOne);
    let of = |value: f32| {
        Stored::candidates(&Picture::of_radiance(&[0.0, 1.0, value], [1, 1]), None, tone)
    };
    // 1 + 2⁻ⁿ has n + 1 bits
    let with_bits = |n: i32| 1.0 + 2.0_f32.powi(-n);
    for (bits, expected) in [
        (7, Stored::SharedExponent),
        (8, Stored::Floats { bits: 11 }),
        (10, Stored::Floats { bits: 11 }),
        (11, Stored::Floats { bits: 24 }),
        (23, Stored::Floats { bits: 24 }),
    ] {
        equal(format!("{} bits", bits + 1), of(with_bits(bits)), vec![expected]);
    }
    let display = Picture { step: Some(1.0 / 255.0), ..Picture::of_radiance(&[0.0; 3], [1, 1]) };
    let first = |stated| Stored::candidates(&display, stated, tone)[0].to_string();
    let words = "rounded to 8 bits, colours above 1 divided by their largest channel";
    equal("the likeliest", first(None), format!("gamma 2.2, {words}"));
    equal("the stated one", first(Some(Transfer::Srgb)), format!("sRGB, {words}"));
    let all = Stored::candidates(&display, Some(Transfer::Linear), tone);
    // five quantisers, and clamped, divided or red
    equal("ways of a stated curve", all.len(), 5 * 3);
    equal("ways of an unknown curve", Stored::candidates(&display, None, tone).len(), 5 * 3 * 6);
}
