//! Page 5: image look-up, error against samples and time.

mod drawing;
mod scenes;

use std::ops::RangeInclusive;

use serde::Serialize;

use self::scenes::{SUBJECTS, TextureScene};
use super::convergence::{self, counts};
use super::pictures::{Series, rendered};
use super::reference::Reference;
use super::{Findings, Interrupted, Page, ReportProgress, Settings};
use groundtruth::film::Film;
use groundtruth::math::hash;
use groundtruth::textures::Filtering;
use groundtruth::world::MAX_SAMPLES;

/// Compares nearest and bilinear image look-up by error and time.
pub const PAGE: Page = Page {
    name: "textures",
    title: "Textures: error against samples and time",
    question: "Does bilinear image look-up save samples, and how many samples does an image need?",
    steps: |settings| {
        let pictures = 1 + samples(settings).count() as u64 * u64::from(replicas(settings));
        let moments: u64 = SUBJECTS.iter().map(|subject| u64::from(subject.moments)).sum();
        2 * moments * pictures
    },
    measure: |settings, progress| {
        let scenes = (0..).zip(&SUBJECTS).map(|scene| measure(scene, settings, progress));
        let data = Data { scenes: scenes.collect::<Result<_, _>>()? };
        // radiance is from 0 to 1: the absolute error is enough
        let unused = ["choice", "relative_rmse", "relative_variance", "efficiency"];
        Ok(Findings::new(&data, drawing::page).without(&unused))
    },
};

/// The data of the page.
#[derive(Serialize)]
struct Data {
    scenes: Vec<SceneData>,
}

/// One scene.
#[derive(Serialize)]
struct SceneData {
    /// Its name and description.
    #[serde(flatten)]
    subject: &'static TextureScene,
    width: u32,
    height: u32,
    /// The number of frames of the animation.
    moments: u32,
    /// The number of samples per pixel of the references.
    reference_samples: u32,
    /// The root mean square difference of the references of the two look-ups: the difference that
    /// no number of samples removes.
    difference: f64,
    /// Nearest, then bilinear.
    choices: [Choice; 2],
}

/// One way to look up an image, in one scene.
type Choice = convergence::Choice<LookUp>;

/// A way to look up an image.
#[derive(Serialize)]
struct LookUp {
    filtering: Filtering,
    /// The first frame with one sample, and its reference.
    #[serde(skip)]
    pictures: [Film; 2],
}

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

fn measure(
    (index, subject): (u64, &'static TextureScene),
    settings: &Settings,
    progress: &ReportProgress,
) -> Result<SceneData, Interrupted> {
    let by = |filtering, name: &str| {
        let series = |samples: u32, replicas: RangeInclusive<u32>| {
            let frame = |moment| (subject.frame)(filtering, settings.width, moment);
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
        let references: Vec<_> = pictures.remove(0).films.chunks(1).map(Reference::new).collect();
        let shown = [&pictures[0].films[0], &references[0].film].map(Film::clone);
        let kind = LookUp { filtering, pictures: shown };
        Ok((Choice::new(name.to_owned(), kind, &pictures, &references), references))
    };
    let (nearest, references) = by(Filtering::Nearest, "nearest")?;
    let (bilinear, others) = by(Filtering::Bilinear, "bilinear")?;
    let films: Vec<Film> = others.into_iter().map(|reference| reference.film).collect();
    let [difference, _] = Reference::squared_error(&references, &films);
    Ok(SceneData {
        subject,
        width: films[0].width(),
        height: films[0].height(),
        moments: subject.moments,
        reference_samples: reference_samples(settings),
        difference: difference.map_or(0.0, f64::sqrt),
        choices: [nearest, bilinear],
    })
}
