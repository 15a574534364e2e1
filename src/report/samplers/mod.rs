//! Page 3: samplers, error against number of samples.

mod drawing;
mod integrands;
mod measuring;

use serde::Serialize;

use super::{Findings, Interrupted, Page, Settings, Watch};
use crate::verify::slope::{PowerLaw, power_law};

/// Which sampler to use, and how many samples: by error and time, over integrands of known value.
pub struct Samplers;

/// What the page shows.
#[derive(Clone, Debug, Serialize)]
pub struct Data {
    /// Errors are root mean squares over so many pixels …
    pub pixels: u32,
    /// … and seeds.
    pub seeds: u32,
    /// One for each integrand.
    pub integrands: Vec<IntegrandData>,
}

/// One integrand.
#[derive(Clone, Debug, Serialize)]
pub struct IntegrandData {
    /// Its name.
    pub name: String,
    /// What it is.
    pub about: String,
    /// One for each sampler.
    pub samplers: Vec<SamplerData>,
}

/// One sampler on one integrand.
#[derive(Clone, Debug, Serialize)]
pub struct SamplerData {
    /// Its name.
    pub sampler: String,
    /// By rising number of samples.
    pub errors: Vec<Error>,
    /// Seconds for one sample, drawn and put into the integrand, on one thread.
    pub sample_seconds: f64,
    /// Whether other programs took turns with the measurement of `sample_seconds`.
    pub disturbed: bool,
    /// The slope of log error over log samples, from 16 samples on, and its interval of 95 %
    /// confidence; `None` if some error is 0.
    pub slope: Option<[f64; 3]>,
    /// Samples for an error of 1 %: between those measured, by the straight line of the logarithms.
    /// `None` if the most were not enough.
    pub samples_for_one_percent: Option<f64>,
}

/// An error and the number of samples that it is for.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Error {
    /// Samples for each pixel.
    pub samples: u32,
    /// The root mean square of `(estimate − exact)/scale`.
    pub rms: f64,
}

/// The error that the table is about.
const ONE_PERCENT: f64 = 0.01;
/// Slopes are fitted from so many samples on.
const FITTED_FROM: u32 = 16;
/// Of slopes.
const CONFIDENCE: f64 = 0.95;

impl SamplerData {
    fn law(&self) -> Option<PowerLaw> {
        let far = self.errors.iter().filter(|e| e.samples >= FITTED_FROM);
        let points: Vec<(f64, f64)> = far.map(|e| (f64::from(e.samples), e.rms)).collect();
        power_law(&points, CONFIDENCE)
    }

    /// Where the error reaches 1 %.
    fn reach(errors: &[Error]) -> Option<f64> {
        let last = errors.iter().rposition(|e| e.rms > ONE_PERCENT);
        let Some(before) = last else { return errors.first().map(|e| f64::from(e.samples)) };
        let (a, b) = (errors[before], errors.get(before + 1)?);
        if b.rms == 0.0 {
            return Some(f64::from(b.samples));
        }
        let points =
            [a, *b].map(|e| (crate::math::ln(f64::from(e.samples)), crate::math::ln(e.rms)));
        let share = (points[0].1 - crate::math::ln(ONE_PERCENT)) / (points[0].1 - points[1].1);
        Some(crate::math::exp(points[0].0 + share * (points[1].0 - points[0].0)))
    }

    /// Seconds for an error of 1 % in one pixel.
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
        "Which sampler comes nearest to the truth, with how many samples, in how much time?"
    }

    fn steps(&self, settings: &Settings) -> u64 {
        measuring::steps(settings)
    }

    fn run(&self, settings: &Settings, watch: &Watch) -> Result<Box<dyn Findings>, Interrupted> {
        Ok(Box::new(measuring::measure(settings, watch)?))
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
