//! Convergence: error against samples and time, for every choice that a page compares.
//!
//! A *choice* (a tracer, an image look-up) renders a scene with more and more samples. Each *level*
//! is the result for one number of samples, compared with references.

use serde::Serialize;

use crate::pictures::Pictures;
use crate::plot::{Plot, Series};
use crate::reference::Reference;
use crate::words::{capital, flagged, rough_or_dash, time};
use statistics::slope::power_law;
use text::document::*;

/// The confidence level of the intervals of slopes and biases.
pub const CONFIDENCE: f64 = 0.95;

/// 1, 4, 16 … up to `max`: squares, and powers of two.
pub fn counts(max: u32) -> impl Iterator<Item = u32> + Clone {
    (0..16).map(|k| 1_u32 << (2 * k)).take_while(move |samples| *samples <= max)
}

/// The slope of log error over log samples, and the ends of its interval.
pub fn slope(errors: impl IntoIterator<Item = (u32, f64)>) -> Option<[f64; 3]> {
    let points = errors.into_iter().map(|(samples, error)| (f64::from(samples), error));
    let law = power_law(&points.collect::<Vec<_>>(), CONFIDENCE)?;
    Some([law.exponent, law.interval[0], law.interval[1]])
}

/// One choice in one scene.
#[derive(Serialize)]
pub struct Choice<K> {
    /// Its name in tables and diagrams.
    #[serde(rename = "choice")]
    pub name: String,
    /// What is chosen, and what only this page measures.
    #[serde(flatten)]
    pub kind: K,
    /// The results, by increasing number of samples.
    pub levels: Vec<ErrorAtSamples>,
    /// The slope of log error over log samples, and its interval of 95 % confidence.
    pub slope: Option<[f64; 3]>,
}

/// The result for a number of samples.
#[derive(Serialize)]
pub struct ErrorAtSamples {
    pub samples: u32,
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

/// The error of a level that a diagram or table shows.
type Error = fn(&ErrorAtSamples) -> Option<f64>;

impl ErrorAtSamples {
    fn new(pictures: &Pictures, references: &[Reference]) -> Self {
        let [rmse, relative_rmse] =
            Reference::squared_error(references, &pictures.films).map(|e| e.map(f64::sqrt));
        let variance = Reference::relative_variance(references, &pictures.films);
        let seconds = pictures.time.cpu;
        Self {
            samples: pictures.samples,
            pictures: pictures.films.len() as u32,
            rmse,
            relative_rmse,
            relative_variance: variance,
            picture_seconds: seconds,
            efficiency: variance.filter(|v| *v > 0.0).map(|v| 1.0 / (v * seconds)),
            disturbed: pictures.time.is_disturbed(),
        }
    }
}

impl<K> Choice<K> {
    /// Compares the pictures, by increasing number of samples, with the reference of each frame.
    pub fn new(name: String, kind: K, pictures: &[Pictures], references: &[Reference]) -> Self {
        let levels: Vec<ErrorAtSamples> =
            pictures.iter().map(|p| ErrorAtSamples::new(p, references)).collect();
        let errors: Option<Vec<_>> = levels.iter().map(|l| Some((l.samples, l.rmse?))).collect();
        Self { name, kind, slope: errors.and_then(slope), levels }
    }

    /// The time for one sample of every pixel.
    pub fn sample_seconds(&self) -> f64 {
        self.levels.last().map_or(f64::NAN, |l| l.picture_seconds / f64::from(l.samples))
    }

    /// The efficiency with the largest number of samples.
    pub fn efficiency(&self) -> Option<f64> {
        self.levels.last()?.efficiency
    }

    /// The time for one sample as a cell of a table, marked if a measurement was disturbed.
    pub fn sample_time(&self) -> Element {
        flagged(time(self.sample_seconds()), self.levels.iter().any(|level| level.disturbed))
    }
}

/// The table with a column of errors for each of these numbers of samples.
pub fn error_columns<'a, K: 'a>(
    table: Table<&'a Choice<K>>,
    samples: impl IntoIterator<Item = u32>,
    error: Error,
) -> Table<&'a Choice<K>> {
    samples.into_iter().fold(table, |table, samples| {
        table.column(samples.to_string(), |choice| {
            let level = choice.levels.iter().find(|level| level.samples == samples);
            rough_or_dash(level.and_then(error))
        })
    })
}

/// The diagrams of errors against samples and against time. `name` names the error.
pub fn diagrams<'a, K: 'a>(
    choices: impl IntoIterator<Item = &'a Choice<K>> + Clone,
    (name, error): (&str, Error),
    limit: Option<(f64, &str)>,
) -> Element {
    let plot = |x, along: fn(&ErrorAtSamples) -> f64| {
        let series = choices.clone().into_iter().map(|choice| {
            let points = choice.levels.iter().filter_map(|l| Some((along(l), error(l)?)));
            Series::joined(&choice.name, points)
        });
        Plot { x, y: name, series: series.collect(), limit }
    };
    let samples = plot("samples per pixel", |level| f64::from(level.samples));
    let seconds = plot("seconds for the picture, on one thread", |level| level.picture_seconds);
    group("pictures")
        .with(samples.figure(format!("{} against samples.", capital(name))))
        .with(seconds.figure("The same against time."))
}
