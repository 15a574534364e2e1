//! Error against samples and time: numbers of samples, slopes and diagrams.

use crate::html::{capital, row};
use crate::plot::{Limit, Plot, Series};
use statistics::slope::power_law;

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

/// The errors of one choice, by increasing number of samples.
pub struct Curve<'a> {
    /// The name of the choice.
    pub name: &'a str,
    /// The results for each number of samples.
    pub points: Vec<Point>,
}

/// The error and time for a number of samples.
#[derive(Clone, Copy)]
pub struct Point {
    /// The number of samples per pixel.
    pub samples: u32,
    /// The time for one picture on one thread.
    pub seconds: f64,
    /// `None` if it is not significant.
    pub error: Option<f64>,
}

/// The diagrams of errors against samples and against time. `error` names the error.
pub fn diagrams(curves: &[Curve<'_>], error: &str, limit: Option<Limit<'_>>) -> String {
    let plot = |x, along: fn(&Point) -> f64| {
        let series = curves.iter().map(|curve| {
            let points = curve.points.iter().filter_map(|p| Some((along(p), p.error?)));
            Series::joined(curve.name, points)
        });
        Plot { x, y: error, series: series.collect(), limit }
    };
    let samples = plot("samples per pixel", |point| f64::from(point.samples));
    let seconds = plot("seconds for the picture, on one thread", |point| point.seconds);
    row(
        "pictures",
        &[
            samples.figure(&format!("{} against samples.", capital(error))),
            seconds.figure("The same against time."),
        ],
    )
}
