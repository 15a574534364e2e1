//! How fast each sampler's estimate of the area beside an edge converges.

use groundtruth::math::ln;
use groundtruth::samplers::{Kind, Sampler};

use crate::prelude::*;
use crate::support::statistics::moments;

/// The half plane `a x + b y < c`.
#[derive(Clone, Copy)]
pub struct Edge {
    pub a: f64,
    pub b: f64,
    pub c: f64,
}

impl Edge {
    /// A random line through the circle around the unit square, uniform in the measure of lines that motions
    /// leave unchanged.
    fn random(random: &mut Pcg32) -> Self {
        let angle = TAU * random.uniform();
        let (a, b) = (cos(angle), sin(angle));
        let offset = (2.0 * random.uniform() - 1.0) * 0.5_f64.sqrt();
        Self { a, b, c: 0.5 * a + 0.5 * b + offset }
    }

    pub fn covers(&self, [x, y]: [f64; 2]) -> bool {
        self.a * x + self.b * y < self.c
    }

    /// The exact area of the unit square that it covers: for positive a and b, `∫∫ [a x + b y < c]` is a sum
    /// of squares of the amounts by which c exceeds `a x + b y` at the four corners.
    pub fn area(&self) -> f64 {
        // mirrored so that a, b > 0
        let (a, b) = (self.a.abs(), self.b.abs());
        let c = self.c - self.a.min(0.0) - self.b.min(0.0);
        let square = |x: f64| if x > 0.0 { x * x } else { 0.0 };
        (square(c) - square(c - a) - square(c - b) + square(c - a - b)) / (2.0 * a * b)
    }

    fn estimate(&self, samples: &[[f64; 2]]) -> f64 {
        samples.iter().filter(|&&at| self.covers(at)).count() as f64 / samples.len() as f64
    }
}

const REPLICAS: u32 = 4000;
const COUNTS: [u32; 4] = [4, 16, 64, 256];

fn built(kind: impl Into<Kind>) -> Arc<dyn Sampler> {
    kind.into().build(&mut ()).expect("a valid sampler")
}

/// The signed errors of `n` samples for random edges.
fn errors(sampler: &dyn Sampler, n: u32) -> Vec<f64> {
    let mut random = Pcg32::new(4, u64::from(n));
    let error = |_| {
        let edge = Edge::random(&mut random);
        edge.estimate(&sampler.fill(n, &mut random)) - edge.area()
    };
    (0..REPLICAS).map(error).collect()
}

/// Law: `Edge::area`, the oracle of the tests below, is right. Oracle: counting the points of a grid of 400 ×
/// 400, of whose cells an edge cuts at most 800.
#[test]
fn areas_beside_edges_are_right() {
    let mut random = Pcg32::new(1, 2);
    for _ in 0..50 {
        let edge = Edge::random(&mut random);
        let counted = edge.estimate(&built(Regular {}).fill(160_000, &mut random));
        near!(edge.area(), counted, 800.0 / 160_000.0);
    }
}

/// Law: no sampler is biased. Oracle: the exact area; z tests over all samplers and counts.
#[test]
fn coverage_is_right_on_average() {
    for sampler in [built(Random {}), built(Jittered {}), built(MultiJittered {})] {
        for n in COUNTS {
            let z = sigmas(&errors(&*sampler, n), 0.0);
            assert!(z.abs() < most_sigmas(12), "{sampler:?} {n}: {z}");
        }
    }
}

/// The slope of ln(mean squared error) against ln N, and its standard error.
fn fitted_slope(sampler: &dyn Sampler) -> (f64, f64) {
    let points = COUNTS.map(|n| {
        let squares: Vec<f64> = errors(sampler, n).iter().map(|e| e * e).collect();
        let (mean, variance) = moments(&squares);
        // the variance of ln m is that of m, over m²
        (ln(f64::from(n)), ln(mean), variance / f64::from(REPLICAS) / (mean * mean))
    });
    let middle = points.iter().map(|p| p.0).sum::<f64>() / points.len() as f64;
    let spread: f64 = points.iter().map(|p| (p.0 - middle) * (p.0 - middle)).sum();
    let weight = |x: f64| (x - middle) / spread;
    let slope = points.iter().map(|p| weight(p.0) * p.1).sum();
    let variance: f64 = points.iter().map(|p| weight(p.0) * weight(p.0) * p.2).sum();
    (slope, variance.sqrt())
}

/// Law: the squared error beside a straight edge falls as N⁻¹ for random samples and as N^−1.5 for jittered
/// ones. Oracle: for random samples `a(1 − a)/N` with the area a; for jittered ones the same variance in each
/// cell that the edge cuts. A cell of side `N^−½` is met by `N^−½` as many lines as the pixel, with the same
/// distribution of areas, so that the sum over the cells is exactly `K N · N^−½ / N²`.
/// Book: remedies: random and jittered samples.
#[test]
fn errors_beside_edges_fall_at_their_rates() {
    for (sampler, rate) in [(built(Random {}), -1.0), (built(Jittered {}), -1.5)] {
        let (slope, error) = fitted_slope(&*sampler);
        assert!((slope - rate).abs() < most_sigmas(2) * error, "{sampler:?}: {slope} ± {error}");
        assert!(most_sigmas(2) * error < 0.1, "it could not tell the rates apart: {error}");
    }
}

/// Law: beside an edge stratified samples are better than twice as many random ones. Oracle: the sums
/// of the squared errors.
/// Book: remedies: random and jittered samples.
#[test]
fn stratified_samples_are_better_than_random_ones() {
    let square = |errors: &[f64]| errors.iter().map(|e| e * e).sum::<f64>();
    for n in [16, 64, 256] {
        let random = square(&errors(&*built(Random {}), 2 * n));
        for sampler in [built(Jittered {}), built(MultiJittered {})] {
            assert!(square(&errors(&*sampler, n)) < random, "{sampler:?} {n}");
        }
    }
}

/// Law: with one sample all samplers are alike: that sample is uniform in the whole pixel. Oracle: the mean
/// of `a(1 − a)` with the area a, by quadrature over the lines' measure.
#[test]
fn one_sample_has_the_variance_of_a_coin() {
    // midpoints of 1000 angles and 1000 offsets
    let steps = 1000;
    let middle = |i: u32| (f64::from(i) + 0.5) / f64::from(steps);
    let mut expected = 0.0;
    for i in 0..steps {
        let angle = TAU * middle(i);
        let (a, b) = (cos(angle), sin(angle));
        for j in 0..steps {
            let offset = (2.0 * middle(j) - 1.0) * 0.5_f64.sqrt();
            let area = Edge { a, b, c: 0.5 * a + 0.5 * b + offset }.area();
            expected += area * (1.0 - area) / (f64::from(steps) * f64::from(steps));
        }
    }
    for sampler in [built(Random {}), built(Jittered {}), built(MultiJittered {})] {
        let squares: Vec<f64> = errors(&*sampler, 1).iter().map(|e| e * e).collect();
        let z = sigmas(&squares, expected);
        assert!(z.abs() < most_sigmas(3), "{sampler:?}: {z}");
    }
}
