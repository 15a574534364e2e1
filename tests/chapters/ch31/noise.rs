//! One octave: lattice values, continuity, period, overshoot, tables.

use std::collections::BTreeSet;

use groundtruth::noise::Lattice;
use testkit::properties::*;

use super::oracle::{self, built, index, linear};
use crate::prelude::*;
use crate::support::statistics::moments;

/// Sums of 64 products, whose weights add up to at most 2, with about ten roundings each.
const ROUNDING: f64 = 2e-14;

/// A point with integer coordinates.
fn at_whole([i, j, k]: [i64; 3]) -> Point {
    Point::new(i as f64, j as f64, k as f64)
}

proptest! {
    #![proptest_config(laws())]

    /// Law: at points with integer coordinates, also negative ones, noise of both kinds is the entry of the
    /// table at `PERM(ix + PERM(iy + PERM(iz)))`, to the last bit. Oracle: the index in signed numbers.
    /// Book: lattice noise and its tables.
    #[test]
    fn noise_at_lattice_points_is_in_the_tables(
        knot in prop::array::uniform3(-3000..3000_i64),
        seed in 0..9_u64,
    ) {
        for noise in [Noise { seed, ..Noise::default() }, Noise { seed, ..linear(1) }] {
            let noise = built(noise);
            let (lattice, p) = (noise.lattice(), at_whole(knot));
            let entry = index(lattice, knot);
            prop_assert_eq!(noise.value(p), lattice.values()[entry]);
            prop_assert_eq!(noise.vector(p), lattice.vectors()[entry]);
        }
    }

    /// Law: between lattice points noise is the sum of its knots with linear (tent) or Catmull–Rom weights,
    /// clamped to −1 … 1. Oracle: all products of weights in Hermite's form, one by one.
    /// Book: linear and cubic interpolation.
    #[test]
    fn noise_is_the_weighted_sum_of_its_knots(p in point(700.0), noise in oracle::noises()) {
        let it = built(noise);
        let found = it.value(p);
        let expected = oracle::value(&noise, it.lattice(), p);
        prop_assert!(
            (found - expected).abs() < ROUNDING,
            "{} at {:?}, expected {}",
            found,
            p,
            expected
        );
        let (found, expected) = (it.vector(p), oracle::vector(&noise, it.lattice(), p));
        prop_assert!(
            (found - expected).length() < ROUNDING,
            "{:?}, expected {:?}",
            found,
            expected
        );
    }

    /// Law: noise has the period 256 along each axis, bit for bit where the sum is exact, up to 2⁴¹ periods
    /// away on either side. Oracle: the noise at the first point.
    /// Book: lattice noise and its tables.
    #[test]
    fn noise_repeats_after_256_cells(
        eighths in prop::array::uniform3(-4096..4096_i32),
        axis in 0..3_usize,
        exponent in 0..42_i32,
        back in any::<bool>(),
    ) {
        let here = Point::from(eighths.map(|e| f64::from(e) / 8.0));
        let periods = if back { -1.0 } else { 1.0 } * 256.0 * power_of_two(exponent);
        let there = here.with(axis, here.along(axis) + periods);
        prop_assume!(there.along(axis) - periods == here.along(axis));
        for noise in [Noise::default(), linear(1)].map(built) {
            prop_assert_eq!(noise.value(here), noise.value(there), "{:?} and {:?}", here, there);
            prop_assert_eq!(noise.vector(here), noise.vector(there));
        }
    }

    /// Law: cubic noise has the same slope on both sides of a plane of its lattice; linear noise is
    /// continuous there, and its slope jumps by `k₋₁ − 2k₀ + k₁` of the knots, if the other coordinates
    /// are whole. Oracle: difference quotients of both sides; the second difference of the table.
    /// Book: linear and cubic interpolation.
    #[test]
    fn cubic_noise_is_smooth_and_linear_noise_is_continuous(
        p in point(100.0),
        knot in prop::array::uniform3(-300..300_i64),
        axis in 0..3_usize,
    ) {
        /// A power of two: the points are exact.
        const H: f64 = 1.0 / 16_777_216.0;
        /// The second derivative of a cubic piece is at most 12 times its largest knot, and the weights
        /// of the other axes add up to 1.25² at most: 19 h. The quotients are rounded by some 1e-15/h.
        const JUMP: f64 = 19.0 * H + ROUNDED;
        const ROUNDED: f64 = 1e-7;
        let slopes = |noise: &groundtruth::noise::LatticeNoise, p: Point| {
            let f = |by: f64| noise.value(p.with(axis, p.along(axis) + by));
            [(f(0.0) - f(-H)) / H, (f(H) - f(0.0)) / H]
        };
        let on_plane = p.with(axis, oracle::whole(p.along(axis)) as f64);
        let cubic = built(Noise::default());
        let [before, after] = slopes(&cubic, on_plane);
        if cubic.value(on_plane).abs() < 0.999 {
            prop_assert!((after - before).abs() < JUMP, "slopes {} and {}", before, after);
        }
        let linear = built(linear(1));
        let [before, after] = slopes(&linear, on_plane);
        // no slope exceeds the difference of two knots: there is no step
        prop_assert!(before.abs() <= 2.0 && after.abs() <= 2.0, "slopes {} and {}", before, after);
        let [before, after] = slopes(&linear, at_whole(knot));
        let k = [-1, 0, 1].map(|by| {
            let mut at = knot;
            at[axis] += by;
            linear.lattice().values()[index(linear.lattice(), at)]
        });
        let expected = k[0] - 2.0 * k[1] + k[2];
        let found = after - before;
        prop_assert!((found - expected).abs() < ROUNDED, "jump {}, expected {}", found, expected);
    }
}

/// Law: cubic noise overshoots its knots at some points, and is clamped there; linear noise never overshoots.
/// Oracle: the sum of weighted knots before the clamp, at random points.
/// Book: linear and cubic interpolation.
#[test]
fn cubic_noise_overshoots_and_is_clamped() {
    let noise = Noise::default();
    let it = built(noise);
    let mut random = Pcg32::new(31, 1);
    let (mut above, mut below) = (0, 0);
    for _ in 0..60_000 {
        let p = Point::from([(); 3].map(|()| 200.0 * random.uniform() - 100.0));
        let free = oracle::unclamped(&noise, it.lattice(), p);
        if free.abs() > 1.0 + ROUNDING {
            assert_eq!(it.value(p), free.signum(), "{free} at {p:?}");
            *(if free > 0.0 { &mut above } else { &mut below }) += 1;
        }
        near!(it.value(p), 0.0, 1.0);
        near!(free, 0.0, 1.953_125);
        let between = oracle::unclamped(&linear(1), it.lattice(), p);
        assert!(between.abs() <= 1.0, "linear noise is {between}");
    }
    assert!(above > 10 && below > 10, "overshot {above} times above and {below} below");
}

/// Law: coordinates that are too large for fractions are lattice points; those from 2⁶⁰ on are multiples of
/// the period, and infinite ones do not give NaN.
#[test]
fn huge_coordinates_have_noise_too() {
    for noise in [Noise::default(), linear(1)].map(built) {
        let at = |x: f64| noise.value(Point::new(x, 0.0, 0.0));
        let entry = |i: i64| noise.lattice().values()[index(noise.lattice(), [i, 0, 0])];
        let odd = (1_i64 << 53) - 1;
        assert_eq!(at(odd as f64), entry(odd));
        assert_eq!(at(-(odd as f64)), entry(-odd));
        let large = (1_i64 << 59) + 128;
        assert_eq!(at(large as f64), entry(large));
        for x in [1e19, -1e19, 1e300, f64::INFINITY, f64::NEG_INFINITY] {
            assert_eq!(at(x), entry(0), "{x}");
        }
    }
}

/// Law: the same seed gives the same tables, and another seed gives others; the permutation is the same
/// for all seeds, and is one of 0 … 255; the default seed is the book's, 253.
/// Book: lattice noise and its tables.
#[test]
fn tables_are_made_of_their_seed() {
    let (one, again, other) = (Lattice::new(253), Lattice::new(253), Lattice::new(254));
    assert_eq!(one.values(), again.values());
    assert_eq!(one.vectors(), again.vectors());
    assert_eq!(built(Noise::default()).lattice().values(), one.values());
    let alike = one.values().iter().filter(|value| other.values().contains(value)).count();
    assert_eq!(alike, 0, "seeds share {alike} of 256 numbers");
    let alike = one.vectors().iter().filter(|vector| other.vectors().contains(vector)).count();
    assert_eq!(alike, 0, "seeds share {alike} of 256 vectors");
    assert_eq!(one.permutation(), other.permutation());
    let entries: BTreeSet<u8> = one.permutation().iter().copied().collect();
    assert_eq!(entries.len(), 256);
    let fixed = (0..=255).filter(|&i| one.permutation()[usize::from(i)] == i).count();
    assert!(fixed < 10, "{fixed} of 256 entries stay; 1 is expected");
}

/// Law: the tables are made as `docs/probe.md` says, so that others can make them too. Oracle: the method
/// described there.
#[test]
fn tables_are_made_as_the_probes_page_says() {
    let lattice = Lattice::new(253);
    let mut random = Pcg32::new(253, 0);
    lattice.values().iter().for_each(|&value| assert_eq!(value, 1.0 - 2.0 * random.uniform()));
    let mut permutation: Vec<u8> = (0..=255).collect();
    let mut random = Pcg32::new(31, 0);
    for last in (1..256).rev() {
        permutation.swap(last, random.below(last as u32 + 1) as usize);
    }
    assert_eq!(permutation, lattice.permutation());
}

/// Law: the vectors of the table are unit and evenly spread: of the 16 bands of equal height and the 16
/// sectors of equal angle each has 16, as multi-jittered samples do, and their sum is nearly zero.
/// Book: lattice noise and its tables.
#[test]
fn vectors_are_spread_over_the_sphere() {
    for seed in [253, 0, 7] {
        let lattice = Lattice::new(seed);
        let mut bands = [0; 16];
        let mut sectors = [0; 16];
        let mut sum = Vector::ZERO;
        for v in lattice.vectors() {
            assert!((v.length() - 1.0).abs() < 1e-15, "length {}", v.length());
            bands[(8.0 * (1.0 - v.z())) as usize] += 1;
            let turn = groundtruth::math::atan2(v.y(), v.x()) / std::f64::consts::TAU;
            sectors[(16.0 * turn.rem_euclid(1.0)) as usize] += 1;
            sum += *v;
        }
        assert_eq!(bands, [16; 16], "seed {seed}");
        assert_eq!(sectors, [16; 16], "seed {seed}");
        assert!(sum.length() / 256.0 < 0.1, "the mean is {:?}", sum / 256.0);
    }
}

/// Law: along any axis a row of 256 lattice points has each entry of the table once. Therefore mean and
/// variance there are those of the table, about 0 and 1/3. Oracle: the sorted table; the variance of a
/// uniform number, within five standard deviations of 256: √(1/3/256) and √((1/5 − 1/9)/256).
/// Book: lattice noise and its tables.
#[test]
fn a_row_of_lattice_points_has_each_entry_once() {
    let noise = built(Noise::default());
    let mut table = noise.lattice().values().to_vec();
    table.sort_by(f64::total_cmp);
    for axis in 0..3 {
        for start in [[0, 0, 0], [5, -200, 31], [-77, 13, 1000]] {
            let corner = Point::from(start.map(f64::from));
            let at = |i: i32| corner.with(axis, corner.along(axis) + f64::from(i));
            let mut row: Vec<f64> = (0..256).map(|i| noise.value(at(i))).collect();
            row.sort_by(f64::total_cmp);
            assert_eq!(row, table, "along axis {axis} from {start:?}");
        }
    }
    let (mean, variance) = moments(&table);
    assert!(mean.abs() < 0.18, "the mean is {mean}, expected 0");
    assert!((variance - 1.0 / 3.0).abs() < 0.094, "the variance is {variance}, expected 1/3");
}

/// Law: in the middle of its cells linear noise has the mean of the table, about 0, and an eighth of its variance, about
/// 1/24. Oracle: the mean of eight independent entries; some cells have an entry twice, so that a quarter of the variance
/// is allowed.
/// Book: linear and cubic interpolation.
#[test]
fn in_the_middle_of_cells_linear_noise_has_an_eighth_of_the_variance() {
    let noise = built(linear(1));
    let (table_mean, table_variance) = moments(noise.lattice().values());
    let middle = |i: u32| {
        let at = [i % 64, i / 64 % 64, i / 4096].map(|c| f64::from(c) + 0.5);
        noise.value(Point::from(at))
    };
    let (mean, variance) = moments(&(0..64 * 64 * 64).map(middle).collect::<Vec<_>>());
    near!(mean, table_mean, 0.01);
    near!(8.0 * variance / table_variance, 1.0, 0.25);
}
