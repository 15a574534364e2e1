//! Wood, step by step.

use groundtruth::noise::LatticeNoise;
use groundtruth::textures::Wood;
use testkit::properties::*;

use super::oracle::{self, built};
use super::textures::at;
use crate::prelude::*;

/// The rings amplify the rounding of noise at frequency 50 to about 1e-9 at most.
const ROUNDING: f64 = 1e-8;

/// The book's smooth step, branch by branch.
fn step(a: f64, b: f64, x: f64) -> f64 {
    if x < a {
        return 0.0;
    }
    if x >= b {
        return 1.0;
    }
    let y = (x - a) / (b - a);
    3.0 * y * y - 2.0 * y * y * y
}

/// How dark wood is at a point, by the book's steps one after the other.
fn darkness(wood: &Wood, noise: &LatticeNoise, p: Point) -> f64 {
    let lattice = noise.lattice();
    let value = |x: f64, y: f64, z: f64| oracle::value(&wood.noise, lattice, Point::new(x, y, z));
    let f = wood.ring_noise_frequency;
    let there = Point::new(f * p.x(), f * p.y(), f * p.z());
    let q = p + wood.ring_noise * oracle::vector_fbm(&wood.noise, lattice, there);
    let at = Point::new(0.0, 0.0, q.y() * wood.trunk_wobble_frequency);
    let w: Vector = oracle::vector(&wood.noise, lattice, at);
    let (x, y, z) = (q.x() + wood.trunk_wobble * w.x(), q.y(), q.z() + wood.trunk_wobble * w.z());
    let mut r = wood.ring_frequency * (x * x + z * z).sqrt();
    let f = wood.angular_wobble_frequency;
    r += wood.angular_wobble * step(0.0, 5.0, r) * value(f * x, f * 0.1 * y, f * z);
    r += wood.ring_unevenness * value(r, r, r);
    let m = r - oracle::whole(r) as f64;
    let mut in_ring = step(0.1, 0.55, m) - step(0.7, 0.95, m);
    let mut grain = 0.0_f64;
    let f = wood.grain_frequency;
    let (mut g0, mut amplitude, mut dp) = ([f * x, 0.05 * f * y, f * z], 1.0, 0.2);
    for pass in 0..2 {
        let valid = 1.0 - step(0.2, 0.6, dp);
        let mut g = valid * value(g0[0], g0[1], g0[2]) * (0.3 + 0.7 * in_ring);
        g = (0.8 - g).clamp(0.0, 1.0);
        g = wood.grainy * step(0.5, 1.0, g * g);
        if pass == 0 {
            in_ring *= 1.0 - 0.4 * valid;
        }
        grain = amplitude * grain.max(g);
        (g0, amplitude, dp) = (g0.map(|c| 2.0 * c), 0.5 * amplitude, 2.0 * dp);
    }
    wood.ringy * in_ring * (1.0 - grain) + grain
}

proptest! {
    #![proptest_config(laws())]

    /// Law: the darkness of wood follows the book's steps, for any parameters, and its colour lies between
    /// its two colours. Oracle: those steps in order, with noise by the second implementation.
    /// Book: wood.
    #[test]
    fn wood_grows_as_the_book_says(
        p in point(4.0),
        size in 0.3..3.0_f64,
        rings in (0.5..6.0_f64, 0.0..0.6_f64, 0.0..0.1_f64, 0.2..3.0_f64),
        wobbles in (0.0..0.5_f64, 0.0..0.2_f64, 0.0..1.0_f64, 0.1..2.0_f64),
        grain in (1.0..30.0_f64, 0.0..1.0_f64, 0.0..1.0_f64),
    ) {
        let wood = Wood {
            size,
            light: Rgb::WHITE.into(),
            dark: Rgb::new(0.0, 0.5, 1.0).into(),
            ring_frequency: rings.0,
            ring_unevenness: rings.1,
            ring_noise: rings.2,
            ring_noise_frequency: rings.3,
            trunk_wobble: wobbles.0,
            trunk_wobble_frequency: wobbles.1,
            angular_wobble: wobbles.2,
            angular_wobble_frequency: wobbles.3,
            grain_frequency: grain.0,
            grainy: grain.1,
            ringy: grain.2,
            ..Wood::default()
        };
        let there = Point::from(p.to_array().map(|c| c / size));
        let dark = darkness(&wood, &built(wood.noise), there);
        let found = at(wood, p);
        for (name, found, expected) in [
            ("red", found.r, 1.0 - dark),
            ("green", found.g, 1.0 - 0.5 * dark),
            ("blue", found.b, 1.0),
        ] {
            let off = (found - expected).abs();
            prop_assert!(off < ROUNDING, "{} is {}, expected {}", name, found, expected);
        }
        at_least!(found.r, 0.0);
        at_most!(found.r, 1.0 + ROUNDING);
    }
}

/// Law: the defaults of wood are the book's: 2 octaves of lacunarity 4; 4 rings per unit, their
/// unevenness 0.25 and their noise 0.02; wobbles of 0.15 of the trunk and 0.5 around it; grain of
/// frequency 25, grainy and ringy 0.5.
/// Book: wood.
#[test]
fn the_defaults_are_the_books() {
    let wood = Wood::default();
    assert_eq!(wood.noise, Noise { octaves: 2, lacunarity: 4.0, ..Noise::default() });
    let rings =
        [wood.ring_frequency, wood.ring_unevenness, wood.ring_noise, wood.ring_noise_frequency];
    assert_eq!(rings, [4.0, 0.25, 0.02, 1.0]);
    let wobbles = [
        wood.trunk_wobble,
        wood.trunk_wobble_frequency,
        wood.angular_wobble,
        wood.angular_wobble_frequency,
    ];
    assert_eq!(wobbles, [0.15, 0.025, 0.5, 1.0]);
    assert_eq!([wood.grain_frequency, wood.grainy, wood.ringy], [25.0, 0.5, 0.5]);
}
