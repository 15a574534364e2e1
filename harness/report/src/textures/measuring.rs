//! Measures the errors of pictures by either look-up, from 1 to 256 samples.

use super::scenes::{SUBJECTS, Subject};
use super::{ChoiceData, Data, Level, SceneData};
use crate::errors::{counts, slope};
use crate::pictures::{Pictures, Series, rendered};
use crate::{Interrupted, Progress, Settings};
use groundtruth::film::Film;
use groundtruth::math::hash;
use groundtruth::textures::Filtering;
use groundtruth::world::MAX_SAMPLES;

/// The numbers of samples per pixel: 1, 4, 16, 64, 256 in a full report.
fn samples(settings: &Settings) -> impl Iterator<Item = u32> + Clone {
    counts(settings.samples.clamp(16, 256))
}

/// The number of samples of a reference: 65 536 in a full report.
fn reference_samples(settings: &Settings) -> u32 {
    (16 * settings.samples.max(64)).min(MAX_SAMPLES)
}

/// The number of pictures of each frame, with different seeds.
fn replicas(settings: &Settings) -> u32 {
    settings.seeds.clamp(2, 8)
}

pub fn steps(settings: &Settings) -> u64 {
    let pictures = 1 + samples(settings).count() as u64 * u64::from(replicas(settings));
    let moments: u64 = SUBJECTS.iter().map(|subject| u64::from(subject.moments)).sum();
    2 * moments * pictures
}

pub fn measure(settings: &Settings, progress: &Progress) -> Result<Data, Interrupted> {
    let subjects = (0..).zip(&SUBJECTS);
    let scenes = subjects.map(|(index, subject)| measure_scene(subject, index, settings, progress));
    Ok(Data { scenes: scenes.collect::<Result<_, _>>()? })
}

fn measure_scene(
    subject: &'static Subject,
    index: u64,
    settings: &Settings,
    progress: &Progress,
) -> Result<SceneData, Interrupted> {
    let choice = |filtering| {
        let frame = |moment| (subject.frame)(filtering, settings.width, moment);
        let series = |samples: u32, replicas: std::ops::RangeInclusive<u32>| {
            // seeds do not depend on the look-up: both use the same sample points
            let seed = |replica: u32| {
                hash(&[settings.seed, 5, index, u64::from(samples), u64::from(replica)])
            };
            Series::new(samples, (0..subject.moments).map(frame), replicas.map(seed))
        };
        let reference = series(reference_samples(settings), 0..=0);
        let levels = samples(settings).map(|samples| series(samples, 1..=replicas(settings)));
        let series: Vec<Series> = std::iter::once(reference).chain(levels).collect();
        let mut pictures = rendered(&series, progress)?;
        let references = pictures.remove(0).films;
        let levels: Vec<Level> = series[1..]
            .iter()
            .zip(&pictures)
            .map(|(series, pictures)| level(series, pictures, &references))
            .collect();
        let slope = slope(levels.iter().map(|level| (level.samples, level.rmse)));
        let shown = [pictures[0].films[0].clone(), references[0].clone()];
        Ok((ChoiceData { filtering, levels, slope, pictures: shown }, references))
    };
    let (nearest, all_nearest) = choice(Filtering::Nearest)?;
    let (bilinear, all_bilinear) = choice(Filtering::Bilinear)?;
    let pairs = all_nearest.iter().zip(&all_bilinear);
    Ok(SceneData {
        subject,
        width: all_nearest[0].width(),
        height: all_nearest[0].height(),
        moments: subject.moments,
        reference_samples: reference_samples(settings),
        difference: mean(pairs.map(|(a, b)| mean_square(a, b))).sqrt(),
        choices: [nearest, bilinear],
    })
}

/// The result for a number of samples, compared with the reference of each frame.
fn level(series: &Series, pictures: &Pictures, references: &[Film]) -> Level {
    let replicas = pictures.films.len() / references.len();
    let frames = pictures.films.chunks(replicas).zip(references);
    let squares =
        frames.flat_map(|(films, reference)| films.iter().map(|film| mean_square(film, reference)));
    Level {
        samples: series.samples,
        pictures: series.count(),
        rmse: mean(squares).sqrt(),
        picture_seconds: pictures.time.cpu,
        disturbed: pictures.time.is_disturbed(),
    }
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
