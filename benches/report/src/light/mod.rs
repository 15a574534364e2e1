//! Page 4: tracers and the sampling of area lights, error against samples and time.

mod drawing;
mod measuring;
mod scenes;

use serde::Serialize;

pub use self::drawing::shown;
use self::scenes::LightScene;
use super::convergence::{self, CONFIDENCE};
use super::{Findings, Page};
use groundtruth::film::Film;
use groundtruth::shapes::Sampling;
use statistics::means::{difference, interval};

/// Compares tracers and the sampling of area lights by error, time and bias, in scenes of the book.
pub const PAGE: Page = Page {
    name: "light",
    title: "Light: error against samples and time",
    question: "Which tracer, and which sampling of area lights, has the smallest error for the time, \
               and what light does each leave out?",
    steps: measuring::steps,
    measure: |settings, progress| {
        let data = measuring::measure(settings, progress)?;
        // errors with bias become constant: they are no power of the number of samples
        Ok(Findings::new(&data, drawing::page).without(&["slope"]))
    },
};

/// The data of the page.
#[derive(Serialize)]
struct Data {
    /// The `max_depth` of every tracer that has one, except where depths are compared.
    depth: u32,
    scenes: Vec<SceneData>,
}

/// One scene.
#[derive(Serialize)]
struct SceneData {
    /// Its name and description.
    #[serde(flatten)]
    subject: &'static LightScene,
    width: u32,
    height: u32,
    reference: ReferenceData,
    /// The results for each tracer and sampling of area lights.
    choices: Vec<Choice>,
    /// The bias of depth limits of `path`, compared with `deepest`.
    depths: Vec<BiasData>,
    /// The largest depth limit.
    deepest: u32,
    /// The normalised rule of glossy reflection compared with the book's, by tracer; empty without
    /// glossy materials.
    rules: Vec<BiasData>,
    /// Pictures of equal rendering time.
    equal_time: EqualTime,
}

/// A picture with many samples.
#[derive(Serialize)]
struct ReferenceData {
    /// Its tracer and sampling.
    choice: String,
    /// The number of samples per pixel, in all replicas together.
    samples: u32,
    /// The mean of its channels.
    mean: f64,
    /// The root mean square of the standard errors of its channels, estimated from its replicas.
    standard_error: f64,
    /// The same, with each error relative to the brightness of its pixel.
    relative_standard_error: f64,
}

/// One tracer and sampling of area lights in one scene.
type Choice = convergence::Choice<MethodData>;

/// A tracer and a sampling of area lights, and its bias in a scene.
#[derive(Serialize)]
struct MethodData {
    tracer: &'static str,
    /// How area lights are sampled; `None` if they are not.
    sampling: Option<Sampling>,
    /// Whether it includes all light paths of the scene up to the depth limit.
    unbiased: bool,
    /// Its mean compared with that of the reference.
    bias: BiasData,
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
#[derive(Serialize)]
struct EqualTime {
    /// The approximate time of each, on one thread.
    seconds: f64,
    /// A picture for each choice, and one by the last choice with many samples and a longer time.
    crops: Vec<Crop>,
}

/// A picture of equal time.
#[derive(Serialize)]
struct Crop {
    /// The names of tracer and sampling, or `many samples` for the reference.
    choice: String,
    /// The number of samples per pixel.
    samples: u32,
    /// The rendering time.
    seconds: f64,
    #[serde(skip)]
    film: Film,
}

impl BiasData {
    /// The difference of the means of `values` and `truth`, relative to the mean of `truth`.
    pub fn new(name: String, values: &[f64], truth: &[f64]) -> Self {
        Self::relative(name, difference(values, truth, CONFIDENCE), truth)
    }

    /// The same for pairs of pictures with the same seed, whose noise is correlated.
    pub fn paired(name: String, values: &[f64], truth: &[f64]) -> Self {
        let differences: Vec<f64> = values.iter().zip(truth).map(|(a, b)| a - b).collect();
        Self::relative(name, interval(&differences, CONFIDENCE), truth)
    }

    fn relative(name: String, difference: Option<[f64; 3]>, truth: &[f64]) -> Self {
        let mean = truth.iter().sum::<f64>() / truth.len() as f64;
        Self { name, difference: difference.map(|ends| ends.map(|end| end / mean)) }
    }
}
