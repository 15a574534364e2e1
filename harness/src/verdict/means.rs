//! Means over the picture and its objects, and how far apart those of two renderers may be.

use serde::Serialize;
use statrs::distribution::{ContinuousCDF, StudentsT};

use super::areas::{Area, Areas};
use super::pool::Pool;
use crate::verify::means::difference;

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

impl Means {
    /// Of the whole picture and of each object, the last picture of a pool against the others. All intervals together
    /// hold with this confidence, if its noise is `noise` times that of the others, and each value may be so far off by
    /// rounding ([`super::Stored::slack`]).
    pub fn of(
        pool: &Pool,
        areas: &Areas,
        (noise, slack): (f64, &[f64]),
        confidence: f64,
    ) -> Vec<Self> {
        let all = Self::areas(areas);
        let each = 1.0 - (1.0 - confidence) / all.len() as f64;
        let of = |(area, name)| {
            let pixels = areas.pixels(area);
            let means = mean(pool, &pixels, name, noise, each);
            means.with_rounding(pool, &pixels, slack)
        };
        all.into_iter().map(of).collect()
    }

    /// The same, of several pictures of each side by Welch's interval: nothing is assumed of their noise. The pool has so
    /// many of ours, and the mean of theirs.
    pub fn of_several(
        [theirs, ours]: [&[Vec<f32>]; 2],
        (pool, slack): (&Pool, &[f64]),
        areas: &Areas,
        confidence: f64,
    ) -> Vec<Self> {
        let all = Self::areas(areas);
        let each = 1.0 - (1.0 - confidence) / all.len() as f64;
        let of = |(area, name)| {
            let pixels = areas.pixels(area);
            let total = |picture: &Vec<f32>| {
                let values = pixels.iter().flat_map(|pixel| &picture[3 * pixel..3 * pixel + 3]);
                values.map(|value| f64::from(*value)).sum::<f64>() / (3 * pixels.len()) as f64
            };
            let [a, b] = [theirs, ours].map(|all| all.iter().map(total).collect::<Vec<f64>>());
            let means = mean(pool, &pixels, name, 1.0, each);
            let level = means.level();
            let half = match difference(&a, &b, each) {
                Some([_, low, high]) if level != 0.0 => 0.5 * (high - low) / level.abs(),
                _ => 0.0,
            };
            Self { half, ..means }.with_rounding(pool, &pixels, slack)
        };
        all.into_iter().map(of).collect()
    }

    /// The whole picture and its objects, with their names.
    fn areas(areas: &Areas) -> Vec<(Area, String)> {
        let whole = Area::Tile { corner: [0, 0], side: areas.size[0].max(areas.size[1]) };
        let objects = (0..areas.objects.len())
            .map(|object| (Area::Object(object), areas.objects[object].0.to_string()));
        std::iter::once((whole, "the picture".to_owned())).chain(objects).collect()
    }

    /// Whether the mean lies outside its interval.
    pub fn is_outside(&self) -> bool {
        self.relative.is_some_and(|relative| relative.abs() > self.half)
    }

    /// Whether it may be beyond a relative margin.
    pub fn is_beyond(&self, margin: f64) -> bool {
        self.relative.is_some_and(|relative| relative.abs() + self.half > margin)
    }

    /// The mean of ours over all channels.
    fn level(&self) -> f64 {
        self.ours.iter().sum::<f64>() / 3.0
    }

    /// With an interval that contains what rounding may do: to all values alike, and to each by itself.
    fn with_rounding(mut self, pool: &Pool, pixels: &[usize], slack: &[f64]) -> Self {
        let level = self.level();
        if level == 0.0 {
            return self;
        }
        let (theirs, values) = (pool.count() - 1, (3 * pixels.len()) as f64);
        let (mut alike, mut squares) = (0.0, 0.0);
        for at in pixels.iter().flat_map(|pixel| 3 * pixel..3 * pixel + 3) {
            alike += slack[at];
            squares += pool.stored.rounding(pool.mean_of_others(theirs, at)).powi(2);
        }
        self.half += (alike + DEVIATIONS * squares.sqrt()) / values / level.abs();
        self
    }

    /// Whether the intervals lie within a relative margin.
    pub fn within(means: &[Self], margin: f64) -> Answer {
        let [mut all_within, mut one_beyond] = [true, false];
        for Self { relative, half, .. } in means {
            // what is black in both is within
            let apart = relative.map_or(0.0, f64::abs);
            all_within &= apart + half <= margin;
            one_beyond |= apart - half > margin;
        }
        match (all_within, one_beyond) {
            (_, true) => Answer::DiffersByMore,
            (true, _) => Answer::Agrees,
            _ => Answer::CannotTell,
        }
    }
}

fn mean(pool: &Pool, pixels: &[usize], name: String, noise: f64, confidence: f64) -> Means {
    let theirs = pool.count() - 1;
    let of_values = |value: &dyn Fn(usize) -> f64| {
        let mut sums = [0.0; 3];
        for pixel in pixels {
            for (channel, sum) in sums.iter_mut().enumerate() {
                let value = value(3 * pixel + channel);
                *sum += if value.is_finite() { value } else { 0.0 };
            }
        }
        sums.map(|sum| sum / pixels.len() as f64)
    };
    let of = |picture: usize| of_values(&|at| f64::from(pool.picture(picture)[at]));
    let ours: Vec<[f64; 3]> = (0..theirs).map(of).collect();
    let n = ours.len() as f64;
    let mean = [0, 1, 2].map(|channel| ours.iter().map(|mean| mean[channel]).sum::<f64>() / n);
    let total = |mean: &[f64; 3]| mean.iter().sum::<f64>() / 3.0;
    let middle = total(&mean);
    let squares: f64 = ours.iter().map(|it| (total(it) - middle) * (total(it) - middle)).sum();
    let mean = pool.reference().map_or(mean, |mean| of_values(&|at| mean.values[at]));
    let level = total(&mean);
    // of a picture with their noise, and of the mean of ours
    let deviation = (squares / (n - 1.0) * (noise * noise + pool.variance_of_mean())).sqrt();
    let student = StudentsT::new(0.0, 1.0, n - 1.0).expect("there are at least two");
    let theirs = of(theirs);
    let relative = (level != 0.0).then(|| total(&theirs) / level - 1.0);
    let half = student.inverse_cdf(0.5 + 0.5 * confidence) * deviation / level.abs();
    let half = if deviation == 0.0 { 0.0 } else { half };
    Means { name, pixels: pixels.len(), ours: mean, theirs, relative, half }
}
