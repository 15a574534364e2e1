//! The noise-based textures, each against its formula.

use std::f64::consts::FRAC_PI_2;

use groundtruth::kinds::Resources;
use groundtruth::noise::LatticeNoise;
use groundtruth::textures::{
    ColorTable, Fbm, Kind, RampFbm, Rule, Stripes, TextureInstance, ThreeColors, Turbulence,
    TwoColors, WrappedFbm, WrappedRamp,
};
use testkit::properties::*;

use super::oracle::{self, built};
use crate::prelude::*;

const ONE: Rgb = Rgb::new(1.0, 0.75, 0.5);
const TWO: Rgb = Rgb::new(0.0, 0.25, 0.5);
const THREE: Rgb = Rgb::new(0.5, 1.0, 0.125);
const RED: Rgb = Rgb::new(1.0, 0.0, 0.0);

/// The tolerance for sums of octaves, times an expansion of up to 10.
const ROUNDING: f64 = 1e-8;

/// The colour at a local point; the position in the world must not matter.
pub fn at(texture: impl Into<Kind>, local: Point) -> Rgb {
    let surface = Surface { local, ..Surface::new(Point::new(7.7, 8.8, 9.9), 0.0, Normal::Y) };
    let texture = texture.into().build(&mut Resources::default()).expect("the texture is valid");
    texture.color(&TexturePoint::new(&surface))
}

fn apart(a: Rgb, b: Rgb) -> f64 {
    let [a, b] = [a, b].map(Rgb::to_array);
    (0..3).map(|i| (a[i] - b[i]).abs()).fold(0.0, f64::max)
}

/// fBm by the second implementation, at a point in units of the size.
fn fbm(noise: &LatticeNoise, data: &Noise, p: Point, size: f64) -> f64 {
    oracle::fbm(data, noise.lattice(), Point::from(p.to_array().map(|c| c / size)))
}

/// Whether rounding may move a number across one of the borders.
fn is_beside(x: f64, borders: impl IntoIterator<Item = f64>) -> bool {
    borders.into_iter().any(|border| (x - border).abs() < ROUNDING)
}

proptest! {
    #![proptest_config(laws())]

    /// Law: as a number, which may be above 1, fBm is `min + (max − min) noise` and never the warning red,
    /// also inside an instance or inside another texture. Oracle: the second implementation.
    #[test]
    fn as_a_number_noise_is_not_red(p in point(5.0), size in 0.3..3.0_f64) {
        let data = Noise::of_octaves(3);
        let plain = Fbm { min: 20.0, max: 2000.0, ..Fbm::new(data, size) };
        let number = |texture: Kind| {
            let surface = Surface::new(p, 0.0, Normal::Y);
            let texture = texture.build(&mut Resources::default()).expect("the texture is valid");
            texture.number(&TexturePoint::new(&surface))
        };
        let expected = 20.0 + 1980.0 * fbm(&built(data), &data, p, size);
        let (axis, color1) = (groundtruth::math::Axis::X, plain.clone().into());
        let chosen = Stripes { axis, size: 1.0, color2: plain.clone().into(), color1 };
        for texture in
            [plain.clone().into(), TextureInstance::new(plain, vec![]).into(), chosen.into()]
        {
            let found = number(texture);
            prop_assert!(
                (found - expected).abs() < 2000.0 * ROUNDING,
                "{found}, expected {expected}"
            );
        }
    }

    /// Law: fBm and turbulence textures are `min + (max − min) noise` times the colour, in local
    /// coordinates divided by the size; fBm is red where that is not from 0 to 1. Oracle: the second
    /// implementation.
    /// Book: fBm textures and wrapped noise.
    #[test]
    fn noise_is_brightness(
        p in point(5.0),
        noise in oracle::noises(),
        size in 0.3..3.0_f64,
        range in (-0.5..0.5_f64, 0.5..1.5_f64),
    ) {
        let (min, max) = range;
        let it = built(noise);
        let brightness = min + (max - min) * fbm(&it, &noise, p, size);
        prop_assume!(!is_beside(brightness, [0.0, 1.0]));
        let expected = if (0.0..=1.0).contains(&brightness) { brightness * ONE } else { RED };
        let found = at(Fbm { min, max, color: ONE.into(), ..Fbm::new(noise, size) }, p);
        prop_assert!(apart(found, expected) < ROUNDING, "{:?}, expected {:?}", found, expected);

        let there = Point::from(p.to_array().map(|c| c / size));
        let sum = oracle::sum(&noise, (0.5, 2.0), it.lattice(), there, f64::abs);
        let turbulence = sum / oracle::bound(0.5, noise.octaves);
        let min = min.abs();
        let expected = (min + (max - min) * turbulence) * ONE;
        let texture = Turbulence { min, max, color: ONE.into(), ..Turbulence::new(noise, size) };
        let found = at(texture, p);
        prop_assert!(apart(found, expected) < ROUNDING, "{:?}, expected {:?}", found, expected);
    }

    /// Law: wrapped noise is the fractional part of the expanded noise, in `[0, 1)`, mapped to min … max, in
    /// the colour of the first threshold above the noise. The second colour may be another texture. With
    /// expansion 1 it is fBm. Oracle: the second implementation; 1 is subtracted until the number is below 1.
    /// Book: fBm textures and wrapped noise.
    #[test]
    fn wrapped_noise_starts_again_at_whole_numbers(
        p in point(5.0),
        noise in oracle::noises(),
        size in 0.3..3.0_f64,
        expansion in 1.0..10.0_f64,
        range in (0.0..0.4_f64, 0.6..1.0_f64),
    ) {
        let (min, max) = range;
        let whole_fbm = fbm(&built(noise), &noise, p, size);
        let expanded = expansion * whole_fbm;
        prop_assume!(!is_beside(expanded, (0..11).map(f64::from).chain([1.35])));
        // where noise is clamped fBm may be exactly 1, which wraps to 0
        prop_assume!(!is_beside(whole_fbm, [1.0]));
        let mut wrapped = expanded;
        while wrapped >= 1.0 {
            wrapped -= 1.0;
        }
        let value = min + (max - min) * wrapped;
        let one =
            WrappedFbm { min, max, color: ONE.into(), ..WrappedFbm::new(noise, size, expansion) };
        let [a, b, c] = [ONE, TWO, THREE].map(groundtruth::textures::Paint::from);
        let colors = [a.clone(), b.clone()];
        let two = TwoColors { min, max, ..TwoColors::new(noise, size, expansion, colors) };
        let inner = Fbm { color: TWO.into(), ..Fbm::new(noise, size) };
        let nested = TwoColors { color2: inner.into(), ..two.clone() };
        let three = ThreeColors { min, max, ..ThreeColors::new(noise, size, expansion, [a, b, c]) };
        let second = if expanded < 1.0 { ONE } else { TWO };
        let of_three = if expanded < 1.35 {
            ONE
        } else if expanded < 2.0 {
            TWO
        } else {
            THREE
        };
        let inner = if expanded < 1.0 { ONE } else { whole_fbm * TWO };
        for (texture, expected) in [
            (Kind::from(one), value * ONE),
            (two.into(), value * second),
            (nested.into(), value * inner),
            (three.into(), value * of_three),
            (
                WrappedFbm { color: ONE.into(), ..WrappedFbm::new(noise, size, 1.0) }.into(),
                whole_fbm * ONE,
            ),
        ] {
            let found = at(texture, p);
            prop_assert!(apart(found, expected) < ROUNDING, "{:?}, expected {:?}", found, expected);
        }
    }

    /// Law: marble is the ramp at `(1 + sin(y + a fBm))/2`, and a wrapped ramp is the ramp at the fractional
    /// part of the noise, by both rules for columns: `⌊n u⌋` and the book's `trunc(u (n − 1))`. Oracle: the
    /// second implementation; the number of column edges up to that value.
    /// Book: ramps: marble and sandstone.
    #[test]
    fn ramps_are_asked_as_images_of_one_row(
        p in point(5.0),
        noise in oracle::noises(),
        size in 0.3..3.0_f64,
        perturbation in 0.0..40.0_f64,
        count in 1..9_u32,
        is_book in any::<bool>(),
    ) {
        let colors: Vec<Rgb> = (0..count).map(|i| Rgb::new(f64::from(i), 0.5, 1.0)).collect();
        let rule = if is_book { Rule::Book } else { Rule::Even };
        let ramp = ColorTable { colors, columns: None, rule };
        let fbm = fbm(&built(noise), &noise, p, size);
        let u = (1.0 + sin(p.y() / size + perturbation * fbm)) / 2.0;
        let expanded = 8.0 * fbm;
        let wrapped = expanded - oracle::whole(expanded) as f64;
        prop_assume!(!is_beside(expanded, (0..9).map(f64::from)));
        let marble = RampFbm { ramp: ramp.clone(), noise, size, perturbation };
        let agate = WrappedRamp { ramp, noise, size, expansion: 8.0 };
        for (texture, u) in [(Kind::from(marble), u), (agate.into(), wrapped)] {
            let covered = f64::from(if is_book { count - 1 } else { count });
            let edges: Vec<f64> = (1..count).map(|i| f64::from(i) / covered).collect();
            // 40 times the rounding of fBm
            if edges.iter().any(|edge| (u - edge).abs() < 40.0 * ROUNDING) {
                continue;
            }
            let column = edges.iter().filter(|edge| u >= **edge).count();
            prop_assert_eq!(at(texture, p), Rgb::new(column as f64, 0.5, 1.0), "u = {}", u);
        }
    }
}

fn layers(rule: Rule) -> RampFbm {
    let colors = (0..=9).map(|i| Rgb::grey(f64::from(i) / 10.0)).collect();
    let ramp = ColorTable { colors, columns: None, rule };
    RampFbm { ramp, noise: Noise::of_octaves(4), size: 1.0, perturbation: 0.0 }
}

/// Law: unperturbed marble depends on y alone, has the period 2π times the size, and the same colour at y and
/// π − y. It has the first column where the sine is −1 (never column −1), the last where it is 1, by both
/// rules.
/// Book: fig. 31.32, marble without perturbation.
#[test]
fn unperturbed_marble_has_layers() {
    for (rule, size) in [(Rule::Even, 1.0), (Rule::Book, 0.3)] {
        let marble = RampFbm { size, ..layers(rule) };
        let seen = |x: f64, y: f64, z: f64| at(marble.clone(), Point::new(x, size * y, z));
        let mut colors = std::collections::BTreeSet::new();
        for i in 0..200 {
            // beside all edges of columns
            let y = 0.0317 * f64::from(i) - 3.0;
            let here = seen(0.0, y, 0.0);
            colors.insert((10.0 * here.r) as u32);
            for other in [seen(17.3, y, -8.1), seen(0.0, y + TAU, 0.0), seen(0.0, PI - y, 0.0)] {
                assert_eq!(here, other, "at y = {y}");
            }
        }
        assert!(colors.len() >= 9, "only {colors:?} were seen");
        assert_eq!(seen(0.0, -FRAC_PI_2, 0.0), Rgb::BLACK);
        assert_eq!(seen(0.0, FRAC_PI_2, 0.0), Rgb::grey(0.9));
    }
}

/// Law: in a ramp with columns, the first and last column are the first and last colour, and those between
/// are mixed in equal steps. Oracle: the straight line between two colours.
#[test]
fn ramps_are_mixed_in_even_steps() {
    let ramp =
        ColorTable { columns: Some(5), ..ColorTable::interpolated([Rgb::BLACK, Rgb::WHITE]) };
    let marble = RampFbm { ramp, ..layers(Rule::Even) };
    for column in 0..5 {
        // the middle of the column
        let u = (f64::from(column) + 0.5) / 5.0;
        let y = groundtruth::math::atan2(2.0 * u - 1.0, (4.0 * u * (1.0 - u)).sqrt());
        let found = at(marble.clone(), Point::new(1.0, y, 2.0));
        assert_eq!(found, Rgb::grey(f64::from(column) / 4.0), "column {column}");
    }
}
