//! The error of random samples.

use statrs::distribution::{ContinuousCDF, Normal};

use groundtruth::math::Pcg32;
use groundtruth::math::power;
use groundtruth::samplers;
use report::Settings;
use report::samplers::integrands::*;
use report::samplers::{Problems, rms_errors};
use statistics::significance::sidak;

/// The chance of a false alarm, were the seed drawn anew.
const LEVEL: f64 = 1e-6;

const SETTINGS: Settings = Settings {
    seed: 5,
    cases: 0,
    objects: 0,
    side: 0,
    samples: 16,
    pixels: 16,
    seeds: 4096,
    width: 0,
};

/// The variance of one sample and its fourth central moment, in units of the scale: of a function
/// that is 1 on the share m and 0 elsewhere; and of `(e + 1) zᵉ` for z even in [0, 1], whose k-th
/// moment is `(e + 1)ᵏ/(k e + 1)`.
fn moments(integrand: &Integrand, problem: &Problem) -> Option<[f64; 2]> {
    let m = problem.exact;
    match integrand.name {
        "edge" | "corner" | "disk" | "checker to the horizon" | "soft shadow" => {
            Some([m * (1.0 - m), m * (1.0 - m) * (1.0 - 3.0 * m + 3.0 * m * m)])
        }
        "cosine power" => {
            let e = 2.0 * std::f64::consts::PI / m - 1.0;
            let moment = |k: f64| power(e + 1.0, k) / (k * e + 1.0);
            let [two, three, four] = [2.0, 3.0, 4.0].map(moment);
            Some([two - 1.0, four - 4.0 * three + 6.0 * two - 3.0])
        }
        _ => None,
    }
}

/// Law: the error of n random samples is `σ/√n`. Oracle: the variance σ² of one sample in closed
/// form, averaged over the pixels. By how much the mean of the squares of so many seeds may be off
/// follows from the fourth moments; pixels of a seed share samples, so only seeds count.
#[test]
fn the_error_of_random_samples_is_sigma_over_the_root_of_their_number() {
    let pixels = 0..SETTINGS.pixels;
    let problem =
        |integrand: &Integrand, pixel: u32| (integrand.problem)(&mut Pcg32::new(pixel.into(), 9));
    let problems: Problems = INTEGRANDS
        .iter()
        .map(|integrand| pixels.clone().map(|pixel| problem(integrand, pixel)).collect())
        .collect();
    let counts = [1, 4, 16];
    const JUDGED: usize = 6;
    let level = sidak(LEVEL, counts.len() * JUDGED);
    let most = -Normal::standard().inverse_cdf(0.5 * level);
    for n in counts {
        let found = rms_errors(&samplers::Random {}.into(), n, &problems, &SETTINGS);
        let mut judged = 0;
        for ((integrand, problems), rms) in INTEGRANDS.iter().zip(&problems).zip(found) {
            let n = f64::from(n);
            let of: Option<Vec<[f64; 2]>> =
                problems.iter().map(|problem| moments(integrand, problem)).collect();
            let Some(of) = of else { continue };
            let mean = |values: &dyn Fn(&[f64; 2]) -> f64| {
                of.iter().map(values).sum::<f64>() / of.len() as f64
            };
            let square = mean(&|[variance, _]| variance / n);
            // of the square of the mean of n samples
            let spread = mean(&|[v, fourth]| {
                (fourth + 3.0 * (n - 1.0) * v * v) / (n * n * n) - v * v / (n * n)
            });
            let error = (spread / f64::from(SETTINGS.seeds)).sqrt();
            let apart = (rms * rms - square).abs();
            assert!(
                apart < most * error,
                "{}, {n} samples: the error is {rms}, expected σ/√n = {}: its square is {} of \
                 its standard errors off, of which {most} are allowed",
                integrand.name,
                square.sqrt(),
                apart / error
            );
            // so that a factor of √2 in the error is seen
            assert!(
                most * error < 0.5 * square,
                "{}: the square {square} is known to {error} only",
                integrand.name
            );
            judged += 1;
        }
        assert_eq!(judged, JUDGED);
    }
}
