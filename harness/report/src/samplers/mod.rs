//! Page 3: samplers, error against number of samples.

mod drawing;
pub mod integrands;
pub mod measuring;

use serde::Serialize;

use super::{Findings, Interrupted, Page, Progress, Settings};
use statistics::slope::{PowerLaw, power_law};

/// Compares samplers by error and time, on integrands whose mean is known.
pub struct Samplers;

/// The data of the page.
#[derive(Clone, Debug, Serialize)]
pub struct Data {
    /// The number of pixels over which errors are averaged.
    pub pixels: u32,
    /// The number of seeds over which errors are averaged.
    pub seeds: u32,
    /// The results for each integrand.
    pub integrands: Vec<IntegrandData>,
}

/// One integrand.
#[derive(Clone, Debug, Serialize)]
pub struct IntegrandData {
    /// Its name.
    pub name: String,
    /// A description.
    pub about: String,
    /// The results for each sampler.
    pub samplers: Vec<SamplerData>,
}

/// One sampler on one integrand.
#[derive(Clone, Debug, Serialize)]
pub struct SamplerData {
    /// Its name.
    pub sampler: String,
    /// The errors, by increasing number of samples.
    pub errors: Vec<Error>,
    /// The time to draw one sample and evaluate the integrand, on one thread.
    pub sample_seconds: f64,
    /// Whether other programs disturbed the measurement of `sample_seconds`.
    pub disturbed: bool,
    /// The slope of log error over log samples, from 16 samples on, and its interval of 95 %
    /// confidence; `None` if some error is 0.
    pub slope: Option<[f64; 3]>,
    /// The number of samples for an error of 1 %, by linear interpolation of the logarithms; `None`
    /// if the largest measured number is not enough.
    pub samples_for_one_percent: Option<f64>,
}

/// The error for a number of samples.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Error {
    /// The number of samples per pixel.
    pub samples: u32,
    /// The root mean square of `(estimate − exact)/scale`.
    pub rms: f64,
}

/// The error for which the tables give the number of samples.
const ONE_PERCENT: f64 = 0.01;
/// Slopes are fitted from this number of samples on.
const FITTED_FROM: u32 = 16;
/// The confidence level of the intervals of slopes.
const CONFIDENCE: f64 = 0.95;

impl SamplerData {
    fn law(&self) -> Option<PowerLaw> {
        let far = self.errors.iter().filter(|e| e.samples >= FITTED_FROM);
        let points: Vec<(f64, f64)> = far.map(|e| (f64::from(e.samples), e.rms)).collect();
        power_law(&points, CONFIDENCE)
    }

    /// The number of samples from which on the error is at most 1 %.
    fn samples_for_one_percent(errors: &[Error]) -> Option<f64> {
        let last = errors.iter().rposition(|e| e.rms > ONE_PERCENT);
        let Some(before) = last else { return errors.first().map(|e| f64::from(e.samples)) };
        let (a, b) = (errors[before], errors.get(before + 1)?);
        if b.rms == 0.0 {
            return Some(f64::from(b.samples));
        }
        let points = [a, *b]
            .map(|e| (groundtruth::math::ln(f64::from(e.samples)), groundtruth::math::ln(e.rms)));
        let t = (points[0].1 - groundtruth::math::ln(ONE_PERCENT)) / (points[0].1 - points[1].1);
        Some(groundtruth::math::exp(points[0].0 + t * (points[1].0 - points[0].0)))
    }

    /// The time for an error of 1 % in one pixel.
    pub fn seconds_for_one_percent(&self) -> Option<f64> {
        Some(self.samples_for_one_percent? * self.sample_seconds)
    }
}

impl Page for Samplers {
    fn name(&self) -> &'static str {
        "samplers"
    }

    fn title(&self) -> &'static str {
        "Samplers: error against number of samples"
    }

    fn question(&self) -> &'static str {
        "Which sampler has the smallest error, with how many samples, in how much time?"
    }

    fn steps(&self, settings: &Settings) -> u64 {
        measuring::steps(settings)
    }

    fn run(
        &self,
        settings: &Settings,
        progress: &Progress,
    ) -> Result<Box<dyn Findings>, Interrupted> {
        Ok(Box::new(measuring::measure(settings, progress)?))
    }
}

impl Findings for Data {
    fn data(&self) -> serde_json::Result<serde_json::Value> {
        serde_json::to_value(self)
    }

    fn drawing(&self) -> String {
        drawing::page(self)
    }
}
