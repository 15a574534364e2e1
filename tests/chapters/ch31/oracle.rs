//! A second implementation of noise, straight from its definition: all knots, each with its weight.

use groundtruth::noise::{Interpolation, Lattice, LatticeNoise};
use testkit::properties::*;

use crate::prelude::*;

/// The noise with these parameters.
pub fn built(noise: Noise) -> LatticeNoise {
    noise.build().expect("the noise is valid")
}

pub fn linear(octaves: u32) -> Noise {
    Noise { interpolation: Interpolation::Linear, ..Noise::of_octaves(octaves) }
}

/// The largest integer not above a number, by truncation.
pub fn whole(x: f64) -> i64 {
    let towards_zero = x as i64;
    towards_zero - i64::from((towards_zero as f64) > x)
}

/// The book's `INDEX`, for integers of any sign.
pub fn index(lattice: &Lattice, [i, j, k]: [i64; 3]) -> usize {
    let perm = |i: i64| i64::from(lattice.permutation()[i.rem_euclid(256) as usize]);
    perm(i + perm(j + perm(k))) as usize
}

/// The weights of the knots at −1, 0, 1, 2 at `x` from 0 to 1.
fn weights(interpolation: Interpolation, x: f64) -> [f64; 4] {
    match interpolation {
        Interpolation::Linear => [0.0, 1.0 - x, x, 0.0],
        Interpolation::Cubic => {
            // Hermite's basis, with the slopes (k₂ − k₀)/2 and (k₃ − k₁)/2 at the ends
            let y = 1.0 - x;
            let (start, end) = ((1.0 + 2.0 * x) * y * y, (1.0 + 2.0 * y) * x * x);
            let (rise, fall) = (x * y * y, -y * x * x);
            [-rise / 2.0, start - fall / 2.0, end + rise / 2.0, fall / 2.0]
        }
    }
}

/// Each knot that counts at a point, as its index in the tables, with its weight.
fn knots(noise: &Noise, lattice: &Lattice, p: Point) -> Vec<(usize, f64)> {
    let cell = p.to_array().map(whole);
    let along = |axis: usize| weights(noise.interpolation, p.along(axis) - cell[axis] as f64);
    let [wx, wy, wz] = [along(0), along(1), along(2)];
    let mut knots = Vec::new();
    for (a, wx) in (-1..).zip(wx) {
        for (b, wy) in (-1..).zip(wy) {
            for (c, wz) in (-1..).zip(wz) {
                let at = index(lattice, [cell[0] + a, cell[1] + b, cell[2] + c]);
                knots.push((at, wx * wy * wz));
            }
        }
    }
    knots
}

/// Value noise before the clamp.
pub fn unclamped(noise: &Noise, lattice: &Lattice, p: Point) -> f64 {
    knots(noise, lattice, p).into_iter().map(|(at, weight)| weight * lattice.values()[at]).sum()
}

/// Value noise.
pub fn value(noise: &Noise, lattice: &Lattice, p: Point) -> f64 {
    unclamped(noise, lattice, p).clamp(-1.0, 1.0)
}

/// Vector noise.
pub fn vector(noise: &Noise, lattice: &Lattice, p: Point) -> Vector {
    let component = |axis: usize| -> f64 {
        let knots = knots(noise, lattice, p).into_iter();
        knots.map(|(at, weight)| weight * lattice.vectors()[at].along(axis)).sum()
    };
    Vector::from([0, 1, 2].map(|axis| component(axis).clamp(-1.0, 1.0)))
}

/// `base^exponent`, multiplied out.
pub fn power(base: f64, exponent: u32) -> f64 {
    (0..exponent).map(|_| base).product()
}

/// The sum of octaves `Σ gainʲ f(noise(lacunarityʲ p))`.
pub fn sum(
    noise: &Noise,
    (gain, lacunarity): (f64, f64),
    lattice: &Lattice,
    p: Point,
    f: impl Fn(f64) -> f64,
) -> f64 {
    let octave = |j| {
        let there = Point::from(p.to_array().map(|c| c * power(lacunarity, j)));
        power(gain, j) * f(value(noise, lattice, there))
    };
    (0..noise.octaves).map(octave).sum()
}

/// The bound of a sum by its closed form.
pub fn bound(gain: f64, octaves: u32) -> f64 {
    if gain == 1.0 { f64::from(octaves) } else { (1.0 - power(gain, octaves)) / (1.0 - gain) }
}

/// fBm from 0 to 1.
pub fn fbm(noise: &Noise, lattice: &Lattice, p: Point) -> f64 {
    let max = bound(noise.gain, noise.octaves);
    (sum(noise, (noise.gain, noise.lacunarity), lattice, p, |n| n) + max) / (2.0 * max)
}

/// Vector fBm.
pub fn vector_fbm(noise: &Noise, lattice: &Lattice, p: Point) -> Vector {
    let octave = |j| {
        let there = Point::from(p.to_array().map(|c| c * power(noise.lacunarity, j)));
        power(noise.gain, j) * vector(noise, lattice, there)
    };
    (0..noise.octaves).map(octave).fold(Vector::ZERO, |sum, octave| sum + octave)
}

/// Noises of both kinds, of few octaves and any seed.
pub fn noises() -> impl Strategy<Value = Noise> {
    let factor = || prop_oneof![3 => 0.05..3.0_f64, 1 => Just(1.0), 1 => Just(0.5)];
    (any::<bool>(), 1..7_u32, factor(), 0.3..5.0_f64, 0..4_u64).prop_map(
        |(is_linear, octaves, gain, lacunarity, seed)| {
            let interpolation =
                if is_linear { Interpolation::Linear } else { Interpolation::Cubic };
            Noise { interpolation, octaves, gain, lacunarity, seed }
        },
    )
}
