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
