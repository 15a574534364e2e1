//! The random numbers that a scene's contents depend on: lattice noise, random spheres and colours.

use std::collections::BTreeSet;

use serde_json::Value;

use groundtruth::noise::Lattice;

use super::page::Page;
use super::tables::{all_of, has};
use super::values::{row, shown};

/// The section of random numbers, if the scene has any, and of what the text cannot say.
pub fn write(page: &mut Page, data: &Value) {
    let noises = all_of(data, "noise");
    let seeds: BTreeSet<u64> = noises.iter().filter_map(|noise| noise["seed"].as_u64()).collect();
    let draws = |picture: &str| all_of(data, "picture").iter().any(|it| *it == picture);
    let has_hash = has(data, "random_colors") || draws("country");
    let has_generator = has_hash || has(data, "random_spheres") || draws("globe");
    if !seeds.is_empty() || has_generator {
        page.heading("Random numbers");
    }
    if !seeds.is_empty() {
        page.say(NOISE);
        // bumps and wood add vectors of noise
        let has_vectors = !all_of(data, "bump").is_empty() || has(data, "wood");
        for (number, seed) in seeds.into_iter().enumerate() {
            lattice(page, seed, number == 0, has_vectors);
        }
    }
    if has_generator {
        page.say(GENERATOR);
    }
    if has_hash {
        page.say(HASH);
    }
    if has(data, "random_spheres") {
        page.say(SPHERES);
    }
    if draws("label") {
        page.heading("What this text leaves out");
        page.say(LABEL);
    }
}

const NOISE: &str = "\
Lattice noise. A point p, divided by `size`, lies in the cell of the lattice of whole numbers whose corner is \
[ix, iy, iz] = floor(p). The number (or vector) of a lattice point is that with the index \
P[(ix + P[(iy + P[iz mod 256]) mod 256]) mod 256] of the tables below, which count from 0. One octave noise(p) \
is, for `linear`, the trilinear interpolation of the 8 corners; for `cubic`, along x, then y, then z, the spline \
of the four values k0, k1, k2, k3 at the lattice planes -1, 0, 1 and 2 from the cell's corner, x (x (x c3 + c2) + c1) + c0 \
with c3 = (-k0 + 3 k1 - 3 k2 + k3)/2, c2 = k0 - 5/2 k1 + 2 k2 - k3/2, c1 = (k2 - k0)/2 and c0 = k1, where x is the \
distance from the plane of k1; the result is clamped to -1 … 1. With j from 0 to octaves - 1: \
fBm(p) is (S + M)/(2 M) with S = Σ gain^j noise(lacunarity^j p) and M = Σ gain^j; for vectors it is S itself. Turbulence \
is Σ |noise(2^j p)|/2^j divided by Σ 1/2^j.";

const GENERATOR: &str = "\
The generator is PCG-XSH-RR 64/32 (O'Neill 2014): state = 0 and one step, then state += seed and one step. \
A step gives 32 bits from the old state: x = ((state >> 18) ^ state) >> 27 as 32 bits, rotated to the right by \
state >> 59; the new state is state · 6364136223846793005 + 1, modulo 2^64. A number from 0 to 1 takes two steps, a \
and b: ((a · 2^32 + b) >> 11) / 2^53.";

const HASH: &str = "\
The hash of words is found from h = 0: for each word h = mix(mix(h) ^ word), where mix(x) is that of SplitMix64 \
(Steele, Lea & Flood 2014), with products and sums modulo 2^64: z = x + 0x9e3779b97f4a7c15; \
z = (z ^ (z >> 30)) · 0xbf58476d1ce4e5b9; z = (z ^ (z >> 27)) · 0x94d049bb133111eb; mix = z ^ (z >> 31).";

const SPHERES: &str = "\
The centres of random spheres are, in order, half_side · [2 u1 - 1, 2 u2 - 1, 2 u3 - 1] with three numbers of the \
generator for each sphere.";

const LABEL: &str = "\
The formula of the drawn image `label`. The question `texture` of `groundtruth probe` answers its colour at any point; \
any image of the same size shows the same mapping with other colours.";

/// The tables of one seed; the permutation is the same for all.
fn lattice(page: &mut Page, seed: u64, is_first: bool, has_vectors: bool) {
    let lattice = Lattice::new(seed);
    page.blank();
    if is_first {
        let permutation: Vec<String> = lattice.permutation().iter().map(u8::to_string).collect();
        page.line(0, &format!("P = [{}]", permutation.join(", ")));
    }
    let values: Vec<String> = lattice.values().iter().map(|&value| shown(value)).collect();
    page.line(0, &format!("The numbers of seed {seed}: [{}]", values.join(", ")));
    if has_vectors {
        let vectors: Vec<String> =
            lattice.vectors().iter().map(|vector| row(vector.to_array())).collect();
        page.line(0, &format!("The vectors of seed {seed}: [{}]", vectors.join(", ")));
    }
}
