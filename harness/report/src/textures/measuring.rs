//! Measures the errors of pictures by either look-up, from 1 to 256 samples.

use std::path::Path;

use rayon::prelude::*;

use super::scenes::{SUBJECTS, Subject};
use super::{ChoiceData, Data, Level, SceneData};
use crate::clock::{self, Time};
use crate::picture::picture;
use crate::{Interrupted, Progress, Settings};
use groundtruth::film::Film;
use groundtruth::math::hash;
use groundtruth::textures::Filtering;
use groundtruth::world::{MAX_SAMPLES, World};
use statistics::quantile;
use statistics::slope::power_law;

const FILTERINGS: [Filtering; 2] = [Filtering::Nearest, Filtering::Bilinear];

/// 1, 4, 16, 64, 256: squares, and powers of two.
fn counts(settings: &Settings) -> Vec<u32> {
    let max = settings.samples.clamp(16, 256);
    (0..=4).map(|k| 1_u32 << (2 * k)).filter(|n| *n <= max).collect()
}

/// The number of samples of a reference: 65 536 in a full report.
fn reference_samples(settings: &Settings) -> u32 {
    (16 * settings.samples.max(64)).min(MAX_SAMPLES)
}

/// The number of pictures of each frame, with different seeds.
fn replicas(settings: &Settings) -> u32 {
    settings.seeds.clamp(2, 8)
}

/// One picture to render.
#[derive(Clone, Copy)]
struct Job<'a> {
    subject: &'a Subject,
    filtering: Filtering,
    width: u32,
    moment: u32,
    samples: u32,
    seed: u64,
}

impl Job<'_> {
    fn world(&self) -> World {
        let mut scene = self.subject.scene(self.filtering, self.width, self.moment);
        scene.image.samples = self.samples;
        World::build_seeded(&scene, Path::new(""), self.seed).expect("the page's scenes are valid")
    }
}

/// Renders all pictures, each on one thread and with one progress step.
fn rendered(jobs: &[Job<'_>], progress: &Progress) -> Result<Vec<(Film, Time)>, Interrupted> {
    jobs.par_iter()
        .with_max_len(1)
        .map(|job| {
            let world = job.world();
            let shot = clock::time(|| picture(&world));
            progress.step()?;
            Ok(shot)
        })
        .collect()
}

pub fn steps(settings: &Settings) -> u64 {
    let pictures = 1 + counts(settings).len() as u64 * u64::from(replicas(settings));
    let moments: u64 = SUBJECTS.iter().map(|subject| u64::from(subject.moments)).sum();
    FILTERINGS.len() as u64 * moments * pictures
}

pub fn measure(settings: &Settings, progress: &Progress) -> Result<Data, Interrupted> {
    let subjects = (0..).zip(&SUBJECTS);
    let scenes = subjects.map(|(index, subject)| measure_scene(subject, index, settings, progress));
    Ok(Data { scenes: scenes.collect::<Result<_, _>>()? })
}

fn measure_scene(
    subject: &Subject,
    index: u64,
    settings: &Settings,
    progress: &Progress,
) -> Result<SceneData, Interrupted> {
    let mut choices = Vec::new();
    let mut all_references = Vec::new();
    for filtering in FILTERINGS {
        // seeds do not depend on the look-up: both use the same sample points
        let job = |moment, samples, replica: u32| Job {
            subject,
            filtering,
            width: settings.width,
            moment,
            samples,
            seed: hash(&[settings.seed, 5, index, u64::from(samples), u64::from(replica)]),
        };
        let samples = reference_samples(settings);
        let jobs: Vec<Job<'_>> = (0..subject.moments).map(|m| job(m, samples, 0)).collect();
        let references: Vec<Film> =
            rendered(&jobs, progress)?.into_iter().map(|(film, _)| film).collect();
        let (levels, first) = measure_levels(&job, &references, settings, progress)?;
        let points: Vec<(f64, f64)> =
            levels.iter().map(|level| (f64::from(level.samples), level.rmse)).collect();
        let slope =
            power_law(&points, 0.95).map(|law| [law.exponent, law.interval[0], law.interval[1]]);
        let pictures = [first, references[0].clone()];
        choices.push(ChoiceData { filtering, levels, slope, pictures });
        all_references.push(references);
    }
    let [width, height] = [all_references[0][0].width(), all_references[0][0].height()];
    let pairs = all_references[0].iter().zip(&all_references[1]);
    let square = mean(pairs.map(|(a, b)| mean_square(a, b)));
    Ok(SceneData {
        scene: subject.name.to_owned(),
        about: subject.about.to_owned(),
        width,
        height,
        moments: subject.moments,
        reference_samples: reference_samples(settings),
        difference: square.sqrt(),
        choices,
    })
}

/// The results for each number of samples, and the first picture of one sample.
fn measure_levels<'a>(
    job: &impl Fn(u32, u32, u32) -> Job<'a>,
    references: &[Film],
    settings: &Settings,
    progress: &Progress,
) -> Result<(Vec<Level>, Film), Interrupted> {
    let mut levels = Vec::new();
    let mut first = None;
    for samples in counts(settings) {
        let moments = 0..references.len() as u32;
        let jobs: Vec<Job<'a>> = moments
            .flat_map(|moment| (1..=replicas(settings)).map(move |replica| (moment, replica)))
            .map(|(moment, replica)| job(moment, samples, replica))
            .collect();
        let shots = rendered(&jobs, progress)?;
        let errors = jobs.iter().zip(&shots);
        let square = mean(
            errors.map(|(job, (film, _))| mean_square(film, &references[job.moment as usize])),
        );
        let median = |of: fn(&Time) -> f64| {
            let times: Vec<f64> = shots.iter().map(|(_, time)| of(time)).collect();
            quantile(&times, 0.5).unwrap_or(f64::NAN)
        };
        let time = Time { cpu: median(|t| t.cpu), wall: median(|t| t.wall) };
        levels.push(Level {
            samples,
            pictures: jobs.len() as u32,
            rmse: square.sqrt(),
            picture_seconds: time.cpu,
            disturbed: time.is_disturbed(),
        });
        first = first.or_else(|| shots.into_iter().next().map(|(film, _)| film));
    }
    Ok((levels, first.expect("there is a level of one sample")))
}

fn mean(values: impl Iterator<Item = f64>) -> f64 {
    let (sum, count) = values.fold((0.0, 0.0), |(sum, count), value| (sum + value, count + 1.0));
    sum / count
}

/// The mean over pixels and channels of the squared difference.
fn mean_square(a: &Film, b: &Film) -> f64 {
    let pixels = a.pixels().iter().zip(b.pixels());
    mean(pixels.map(|(a, b)| (*a + -1.0 * *b).map(|d| d * d).average()))
}
