//! Samples of known distributions, correct and slightly biased, for tests of the statistical checkers.

use std::f64::consts::{PI, TAU};

use groundtruth::math::{Pcg32, cos, ln, sin};

/// Each checker passes correct samples at this level: no false alarm for fixed seeds.
pub(super) const LEVEL: f64 = 1e-6;

/// A number of the normal distribution with mean 0 and variance 1 (Box & Muller 1958).
pub(super) fn normal(random: &mut Pcg32) -> f64 {
    let radius = (-2.0 * ln(1.0 - random.uniform())).sqrt();
    radius * cos(TAU * random.uniform())
}

/// `n` normal numbers of this mean and standard deviation.
pub(super) fn normals(n: usize, mean: f64, deviation: f64, random: &mut Pcg32) -> Vec<f64> {
    (0..n).map(|_| mean + deviation * normal(random)).collect()
}

/// Counts of `n` samples whose density is `1 + ε` in even cells and `1 − ε` in odd ones.
pub(super) fn uneven(cells: usize, n: u64, epsilon: f64, seed: u64) -> Vec<u64> {
    let mut random = Pcg32::new(seed, 1);
    let mut counts = vec![0; cells];
    let mut drawn = 0;
    while drawn < n {
        let cell = random.below(cells as u32) as usize;
        // rejection
        let density = if cell.is_multiple_of(2) { 1.0 + epsilon } else { 1.0 - epsilon };
        if random.uniform() * (1.0 + epsilon) < density {
            counts[cell] += 1;
            drawn += 1;
        }
    }
    counts
}

/// A table of `n` pairs of 7 × 7 properties, each equally frequent, whose `φ²` is the square of the
/// dependence: of six of each side, equal halves attract each other and different ones do not.
pub(super) fn paired(n: u64, dependence: f64, seed: u64) -> Vec<u64> {
    let mut random = Pcg32::new(seed, 4);
    let half = |i: u32| [1.0, 1.0, 1.0, -1.0, -1.0, -1.0, 0.0][i as usize];
    // φ² = ε² (6/7)²
    let epsilon = dependence * 7.0 / 6.0;
    let mut table = vec![0; 49];
    let mut drawn = 0;
    while drawn < n {
        let (i, j) = (random.below(7), random.below(7));
        if random.uniform() * (1.0 + epsilon) < 1.0 + epsilon * half(i) * half(j) {
            table[(7 * i + j) as usize] += 1;
            drawn += 1;
        }
    }
    table
}

/// Pairs of normal numbers with this correlation.
pub(super) fn correlated(n: usize, r: f64, seed: u64) -> [Vec<f64>; 2] {
    let mut random = Pcg32::new(seed, 5);
    let xs = normals(n, 0.0, 1.0, &mut random);
    let rest = (1.0 - r * r).sqrt();
    let ys = xs.iter().map(|x| r * x + rest * normal(&mut random)).collect();
    [xs, ys]
}

/// Uniform numbers x, moved to `x + δ sin(πx)`: F is off by about δ in the middle.
pub(super) fn bent(n: usize, delta: f64, seed: u64) -> Vec<f64> {
    let mut random = Pcg32::new(seed, 2);
    let bend = |x: f64| x + delta * sin(PI * x);
    (0..n).map(|_| bend(random.uniform())).collect()
}
