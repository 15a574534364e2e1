//! Page 4: tracers and the sampling of lamps, error against samples and time.

mod drawing;
mod measuring;
mod pictures;
mod scenes;

use serde::Serialize;

use super::{Findings, Interrupted, Page, Settings, Watch};
use crate::film::Film;
use crate::shapes::Sampling;

/// Which tracer to use, and how to sample lamps: by error, time and bias, in scenes of the book.
pub struct Light;

/// What the page shows.
#[derive(Clone, Debug, Serialize)]
pub struct Data {
    /// The `max_depth` of every tracer that has one, but where depths are compared.
    pub depth: u32,
    /// One for each scene.
    pub scenes: Vec<SceneData>,
}

/// One scene.
#[derive(Clone, Debug, Serialize)]
pub struct SceneData {
    /// Its name.
    pub scene: String,
    /// What it is.
    pub about: String,
    /// Pixels across.
    pub width: u32,
    /// Pixels down.
    pub height: u32,
    /// What errors are measured against.
    pub reference: ReferenceData,
    /// One for each tracer and way to sample lamps.
    pub choices: Vec<ChoiceData>,
    /// Depth limits of path against the deepest.
    pub depths: Vec<BiasData>,
    /// The deepest.
    pub deepest: u32,
    /// The normalised rule of glossy reflection against the book's, by tracer; none without gloss.
    pub rules: Vec<BiasData>,
    /// Pictures that took the same time.
    pub equal_time: EqualTime,
}

/// A picture with many samples.
#[derive(Clone, Debug, Serialize)]
pub struct ReferenceData {
    /// How it was made.
    pub choice: String,
    /// Samples for each pixel, of all replicas together.
    pub samples: u32,
    /// The mean of its channels.
    pub mean: f64,
    /// The root mean square of the standard errors of its channels, as its replicas show them.
    pub standard_error: f64,
    /// The same, each relative to the brightness of its pixel.
    pub relative_standard_error: f64,
}

/// One way to follow light.
#[derive(Clone, Debug, Serialize)]
pub struct ChoiceData {
    /// Tracer and sampling of lamps.
    pub choice: String,
    /// The tracer alone.
    pub tracer: String,
    /// How lamps are sampled; none if they are not.
    pub sampling: Option<Sampling>,
    /// Whether it finds all light of the scene, but for what lies beyond the depth.
    pub unbiased: bool,
    /// Its mean against that of the reference.
    pub bias: BiasData,
    /// By rising number of samples.
    pub levels: Vec<Level>,
}

/// What so many samples give.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Level {
    /// Samples for each pixel.
    pub samples: u32,
    /// How many pictures were made.
    pub pictures: u32,
    /// Root mean square error of channels, that of the reference taken off; `None` if it is smaller
    /// than that.
    pub rmse: Option<f64>,
    /// The same, each error relative to the brightness of its pixel.
    pub relative_rmse: Option<f64>,
    /// From picture to picture, relative to the square of the brightness of each pixel.
    pub relative_variance: Option<f64>,
    /// For one picture on one thread.
    pub picture_seconds: f64,
    /// `1/(relative_variance · picture_seconds)`, per second.
    pub efficiency: Option<f64>,
    /// Whether other programs took turns with the measurement of `picture_seconds`.
    pub disturbed: bool,
}

/// The difference of two mean radiances of a picture.
#[derive(Clone, Debug, Serialize)]
pub struct BiasData {
    /// Whose mean is compared.
    pub name: String,
    /// The difference, and the ends of its interval of 95 % confidence, in units of the mean it is
    /// compared to.
    pub difference: Option<[f64; 3]>,
}

/// Pictures that took the same time. It depends on the clock.
#[derive(Clone, Debug, Serialize)]
pub struct EqualTime {
    /// About the time of each, on one thread.
    pub seconds: f64,
    /// One for each choice, and one more by the last of them with many samples, which took longer.
    pub crops: Vec<Crop>,
}

/// A picture of equal time.
#[derive(Clone, Debug, Serialize)]
pub struct Crop {
    /// Tracer and sampling of lamps, or that it is what the others should look like.
    pub choice: String,
    /// Samples for each pixel.
    pub samples: u32,
    /// What it took.
    pub seconds: f64,
    /// The picture.
    #[serde(skip)]
    pub film: Film,
}

impl ChoiceData {
    /// Seconds for one sample of each pixel.
    fn sample_seconds(&self) -> f64 {
        self.levels.last().map_or(f64::NAN, |l| l.picture_seconds / f64::from(l.samples))
    }

    /// That of the most samples.
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
        "Which tracer, and which way to sample lamps, shows a scene's light with the least error for \
         the time, and what does each leave out?"
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
