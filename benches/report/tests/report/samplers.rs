//! The report's page on samplers.

use std::collections::BTreeSet;

use super::{REPORT, SMALL, list, number};
use groundtruth::samplers::Kind;

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
