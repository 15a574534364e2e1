//! Stripes and ramps.

use groundtruth::textures::{Ramp, Stripes, Wrap};

use super::*;
use crate::prelude::*;

const AXES: [Axis; 3] = [Axis::X, Axis::Y, Axis::Z];

fn stripes(axis: usize, size: f64) -> Texture {
    Stripes { axis: AXES[axis], size, color1: ONE.into(), color2: TWO.into() }.into()
}

fn ramp(axis: usize, [from, to]: [f64; 2], colors: &[Rgb], wrap: Wrap) -> Texture {
    let colors = colors.iter().map(|&color| color.into()).collect();
    Ramp { axis: AXES[axis], from, to, colors, wrap }.into()
}

/// Maps a coordinate to 0 … 1 as `wrap` says, one period at a time.
fn brought_back(mut x: f64, wrap: Wrap) -> f64 {
    match wrap {
        Wrap::Clamp => x.clamp(0.0, 1.0),
        Wrap::Repeat => {
            while x < 0.0 {
                x += 1.0;
            }
            while x > 1.0 {
                x -= 1.0;
            }
            x
        }
        Wrap::Mirror => {
            while !(0.0..=1.0).contains(&x) {
                x = if x < 0.0 { -x } else { 2.0 - x };
            }
            x
        }
    }
}

/// A few roundings of a colour of at most 1, times up to twelve intervals.
const ROUNDING: f64 = 1e-12;

fn wraps() -> impl Strategy<Value = Wrap> {
    prop_oneof![Just(Wrap::Clamp), Just(Wrap::Repeat), Just(Wrap::Mirror)]
}

fn colors() -> impl Strategy<Value = Vec<Rgb>> {
    prop::collection::vec(color(), 2..6)
}

proptest! {
    #![proptest_config(laws())]

    /// Law: stripes show the parity of the layer along their axis; other coordinates do not matter.
    /// Oracle: borders counted one by one outward, so negative layers are like the others.
    #[test]
    fn stripes_show_the_parity_of_their_layer(
        p in point(10.0),
        elsewhere in point(1e6),
        size in 0.1..3.0_f64,
        axis in 0..3_usize,
    ) {
        let x = p.along(axis);
        prop_assume!((OFFSET..1.0 - OFFSET).contains(&(x / size).rem_euclid(1.0)));
        let expected = if even(&[x], size) { ONE } else { TWO };
        let texture = stripes(axis, size);
        prop_assert_eq!(at(&texture, p), expected);
        prop_assert_eq!(at(&texture, elsewhere.with(axis, x)), expected);
        prop_assert_eq!(at(&texture, p.with(axis, x + size)), other(expected));
        prop_assert_eq!(at(&texture, p.with(axis, x - 2.0 * size)), expected);
    }

    /// Law: between its ends a ramp is `Σ cᵢ max(0, 1 − |s − i|)`, where s runs from 0 at the first colour to
    /// n − 1 at the last; beyond its ends it continues as `wrap` says. Oracle: that sum of hat functions;
    /// periods removed one by one.
    #[test]
    fn a_ramp_is_a_sum_of_hats(
        (p, axis) in (point(4.0), 0..3_usize),
        (from, length) in (-2.0..2.0_f64, prop_oneof![0.3..3.0_f64, -3.0..-0.3_f64]),
        (colors, wrap) in (colors(), wraps()),
    ) {
        let to = from + length;
        let share = (p.along(axis) - from) / (to - from);
        // where a repeated ramp jumps, either side is right
        prop_assume!(wrap != Wrap::Repeat || (share - share.round()).abs() > ROUNDING);
        let s = brought_back(share, wrap) * (colors.len() - 1) as f64;
        let hat = |i: usize| (1.0 - (s - i as f64).abs()).max(0.0);
        let expected: Rgb = colors.iter().enumerate().map(|(i, &color)| hat(i) * color).sum();
        let found = at(&ramp(axis, [from, to], &colors, wrap), p);
        for (found, expected) in found.to_array().into_iter().zip(expected.to_array()) {
            prop_assert!(
                (found - expected).abs() <= 100.0 * ROUNDING,
                "{found}, expected {expected}, at {share} of the ramp, {wrap:?}"
            );
        }
    }

    /// Law: at a stop a ramp has the stop's colour, and between equal colours that colour, bit for bit.
    /// Oracle: the colours.
    #[test]
    fn a_ramp_has_the_colours_of_its_stops(
        (p, axis, wrap) in (point(10.0), 0..3_usize, wraps()),
        (from, exponent) in (-8..8_i32, -3..3_i32),
        colors in colors(),
    ) {
        // stops that are exact numbers
        let step = power_of_two(exponent);
        let last = colors.len() - 1;
        let (from, to) = (f64::from(from), f64::from(from) + last as f64 * step);
        let texture = ramp(axis, [from, to], &colors, wrap);
        for (i, &color) in colors.iter().enumerate() {
            // thirds and fifths of a length are not exact
            let stop = p.with(axis, from + i as f64 * step);
            if last.is_power_of_two() {
                prop_assert_eq!(at(&texture, stop), color, "stop {} of {}", i, last);
            }
            let plain = ramp(axis, [from, to], &vec![color; colors.len()], wrap);
            prop_assert_eq!(at(&plain, p), color);
        }
    }

    /// Law: a ramp never leaves the range of its colours. Oracle: the least and greatest value of each
    /// channel, plus one rounding.
    #[test]
    fn a_ramp_stays_between_its_colours(
        (p, wrap) in (point(10.0), wraps()),
        colors in colors(),
    ) {
        let found = at(&ramp(0, [-0.7, 1.9], &colors, wrap), p).to_array();
        for (c, found) in found.into_iter().enumerate() {
            let channel = || colors.iter().map(|color| color.to_array()[c]);
            let least = channel().fold(f64::INFINITY, f64::min);
            let most = channel().fold(0.0, f64::max);
            let room = 2.0 * U * most;
            prop_assert!(
                (least - room..=most + room).contains(&found),
                "{found} of {least} to {most}"
            );
        }
    }
}

/// Law: along their axis stripes change at the multiples of their size, on both sides of the origin: no
/// run is doubled there. Oracle: the changes, found by scanning.
#[test]
fn runs_of_stripes_are_one_size_long_on_both_sides_of_the_origin() {
    for axis in 0..3 {
        let texture = stripes(axis, 0.75);
        let line = |i: i32| Point::new(0.3, 0.3, 0.3).with(axis, f64::from(i) / 256.0);
        let changes: Vec<i32> =
            (-2560..2560).filter(|&i| at(&texture, line(i)) != at(&texture, line(i + 1))).collect();
        // 27 multiples of 0.75 lie between −10 and 10, 0 among them
        assert_eq!(changes.len(), 27, "{changes:?}");
        assert!(changes.windows(2).all(|pair| pair[1] - pair[0] == 192), "{changes:?}");
        assert!(changes.contains(&0), "the first stripe begins a sliver beyond 0: {changes:?}");
    }
}

/// Law: a face on a border of stripes has no speckle: at y = 3 the texture has one colour, however the last
/// bits of y are rounded. Oracle: the layer beneath.
#[test]
fn a_face_on_a_border_of_stripes_has_one_colour() {
    let texture = stripes(1, 1.0);
    for bits in -100_i64..100 {
        let y = f64::from_bits((3.0_f64.to_bits() as i64 + bits) as u64);
        assert_eq!(
            at(&texture, Point::new(0.2, y, 0.4)),
            ONE,
            "y = {y:e} is in the layer from 2 to 3"
        );
    }
}
