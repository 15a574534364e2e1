//! Page 4: tracers and the sampling of area lights, error against samples and time.

mod drawing;
pub mod measuring;
pub mod pictures;
mod scenes;

use serde::Serialize;

use super::{Findings, Interrupted, Page, Progress, Settings};
use groundtruth::film::Film;
use groundtruth::shapes::Sampling;

/// Compares tracers and the sampling of area lights by error, time and bias, in scenes of the book.
pub struct Light;

/// The data of the page.
#[derive(Clone, Debug, Serialize)]
pub struct Data {
    /// The `max_depth` of every tracer that has one, except where depths are compared.
    pub depth: u32,
    /// The results for each scene.
    pub scenes: Vec<SceneData>,
}

/// One scene.
#[derive(Clone, Debug, Serialize)]
pub struct SceneData {
    /// Its name.
    pub scene: String,
    /// A description.
    pub about: String,
    /// The number of pixel columns.
    pub width: u32,
    /// The number of pixel rows.
    pub height: u32,
    /// The reference for errors.
    pub reference: ReferenceData,
    /// The results for each tracer and sampling of area lights.
    pub choices: Vec<ChoiceData>,
    /// The bias of depth limits of `path`, compared with `deepest`.
    pub depths: Vec<BiasData>,
    /// The largest depth limit.
    pub deepest: u32,
    /// The normalised rule of glossy reflection compared with the book's, by tracer; empty without
    /// glossy materials.
    pub rules: Vec<BiasData>,
    /// Pictures of equal rendering time.
    pub equal_time: EqualTime,
}

/// A picture with many samples.
#[derive(Clone, Debug, Serialize)]
pub struct ReferenceData {
    /// Its tracer and sampling.
    pub choice: String,
    /// The number of samples per pixel, in all replicas together.
    pub samples: u32,
    /// The mean of its channels.
    pub mean: f64,
    /// The root mean square of the standard errors of its channels, estimated from its replicas.
    pub standard_error: f64,
    /// The same, with each error relative to the brightness of its pixel.
    pub relative_standard_error: f64,
}

/// One tracer and sampling of area lights.
#[derive(Clone, Debug, Serialize)]
pub struct ChoiceData {
    /// The names of tracer and sampling.
    pub choice: String,
    /// The name of the tracer.
    pub tracer: String,
    /// How area lights are sampled; `None` if they are not.
    pub sampling: Option<Sampling>,
    /// Whether it includes all light paths of the scene up to the depth limit.
    pub unbiased: bool,
    /// Its mean compared with that of the reference.
    pub bias: BiasData,
    /// The results, by increasing number of samples.
    pub levels: Vec<Level>,
}

/// The result for a number of samples.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Level {
    /// The number of samples per pixel.
    pub samples: u32,
    /// The number of pictures.
    pub pictures: u32,
    /// The root mean square error of channels, with the error of the reference subtracted (in
    /// squares); `None` if the rest is smaller than the error of the reference.
    pub rmse: Option<f64>,
    /// The same, with each error relative to the brightness of its pixel.
    pub relative_rmse: Option<f64>,
    /// The variance between pictures, relative to the square of the brightness of each pixel.
    pub relative_variance: Option<f64>,
    /// The time for one picture on one thread.
    pub picture_seconds: f64,
    /// `1/(relative_variance · picture_seconds)`, per second.
    pub efficiency: Option<f64>,
    /// Whether other programs disturbed the measurement of `picture_seconds`.
    pub disturbed: bool,
}

/// The difference of two mean radiances of a picture.
#[derive(Clone, Debug, Serialize)]
pub struct BiasData {
    /// The tracer, sampling or setting that is compared.
    pub name: String,
    /// The difference and the ends of its interval of 95 % confidence, relative to the mean that it
    /// is compared with.
    pub difference: Option<[f64; 3]>,
}

/// Pictures of equal rendering time. They depend on the speed of the machine.
#[derive(Clone, Debug, Serialize)]
pub struct EqualTime {
    /// The approximate time of each, on one thread.
    pub seconds: f64,
    /// A picture for each choice, and one by the last choice with many samples and a longer time.
    pub crops: Vec<Crop>,
}

/// A picture of equal time.
#[derive(Clone, Debug, Serialize)]
pub struct Crop {
    /// The names of tracer and sampling, or `many samples` for the reference.
    pub choice: String,
    /// The number of samples per pixel.
    pub samples: u32,
    /// The rendering time.
    pub seconds: f64,
    /// The picture.
    #[serde(skip)]
    pub film: Film,
}

impl ChoiceData {
    /// The time for one sample of every pixel.
    fn sample_seconds(&self) -> f64 {
        self.levels.last().map_or(f64::NAN, |l| l.picture_seconds / f64::from(l.samples))
    }

    /// The efficiency with the largest number of samples.
    fn efficiency(&self) -> Option<f64> {
        self.levels.last()?.efficiency
    }
}

impl Page for Light {
    fn name(&self) -> &'static str {
        "light"
    }

    fn title(&self) -> &'static str {
        "Light: error against samples and time"
    }

    fn question(&self) -> &'static str {
        "Which tracer, and which sampling of area lights, has the smallest error for the time, and what \
         light does each leave out?"
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
