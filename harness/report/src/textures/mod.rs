//! Page 5: image look-up, error against samples and time.

mod drawing;
mod measuring;
mod scenes;

use serde::Serialize;

use self::scenes::Subject;
use super::errors::{Curve, Point};
use super::{Findings, Page};
use groundtruth::film::Film;
use groundtruth::textures::Filtering;

/// Compares nearest and bilinear image look-up by error and time.
pub const PAGE: Page = Page {
    name: "textures",
    title: "Textures: error against samples and time",
    question: "Does bilinear image look-up save samples, and how many samples does an image need?",
    steps: measuring::steps,
    measure: |settings, progress| {
        Ok(Findings::new(&measuring::measure(settings, progress)?, drawing::page))
    },
};

/// The data of the page.
#[derive(Serialize)]
struct Data {
    /// The results for each scene.
    scenes: Vec<SceneData>,
}

/// One scene.
#[derive(Serialize)]
struct SceneData {
    /// Its name and description.
    #[serde(flatten)]
    subject: &'static Subject,
    /// The number of pixel columns.
    width: u32,
    /// The number of pixel rows.
    height: u32,
    /// The number of frames of the animation.
    moments: u32,
    /// The number of samples per pixel of the references.
    reference_samples: u32,
    /// The root mean square difference of the references of the two look-ups: the difference that
    /// no number of samples removes.
    difference: f64,
    /// Nearest, then bilinear.
    choices: [ChoiceData; 2],
}

/// One way to look up an image.
#[derive(Serialize)]
struct ChoiceData {
    /// Nearest or bilinear.
    filtering: Filtering,
    /// The results, by increasing number of samples.
    levels: Vec<Level>,
    /// The slope of log error over log samples, and its interval of 95 % confidence.
    slope: Option<[f64; 3]>,
    /// The first frame with one sample, and its reference.
    #[serde(skip)]
    pictures: [Film; 2],
}

/// The result for a number of samples.
#[derive(Serialize)]
struct Level {
    /// The number of samples per pixel.
    samples: u32,
    /// The number of pictures.
    pictures: u32,
    /// The root mean square error of channels against the reference of the same look-up.
    rmse: f64,
    /// The time for one picture on one thread.
    picture_seconds: f64,
    /// Whether other programs disturbed the measurement of `picture_seconds`.
    disturbed: bool,
}

impl ChoiceData {
    fn name(&self) -> &'static str {
        match self.filtering {
            Filtering::Nearest => "nearest",
            Filtering::Bilinear => "bilinear",
        }
    }

    /// The time for one sample of every pixel.
    fn sample_seconds(&self) -> f64 {
        self.levels.last().map_or(f64::NAN, |l| l.picture_seconds / f64::from(l.samples))
    }

    fn curve(&self) -> Curve<'_> {
        let point = |level: &Level| Point {
            samples: level.samples,
            seconds: level.picture_seconds,
            error: Some(level.rmse),
        };
        Curve { name: self.name(), points: self.levels.iter().map(point).collect() }
    }
}
