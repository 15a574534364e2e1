//! Page 3: samplers, error against number of samples.

mod drawing;
pub mod integrands;
pub mod measuring;

use serde::Serialize;

use self::integrands::Integrand;
use super::errors::slope;
use super::{Findings, Page};
use groundtruth::math::{exp, ln};

/// Compares samplers by error and time, on integrands whose mean is known.
pub const PAGE: Page = Page {
    name: "samplers",
    title: "Samplers: error against number of samples",
    question: "Which sampler has the smallest error, with how many samples, in how much time?",
    steps: measuring::steps,
    measure: |settings, progress| {
        Ok(Findings::new(&measuring::measure(settings, progress)?, drawing::page))
    },
};

/// The data of the page.
#[derive(Serialize)]
struct Data {
    /// The number of pixels over which errors are averaged.
    pixels: u32,
    /// The number of seeds over which errors are averaged.
    seeds: u32,
    /// The results for each integrand.
    integrands: Vec<IntegrandData>,
}

/// One integrand.
#[derive(Serialize)]
struct IntegrandData {
    /// Its name and description.
    #[serde(flatten)]
    integrand: &'static Integrand,
    /// The results for each sampler.
    samplers: Vec<SamplerData>,
}

/// One sampler on one integrand.
#[derive(Serialize)]
struct SamplerData {
    /// Its name.
    sampler: String,
    /// The errors, by increasing number of samples.
    errors: Vec<Error>,
    /// The time to draw one sample and evaluate the integrand, on one thread.
    sample_seconds: f64,
    /// Whether other programs disturbed the measurement of `sample_seconds`.
    disturbed: bool,
    /// The slope of log error over log samples, from 16 samples on, and its interval of 95 %
    /// confidence; `None` if some error is 0.
    slope: Option<[f64; 3]>,
    /// The number of samples for an error of 1 %, by linear interpolation of the logarithms; `None`
    /// if the largest measured number is not enough.
    samples_for_one_percent: Option<f64>,
}

/// The error for a number of samples.
#[derive(Clone, Copy, Serialize)]
struct Error {
    /// The number of samples per pixel.
    samples: u32,
    /// The root mean square of `(estimate − exact)/scale`.
    rms: f64,
}

/// The error for which the tables give the number of samples.
const ONE_PERCENT: f64 = 0.01;
/// Slopes are fitted from this number of samples on.
const FITTED_FROM: u32 = 16;

impl SamplerData {
    /// The errors of a sampler, which is not timed yet.
    fn new(sampler: String, errors: Vec<Error>) -> Self {
        let far = errors.iter().filter(|e| e.samples >= FITTED_FROM);
        Self {
            sampler,
            sample_seconds: f64::NAN,
            disturbed: false,
            slope: slope(far.map(|e| (e.samples, e.rms))),
            samples_for_one_percent: samples_for_one_percent(&errors),
            errors,
        }
    }

    /// The time for an error of 1 % in one pixel.
    fn seconds_for_one_percent(&self) -> Option<f64> {
        Some(self.samples_for_one_percent? * self.sample_seconds)
    }
}

/// The number of samples from which on the error is at most 1 %.
fn samples_for_one_percent(errors: &[Error]) -> Option<f64> {
    let last = errors.iter().rposition(|e| e.rms > ONE_PERCENT);
    let Some(before) = last else { return errors.first().map(|e| f64::from(e.samples)) };
    let (a, b) = (errors[before], errors.get(before + 1)?);
    if b.rms == 0.0 {
        return Some(f64::from(b.samples));
    }
    let [(x_a, y_a), (x_b, y_b)] = [a, *b].map(|e| (ln(f64::from(e.samples)), ln(e.rms)));
    let t = (y_a - ln(ONE_PERCENT)) / (y_a - y_b);
    Some(exp(x_a + t * (x_b - x_a)))
}
