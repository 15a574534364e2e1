//! Integrands, and their means.

use groundtruth::math::Pcg32;
use report::samplers::integrands::*;

/// Law: `exact` is the mean of each function. Oracle: 2¹⁸ random points; five of their standard
/// errors, for 8 × 24 problems (level 1e-4 together).
#[test]
fn means_are_exact() {
    for integrand in &INTEGRANDS {
        for pixel in 0..24 {
            let problem = (integrand.problem)(&mut Pcg32::new(pixel, 7));
            let mut random = Pcg32::new(pixel, 8);
            let n = 1 << 18;
            let (mut sum, mut squares) = (0.0, 0.0);
            for _ in 0..n {
                let mut point = || [random.uniform(), random.uniform()];
                let value = (problem.value)(point(), point());
                sum += value;
                squares += value * value;
            }
            let n = f64::from(n);
            let mean = sum / n;
            let error = ((squares / n - mean * mean).max(0.0) / n).sqrt();
            let off = (mean - problem.exact).abs();
            assert!(off <= 5.0 * error + 1e-12, "{} {pixel}: {off}, σ {error}", integrand.name);
        }
    }
}
