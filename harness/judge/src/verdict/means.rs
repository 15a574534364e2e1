//! Means over the picture and its objects, and how far apart those of two renderers may be.

use std::iter;

use serde::Serialize;
use statrs::distribution::{ContinuousCDF, StudentsT};

use super::evidence::finite;
use super::{Area, Areas, Pool};
use statistics::means::difference;

/// The mean of an area in a picture, and that of the others.
#[derive(Clone, Debug, Serialize)]
pub struct Means {
    /// The area's name.
    pub name: String,
    /// The number of its pixels.
    pub pixels: usize,
    /// In our pictures: the radiance of red, green and blue.
    pub ours: [f64; 3],
    /// In theirs.
    pub theirs: [f64; 3],
    /// Their mean over all channels, relative to ours, less 1; `None` if ours is black.
    pub relative: Option<f64>,
    /// The half of the interval of `relative` that noise leaves.
    pub half: f64,
    /// The same of red, green and blue.
    pub channels: [Relative; 3],
}

/// The mean of a channel relative to ours.
#[derive(Clone, Copy, Debug, Default, Serialize)]
pub struct Relative {
    /// Relative to ours, less 1; `None` if ours is black.
    pub relative: Option<f64>,
    /// The half of the interval that noise leaves.
    pub half: f64,
}

/// The errors of values that are rounded by themselves are at most so many standard deviations, all together.
const DEVIATIONS: f64 = 3.0;

/// Whether the means are within a margin.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Answer {
    /// All are within it.
    Agrees,
    /// One is beyond it.
    DiffersByMore,
    /// The noise is too large to say.
    CannotTell,
}

impl Answer {
    /// Of a margin and how far means are apart, at least and at most.
    pub(crate) fn of(all: impl Iterator<Item = [f64; 2]>, margin: f64) -> Self {
        let (mut are_within, mut is_beyond) = (true, false);
        for [least, most] in all {
            are_within &= most <= margin;
            is_beyond |= least > margin;
        }
        match (are_within, is_beyond) {
            (_, true) => Self::DiffersByMore,
            (true, _) => Self::Agrees,
            _ => Self::CannotTell,
        }
    }

    /// What is said of the margin.
    pub fn words(self) -> &'static str {
        match self {
            Self::Agrees => "all means are within it",
            Self::DiffersByMore => "a mean is beyond it",
            Self::CannotTell => {
                "cannot tell: the noise is too large; take more samples, or several pictures"
            }
        }
    }
}

impl Means {
    /// Of the whole picture and of each object, `shown`, which is the last picture of a pool as it is in its file, against
    /// the others. All intervals together hold with this confidence, if its noise is `noise` times that of the others, and
    /// each value may be so far off by rounding ([`super::Stored::slack`]). Of several pictures of theirs and ours, of whose
    /// noise nothing is assumed, the picture is their mean, and the intervals are Welch's.
    pub fn of(
        (pool, shown): (&Pool, &[f32]),
        several: Option<[&[Vec<f32>]; 2]>,
        areas: &Areas,
        (noise, slack): (f64, &[f64]),
        confidence: f64,
    ) -> Vec<Self> {
        let whole = Area::Tile { corner: [0, 0], side: areas.size[0].max(areas.size[1]) };
        let objects = areas.objects.iter().enumerate();
        let objects = objects.map(|(index, (name, _))| (Area::Object(index), name.to_string()));
        let all: Vec<_> = iter::once((whole, "the picture".to_owned())).chain(objects).collect();
        let each = 1.0 - (1.0 - confidence) / all.len() as f64;
        let of = |(area, name)| {
            let pixels = areas.pixels(area);
            let mut means = mean((pool, shown), &pixels, name, noise, each);
            if let Some(both) = several {
                let [theirs, ours] = both.map(|all| Areas::means(all, &pixels, 0..3));
                let level = means.ours.iter().sum::<f64>() / 3.0;
                means.half = match difference(&theirs, &ours, each) {
                    Some([_, low, high]) if level != 0.0 => 0.5 * (high - low) / level.abs(),
                    _ => 0.0,
                };
            }
            means.with_rounding((pool, shown), &pixels, slack)
        };
        all.into_iter().map(of).collect()
    }

    /// Whether the mean lies outside its interval.
    pub fn is_outside(&self) -> bool {
        self.relative.is_some_and(|relative| relative.abs() > self.half)
    }

    /// Whether it may be beyond a relative margin.
    pub fn is_beyond(&self, margin: f64) -> bool {
        self.relative.is_some_and(|relative| relative.abs() + self.half > margin)
    }

    /// With intervals that contain what rounding may do, to all values alike and to each by itself, and what the pixels that
    /// are set apart add: in the pool they have our values.
    fn with_rounding(
        mut self,
        (pool, shown): (&Pool, &[f32]),
        pixels: &[usize],
        slack: &[f64],
    ) -> Self {
        let (theirs, ours) = (pool.count() - 1, self.ours);
        let (mut alike, mut squares) = ([0.0; 3], [0.0; 3]);
        for at in pixels.iter().flat_map(|pixel| 3 * pixel..3 * pixel + 3) {
            let apart = f64::from((shown[at] - pool.picture(theirs)[at]).abs());
            alike[at % 3] += slack[at] + finite(apart);
            let rounding = pool.stored.rounding(pool.mean_of_others(theirs, at));
            squares[at % 3] += rounding * rounding;
        }
        let widened = |half: f64, alike: f64, squares: f64, level: f64| match level {
            0.0 => half,
            level => half + (alike + DEVIATIONS * squares.sqrt()) / level.abs(),
        };
        for (channel, it) in self.channels.iter_mut().enumerate() {
            let level = ours[channel] * pixels.len() as f64;
            it.half = widened(it.half, alike[channel], squares[channel], level);
        }
        let level = ours.iter().sum::<f64>() * pixels.len() as f64;
        self.half = widened(self.half, alike.iter().sum(), squares.iter().sum(), level);
        self
    }

    /// Whether the intervals lie within a relative margin.
    pub fn within(means: &[Self], margin: f64) -> Answer {
        // what is black in both is within
        let apart =
            |it: &Self| [-it.half, it.half].map(|by| it.relative.map_or(0.0, f64::abs) + by);
        Answer::of(means.iter().map(apart), margin)
    }

    /// Whether one percentage is not enough: channels differ from each other beyond their intervals, and by more than
    /// two decimals of a percentage show.
    pub fn is_coloured(&self) -> bool {
        let known = || self.channels.iter().filter_map(|it| Some((it.relative?, it.half)));
        known().any(|(x, half)| {
            known().any(|(y, other)| (x - y).abs() > (half + other).max(1e-4) + 1e-3 * x.abs())
        })
    }
}

fn mean(
    (pool, shown): (&Pool, &[f32]),
    pixels: &[usize],
    name: String,
    noise: f64,
    confidence: f64,
) -> Means {
    let theirs = pool.count() - 1;
    let of_values = |value: &dyn Fn(usize) -> f64| {
        let mut sums = [0.0; 3];
        for at in pixels.iter().flat_map(|pixel| 3 * pixel..3 * pixel + 3) {
            sums[at % 3] += finite(value(at));
        }
        sums.map(|sum| sum / pixels.len() as f64)
    };
    let of = |picture: usize| of_values(&|at| f64::from(pool.picture(picture)[at]));
    let ours: Vec<[f64; 3]> = (0..theirs).map(of).collect();
    let n = ours.len() as f64;
    let mean = [0, 1, 2].map(|channel| ours.iter().map(|mean| mean[channel]).sum::<f64>() / n);
    let known = pool.reference.as_ref().map_or(mean, |mean| of_values(&|at| mean.values[at]));
    let shown = of_values(&|at| f64::from(shown[at]));
    let student = StudentsT::new(0.0, 1.0, n - 1.0).expect("there are at least two");
    let quantile = student.inverse_cdf(0.5 + 0.5 * confidence);
    let relative = |part: &dyn Fn(&[f64; 3]) -> f64| {
        let (middle, level) = (part(&mean), part(&known));
        let squares: f64 = ours.iter().map(|it| (part(it) - middle) * (part(it) - middle)).sum();
        // of a picture with their noise, and of the mean of ours
        let deviation = (squares / (n - 1.0) * (noise * noise + pool.variance_of_mean())).sqrt();
        let half = if deviation == 0.0 { 0.0 } else { quantile * deviation / level.abs() };
        Relative { relative: (level != 0.0).then(|| part(&shown) / level - 1.0), half }
    };
    let Relative { relative: of_all, half } = relative(&|mean| mean.iter().sum::<f64>() / 3.0);
    let channels = [0, 1, 2].map(|channel| relative(&|mean| mean[channel]));
    let pixels = pixels.len();
    Means { name, pixels, ours: known, theirs: shown, relative: of_all, half, channels }
}
