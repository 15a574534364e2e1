//! Measures the errors of pictures by every choice, from 1 to 1024 samples.

use std::path::Path;

use rayon::prelude::*;

use super::pictures::{Reference, brightness};
use super::scenes::{Choice, DEPTH, SUBJECTS, Subject, set_rule};
use super::{BiasData, ChoiceData, Crop, Data, EqualTime, Level, ReferenceData, SceneData};
use crate::clock::{self, Time};
use crate::picture::picture;
use crate::{Interrupted, Progress, Settings};
use groundtruth::film::Film;
use groundtruth::lobes::GlossyRule;
use groundtruth::math::hash;
use groundtruth::scene::{Depth, Scene, Tracer};
use groundtruth::world::World;
use statistics::means::{difference, interval};
use statistics::quantile;

/// The largest number of samples per pixel, whatever the settings.
const MAX_SAMPLES: u32 = 1024;
/// The number of samples per pixel in all replicas together that is enough.
const ENOUGH: u32 = 512;
/// The confidence level of intervals.
pub const CONFIDENCE: f64 = 0.95;
/// The depth limits whose bias is measured, compared with [`MAX_DEPTH`].
const DEPTHS: [u32; 4] = [1, 2, 4, DEPTH];
/// The reference of [`DEPTHS`].
const MAX_DEPTH: u32 = 32;

/// 1, 4, 16 … 1024: squares, and powers of two.
fn counts(settings: &Settings) -> Vec<u32> {
    let max = settings.samples.clamp(4, MAX_SAMPLES);
    (0..=5).map(|k| 1_u32 << (2 * k)).filter(|n| *n <= max).collect()
}

/// The number of pictures with `samples` samples: at least two, to estimate their variance.
fn replicas(samples: u32, settings: &Settings) -> u32 {
    (ENOUGH / samples).clamp(2, settings.seeds.max(2))
}

/// Pictures that differ only in their seed.
struct Series {
    scene: Scene,
    replicas: u32,
    seed: u64,
}

/// The pictures of a series.
#[derive(Clone)]
struct Pictures {
    films: Vec<Film>,
    /// The median time for one picture on one thread.
    time: Time,
}

impl Pictures {
    fn brightnesses(&self) -> Vec<f64> {
        self.films.iter().map(brightness).collect()
    }
}

impl Series {
    fn new(mut scene: Scene, samples: u32, replicas: u32, seed: u64) -> Self {
        scene.image.samples = samples;
        Self { scene, replicas, seed }
    }

    fn world(&self, replica: u32) -> World {
        let seed = hash(&[self.seed, replica.into()]);
        World::build_seeded(&self.scene, Path::new(""), seed).expect("the page's scenes are valid")
    }
}

/// Renders all pictures of all series, each on one thread and with one progress step.
fn rendered(series: &[Series], progress: &Progress) -> Result<Vec<Pictures>, Interrupted> {
    let jobs: Vec<(&Series, u32)> =
        series.iter().flat_map(|s| (0..s.replicas).map(move |replica| (s, replica))).collect();
    // in order, so that the results do not depend on the number of threads
    let shots: Result<Vec<(Film, Time)>, Interrupted> = jobs
        .into_par_iter()
        .with_max_len(1)
        .map(|(series, replica)| {
            let world = series.world(replica);
            let shot = clock::time(|| picture(&world));
            progress.step()?;
            Ok(shot)
        })
        .collect();
    let mut shots = shots?.into_iter();
    let of_series = |series: &Series| {
        let (films, times): (Vec<Film>, Vec<Time>) =
            shots.by_ref().take(series.replicas as usize).unzip();
        let median = |of: fn(&Time) -> f64| {
            let values: Vec<f64> = times.iter().map(of).collect();
            quantile(&values, 0.5).unwrap_or(f64::NAN)
        };
        Pictures { films, time: Time { cpu: median(|t| t.cpu), wall: median(|t| t.wall) } }
    };
    Ok(series.iter().map(of_series).collect())
}

/// All pictures of a scene except those of equal time.
struct Plan {
    reference: Series,
    /// For each choice, by increasing number of samples.
    levels: Vec<Vec<Series>>,
    /// For each of [`DEPTHS`], and for [`MAX_DEPTH`].
    depths: Vec<Series>,
    /// The book's and the normalised rule of glossy reflection, by whitted and path.
    rules: Vec<(Tracer, [Series; 2])>,
}

impl Plan {
    fn new(subject: &Subject, index: u64, settings: &Settings) -> Self {
        let choices = subject.choices();
        let best = *choices.last().expect("every scene has choices");
        let counts = counts(settings);
        let most = counts.last().copied().unwrap_or(1);
        // `what` and `which` identify a series: no two pictures have the same seed
        let seed = |what: u64, which: u64| hash(&[settings.seed, index, what, which]);
        let scene = |choice: Choice| subject.scene(choice, settings.width);
        let many = settings.seeds.max(2);

        let level = |(which, choice): (u64, &Choice)| {
            let series = |&samples: &u32| {
                let seed = seed(1 + u64::from(samples), which);
                Series::new(scene(*choice), samples, replicas(samples, settings), seed)
            };
            counts.iter().map(series).collect()
        };
        let few = (most / 64).max(4);
        let depth = |max_depth: u32| {
            let tracer = Tracer::Path(Depth { max_depth });
            let deep = scene(Choice { tracer, ..best });
            // one seed for all: the same paths, of different depths
            Series::new(deep, few, many, seed(99, 0))
        };
        let by_rule = |tracer: Tracer| {
            let rules = [GlossyRule::Book, GlossyRule::Normalised].map(|rule| {
                let mut scene = scene(Choice { tracer, ..best });
                // one seed for both: the same directions, where they are above the surface
                set_rule(&mut scene, rule).then(|| Series::new(scene, few, many, seed(100, 0)))
            });
            let [Some(book), Some(normalised)] = rules else { return None };
            Some((tracer, [book, normalised]))
        };
        let compared =
            |choice: &&Choice| matches!(choice.tracer, Tracer::Whitted(_) | Tracer::Path(_));
        let mut tracers: Vec<Tracer> =
            choices.iter().filter(compared).map(|choice| choice.tracer).collect();
        tracers.dedup();
        Self {
            reference: Series::new(scene(best), (most / 4).max(4), many, seed(0, 0)),
            levels: (0..).zip(&choices).map(level).collect(),
            depths: DEPTHS.into_iter().chain([MAX_DEPTH]).map(depth).collect(),
            rules: tracers.into_iter().filter_map(by_rule).collect(),
        }
    }

    /// The number of pictures.
    fn pictures(&self) -> u64 {
        let levels = self.levels.iter().flatten();
        let rules = self.rules.iter().flat_map(|(_, both)| both);
        let all = std::iter::once(&self.reference).chain(levels).chain(&self.depths).chain(rules);
        all.map(|series| u64::from(series.replicas)).sum()
    }
}

/// How many pictures are rendered.
pub fn steps(settings: &Settings) -> u64 {
    let of = |(index, subject): (u64, &Subject)| {
        let crops = subject.choices().len() as u64 + 1;
        Plan::new(subject, index, settings).pictures() + crops
    };
    (0..).zip(&SUBJECTS).map(of).sum()
}

/// Measures all of it.
///
/// # Errors
/// [`Interrupted`] by the user.
pub fn measure(settings: &Settings, progress: &Progress) -> Result<Data, Interrupted> {
    let mut scenes = Vec::new();
    for (index, subject) in (0..).zip(&SUBJECTS) {
        scenes.push(measure_scene(subject, index, settings, progress)?);
    }
    Ok(Data { depth: DEPTH, scenes })
}

fn measure_scene(
    subject: &Subject,
    index: u64,
    settings: &Settings,
    progress: &Progress,
) -> Result<SceneData, Interrupted> {
    let plan = Plan::new(subject, index, settings);
    let choices = subject.choices();
    let best = *choices.last().expect("every scene has choices");

    let replicas = rendered(std::slice::from_ref(&plan.reference), progress)?.remove(0);
    let reference = Reference::new(&replicas.films);
    let truth = replicas.brightnesses();
    let [width, height] = [reference.film.width(), reference.film.height()];

    let series: Vec<Series> = plan.levels.into_iter().flatten().collect();
    let pictures = rendered(&series, progress)?;
    let per_choice = series.len() / choices.len();
    let mut found = Vec::new();
    for (i, choice) in choices.iter().enumerate() {
        let range = i * per_choice..(i + 1) * per_choice;
        let levels = series[range.clone()].iter().zip(&pictures[range.clone()]);
        let levels = levels.map(|(series, pictures)| level(series, pictures, &reference)).collect();
        // the largest number of samples with enough pictures for an interval
        let level = pictures[range].iter().max_by_key(|pictures| pictures.films.len().min(8));
        let brightnesses = level.expect("a level").brightnesses();
        found.push(ChoiceData {
            choice: choice.name(),
            tracer: choice.tracer.name().to_owned(),
            sampling: choice.sampling,
            unbiased: choice.is_unbiased(),
            bias: BiasData::new(choice.name(), &brightnesses, &truth),
            levels,
        });
    }

    let depths = rendered(&plan.depths, progress)?;
    let (deepest, others) = depths.split_last().expect("the deepest is there");
    let deepest = deepest.brightnesses();
    let of_depth = |(depth, pictures): (u32, &Pictures)| {
        let name = format!("path, max_depth {depth}");
        BiasData::paired(name, &pictures.brightnesses(), &deepest)
    };
    let depths = DEPTHS.into_iter().zip(others).map(of_depth).collect();

    let mut rules = Vec::new();
    for (tracer, series) in plan.rules {
        let both = rendered(&series, progress)?;
        let name = format!("{}, normalised rule", tracer.name());
        rules.push(BiasData::paired(name, &both[1].brightnesses(), &both[0].brightnesses()));
    }

    let of_best = found.last().expect("every scene has choices");
    let equal_time = equal_time(subject, index, settings, progress, (&found, of_best))?;
    let own = reference.own_error();
    Ok(SceneData {
        scene: subject.name.to_owned(),
        about: subject.about.to_owned(),
        width,
        height,
        reference: ReferenceData {
            choice: best.name(),
            samples: plan.reference.scene.image.samples * plan.reference.replicas,
            mean: reference.mean,
            standard_error: own.radiance,
            relative_standard_error: own.relative,
        },
        choices: found,
        depths,
        deepest: MAX_DEPTH,
        rules,
        equal_time,
    })
}

fn level(series: &Series, pictures: &Pictures, reference: &Reference) -> Level {
    let [square, relative] = reference.squared_error(&pictures.films);
    let variance = reference.relative_variance(&pictures.films);
    let seconds = pictures.time.cpu;
    Level {
        samples: series.scene.image.samples,
        pictures: series.replicas,
        rmse: square.map(f64::sqrt),
        relative_rmse: relative.map(f64::sqrt),
        relative_variance: variance,
        picture_seconds: seconds,
        efficiency: variance.filter(|v| *v > 0.0).map(|v| 1.0 / (v * seconds)),
        disturbed: pictures.time.is_disturbed(),
    }
}

/// A picture of each choice, with as many samples as fit into the time of the best choice for 16
/// samples.
fn equal_time(
    subject: &Subject,
    index: u64,
    settings: &Settings,
    progress: &Progress,
    (found, of_best): (&[ChoiceData], &ChoiceData),
) -> Result<EqualTime, Interrupted> {
    /// Samples per pixel of the best choice.
    const SAMPLES: u32 = 16;
    /// Samples per pixel of the reference.
    const TRUE_SAMPLES: u32 = 256;
    /// The ratio of the width of these pictures to that of the others.
    const LARGER: u32 = 2;
    let longer = f64::from(LARGER * LARGER);
    let seconds = longer * f64::from(SAMPLES) * of_best.sample_seconds();
    let fits = |choice: &ChoiceData| {
        // a square, because the sampler rounds up to a square
        let side = (seconds / (longer * choice.sample_seconds())).sqrt().round();
        let side = if side.is_finite() { side.clamp(1.0, 32.0) as u32 } else { 1 };
        side * side
    };
    let one = |which: u64, choice: Choice, samples: u32| {
        let seed = hash(&[settings.seed, index, u64::MAX, which]);
        Series::new(subject.scene(choice, LARGER * settings.width), samples, 1, seed)
    };
    let choices = subject.choices();
    // the last one is the reference
    let best = *choices.last().expect("every scene has choices");
    let truth = one(u64::MAX, best, TRUE_SAMPLES.min(settings.samples));
    let timed = (0..).zip(choices).zip(found);
    let timed = timed.map(|((which, choice), found)| one(which, choice, fits(found)));
    let series: Vec<Series> = timed.chain([truth]).collect();
    let names = found.iter().map(|choice| choice.choice.clone()).chain(["many samples".to_owned()]);
    let crop = |((series, pictures), choice): ((&Series, Pictures), String)| Crop {
        choice,
        samples: series.scene.image.samples,
        film: pictures.films.into_iter().next().expect("one picture"),
        seconds: pictures.time.cpu,
    };
    let pictures = rendered(&series, progress)?;
    let crops = series.iter().zip(pictures).zip(names).map(crop).collect();
    Ok(EqualTime { seconds, crops })
}

impl BiasData {
    /// The difference of the means of `values` and `truth`, relative to the mean of `truth`.
    pub fn new(name: String, values: &[f64], truth: &[f64]) -> Self {
        Self::relative(name, difference(values, truth, CONFIDENCE), truth)
    }

    /// The same for pairs of pictures with the same seed, whose noise is correlated.
    pub fn paired(name: String, values: &[f64], truth: &[f64]) -> Self {
        let differences: Vec<f64> = values.iter().zip(truth).map(|(a, b)| a - b).collect();
        Self::relative(name, interval(&differences, CONFIDENCE), truth)
    }

    fn relative(name: String, difference: Option<[f64; 3]>, truth: &[f64]) -> Self {
        let mean = truth.iter().sum::<f64>() / truth.len() as f64;
        Self { name, difference: difference.map(|ends| ends.map(|end| end / mean)) }
    }
}
