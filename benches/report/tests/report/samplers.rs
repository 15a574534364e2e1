//! The report's page on samplers, and its integrands.

use std::collections::BTreeSet;

use super::{REPORT, SMALL, list, number};
use groundtruth::math::Pcg32;
use groundtruth::samplers::Kind;
use report::samplers::integrands::*;

/// Law: at least six integrands, each with every sampler under its own name, from 1 sample to the largest
/// number.
#[test]
fn every_sampler_is_there_for_every_integrand() {
    let count: usize = Kind::ENTRIES.iter().map(|entry| (entry.specimens)().len()).sum();
    let integrands = list(&REPORT.json["pages"]["samplers"]["integrands"]);
    assert!(integrands.len() >= 6, "{} integrands", integrands.len());
    for integrand in integrands {
        let samplers = list(&integrand["samplers"]);
        let names: BTreeSet<_> = samplers.iter().map(|s| s["sampler"].as_str()).collect();
        assert_eq!((names.len(), samplers.len()), (count, count));
        for sampler in samplers {
            let errors = list(&sampler["errors"]).iter();
            let samples: Vec<f64> = errors.map(|it| number(&it["samples"])).collect();
            assert_eq!(samples, [1.0, 4.0, 16.0, 64.0, 256.0, f64::from(SMALL.samples)]);
            let time = number(&sampler["sample_seconds"]);
            assert!(time > 0.0, "a sample took {time} s");
        }
    }
}

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
