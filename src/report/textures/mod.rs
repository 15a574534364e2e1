//! Page 5: look-ups of images, error against samples and time.

mod drawing;
mod measuring;
mod scenes;

use serde::Serialize;

use super::{Findings, Interrupted, Page, Settings, Watch};
use crate::film::Film;
use crate::textures::Filtering;

/// How to look up images, and how many samples they need.
pub struct Textures;

/// What the page shows.
#[derive(Clone, Debug, Serialize)]
pub struct Data {
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
    /// How many pictures of different moments.
    pub moments: u32,
    /// Samples for each pixel of the references.
    pub reference_samples: u32,
    /// The root mean square difference of the references of the two look-ups: what the choice changes,
    /// however many samples there are.
    pub difference: f64,
    /// Nearest, then bilinear.
    pub choices: Vec<ChoiceData>,
}

/// One way to look up an image.
#[derive(Clone, Debug, Serialize)]
pub struct ChoiceData {
    /// Which texels count.
    pub filtering: Filtering,
    /// By rising number of samples.
    pub levels: Vec<Level>,
    /// The exponent with which the error falls with the number of samples, and an interval of 95 %
    /// confidence for it.
    pub slope: Option<[f64; 3]>,
    /// The first moment with one sample, and the reference.
    #[serde(skip)]
    pub pictures: [Film; 2],
}

/// What so many samples give.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Level {
    /// Samples for each pixel.
    pub samples: u32,
    /// How many pictures were made.
    pub pictures: u32,
    /// Root mean square error of channels against the reference of the same look-up.
    pub rmse: f64,
    /// For one picture on one thread.
    pub picture_seconds: f64,
    /// Whether other programs took turns with the measurement of `picture_seconds`.
    pub disturbed: bool,
}

impl ChoiceData {
    /// Seconds for one sample of each pixel.
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
        "Does bilinear look-up of an image save samples, and how many does an image need?"
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
