//! Page 5: image look-up, error against samples and time.

mod drawing;
mod measuring;
mod scenes;

use serde::Serialize;

use super::{Findings, Interrupted, Page, Progress, Settings};
use groundtruth::film::Film;
use groundtruth::textures::Filtering;

/// Compares nearest and bilinear image look-up by error and time.
pub struct Textures;

/// The data of the page.
#[derive(Clone, Debug, Serialize)]
pub struct Data {
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
    /// The number of frames of the animation.
    pub moments: u32,
    /// The number of samples per pixel of the references.
    pub reference_samples: u32,
    /// The root mean square difference of the references of the two look-ups: the difference that
    /// no number of samples removes.
    pub difference: f64,
    /// Nearest, then bilinear.
    pub choices: Vec<ChoiceData>,
}

/// One way to look up an image.
#[derive(Clone, Debug, Serialize)]
pub struct ChoiceData {
    /// Nearest or bilinear.
    pub filtering: Filtering,
    /// The results, by increasing number of samples.
    pub levels: Vec<Level>,
    /// The slope of log error over log samples, and its interval of 95 % confidence.
    pub slope: Option<[f64; 3]>,
    /// The first frame with one sample, and its reference.
    #[serde(skip)]
    pub pictures: [Film; 2],
}

/// The result for a number of samples.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Level {
    /// The number of samples per pixel.
    pub samples: u32,
    /// The number of pictures.
    pub pictures: u32,
    /// The root mean square error of channels against the reference of the same look-up.
    pub rmse: f64,
    /// The time for one picture on one thread.
    pub picture_seconds: f64,
    /// Whether other programs disturbed the measurement of `picture_seconds`.
    pub disturbed: bool,
}

impl ChoiceData {
    /// The time for one sample of every pixel.
    fn sample_seconds(&self) -> f64 {
        self.levels.last().map_or(f64::NAN, |l| l.picture_seconds / f64::from(l.samples))
    }
}

impl Page for Textures {
    fn name(&self) -> &'static str {
        "textures"
    }

    fn title(&self) -> &'static str {
        "Textures: error against samples and time"
    }

    fn question(&self) -> &'static str {
        "Does bilinear image look-up save samples, and how many samples does an image need?"
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
