//! The report's page on samplers.

use std::collections::BTreeSet;

use groundtruth::samplers::Kind;
use serde_json::Value;

use super::{REPORT, SMALL, list, number, text};

fn integrands() -> &'static [Value] {
    list(&REPORT.json["pages"]["samplers"]["integrands"])
}

fn sampler<'a>(integrand: &'a Value, name: &str) -> &'a Value {
    let found = list(&integrand["samplers"]).iter().find(|s| s["sampler"] == name);
    found.expect("the sampler is there")
}

/// Samples and errors.
fn errors(sampler: &Value) -> Vec<(f64, f64)> {
    let pair = |e: &Value| (number(&e["samples"]), number(&e["rms"]));
    list(&sampler["errors"]).iter().map(pair).collect()
}

/// Law: at least six integrands, each with every sampler under its own name, from 1 sample to the largest
/// number.
#[test]
fn every_sampler_is_there_for_every_integrand() {
    let count: usize = Kind::ENTRIES.iter().map(|entry| (entry.specimens)().len()).sum();
    assert!(integrands().len() >= 6, "{} integrands", integrands().len());
    for integrand in integrands() {
        let samplers = list(&integrand["samplers"]);
        let names: BTreeSet<_> = samplers.iter().map(|s| s["sampler"].as_str()).collect();
        assert_eq!((names.len(), samplers.len()), (count, count));
        for sampler in samplers {
            let samples: Vec<f64> = errors(sampler).into_iter().map(|(n, _)| n).collect();
            assert_eq!(samples, [1.0, 4.0, 16.0, 64.0, 256.0, f64::from(SMALL.samples)]);
            let time = number(&sampler["sample_seconds"]);
            assert!(time > 0.0, "a sample took {time} s");
        }
    }
}

/// Law: the error of random samples falls with slope −1/2 for every integrand: four times as many samples
/// halve it. Oracle: the mean squared error is the variance over n. From 256 errors each rms is known to
/// 1/√512 = 4.4 % (one σ), a ratio to 6.3 %; five times that is allowed for 35 ratios.
#[test]
fn random_samples_halve_their_error_with_four_times_as_many() {
    for integrand in integrands() {
        let random = sampler(integrand, "random");
        for pair in errors(random).windows(2) {
            let ratio = pair[0].1 / pair[1].1;
            assert!((0.5 * ratio - 1.0).abs() < 0.32, "{}: {pair:?}", integrand["name"]);
        }
        let slope = number(&random["slope"][0]);
        assert!((slope + 0.5).abs() < 0.06, "{}: {slope}", integrand["name"]);
    }
}

/// Law: stratified samples are never worse than random ones (they lack the variance between cells), and far
/// better for a corner or a disk, where the slope is −3/4.
#[test]
fn stratified_samples_are_better() {
    for integrand in integrands() {
        let random = errors(sampler(integrand, "random"));
        for name in ["jittered", "multi jittered"] {
            let stratified = sampler(integrand, name);
            for (r, s) in random.iter().zip(errors(stratified)) {
                assert!(s.1 < 1.3 * r.1, "{} {name}: {s:?} {r:?}", integrand["name"]);
            }
            if ["corner", "disk"].contains(&text(&integrand["name"])) {
                let slope = number(&stratified["slope"][0]);
                assert!(slope < -0.65, "{} {name}: {slope}", integrand["name"]);
            }
        }
    }
}
