//! Measures the errors of pictures by every choice, from 1 to 1024 samples.

use std::slice::from_ref;

use super::pictures::{Reference, brightness};
use super::scenes::{Choice, DEPTH, SUBJECTS, Subject, set_rule};
use super::{BiasData, ChoiceData, Crop, Data, EqualTime, Level, ReferenceData, SceneData};
use crate::errors::counts;
use crate::pictures::{Pictures, Series, rendered};
use crate::{Interrupted, Progress, Settings};
use groundtruth::lobes::GlossyRule;
use groundtruth::math::hash;
use groundtruth::scene::{Depth, Scene, Tracer};

/// The largest number of samples per pixel, whatever the settings.
const MAX_SAMPLES: u32 = 1024;
/// The number of samples per pixel in all replicas together that is enough.
const ENOUGH: u32 = 512;
/// The depth limits whose bias is measured, compared with [`MAX_DEPTH`].
const DEPTHS: [u32; 4] = [1, 2, 4, DEPTH];
/// The reference of [`DEPTHS`].
const MAX_DEPTH: u32 = 32;

/// All pictures of a scene except those of equal time.
struct Plan {
    /// The replicas of the best choice.
    reference: Series,
    /// For each choice, by increasing number of samples.
    levels: Vec<Series>,
    /// For each of [`DEPTHS`], and for [`MAX_DEPTH`].
    depths: Vec<Series>,
    /// By whitted and path, if the scene has glossy reflection.
    rules: Vec<Rules>,
}

/// The book's and the normalised rule of glossy reflection, by one tracer.
struct Rules {
    tracer: Tracer,
    series: [Series; 2],
}

/// Pictures of a scene with several seeds.
fn replicas(scene: Scene, samples: u32, count: u32, seed: u64) -> Series {
    Series::new(samples, [scene], (0..count).map(|replica| hash(&[seed, replica.into()])))
}

impl Plan {
    fn new(subject: &Subject, index: u64, settings: &Settings) -> Self {
        let choices = subject.choices();
        let samples = counts(settings.samples.clamp(4, MAX_SAMPLES));
        let most = samples.clone().last().unwrap_or(1);
        // `what` and `which` identify a series: no two pictures have the same seed
        let seed = |what: u64, which: u64| hash(&[settings.seed, index, what, which]);
        let scene = |choice: Choice| subject.scene(choice, settings.width);
        let many = settings.seeds.max(2);

        let level = |(which, choice, samples): (u64, Choice, u32)| {
            // at least two, to estimate their variance
            let count = (ENOUGH / samples).clamp(2, many);
            replicas(scene(choice), samples, count, seed(1 + u64::from(samples), which))
        };
        let few = (most / 64).max(4);
        let depth = |max_depth: u32| {
            let deep =
                scene(Choice { tracer: Tracer::Path(Depth { max_depth }), ..subject.best() });
            // one seed for all: the same paths, of different depths
            replicas(deep, few, many, seed(99, 0))
        };
        let by_rule = |tracer: Tracer| {
            let rules = [GlossyRule::Book, GlossyRule::Normalised].map(|rule| {
                let mut scene = scene(Choice { tracer, ..subject.best() });
                // one seed for both: the same directions, where they are above the surface
                set_rule(&mut scene, rule).then(|| replicas(scene, few, many, seed(100, 0)))
            });
            let [Some(book), Some(normalised)] = rules else { return None };
            Some(Rules { tracer, series: [book, normalised] })
        };
        let compared = |tracer: &Tracer| matches!(tracer, Tracer::Whitted(_) | Tracer::Path(_));
        let mut tracers: Vec<Tracer> =
            choices.iter().map(|choice| choice.tracer).filter(compared).collect();
        tracers.dedup();
        let of_choice = |(which, choice): (u64, Choice)| {
            samples.clone().map(move |samples| (which, choice, samples))
        };
        Self {
            reference: replicas(scene(subject.best()), (most / 4).max(4), many, seed(0, 0)),
            levels: (0..).zip(choices).flat_map(of_choice).map(level).collect(),
            depths: DEPTHS.into_iter().chain([MAX_DEPTH]).map(depth).collect(),
            rules: tracers.into_iter().filter_map(by_rule).collect(),
        }
    }

    /// The number of pictures.
    fn pictures(&self) -> u64 {
        let rules = self.rules.iter().flat_map(|rules| &rules.series);
        let all = from_ref(&self.reference).iter().chain(&self.levels).chain(&self.depths);
        all.chain(rules).map(|series| u64::from(series.count())).sum()
    }
}

/// The number of pictures.
pub fn steps(settings: &Settings) -> u64 {
    let of = |(index, subject): (u64, &Subject)| {
        let crops = subject.choices().len() as u64 + 1;
        Plan::new(subject, index, settings).pictures() + crops
    };
    (0..).zip(&SUBJECTS).map(of).sum()
}

pub fn measure(settings: &Settings, progress: &Progress) -> Result<Data, Interrupted> {
    let subjects = (0..).zip(&SUBJECTS);
    let scenes = subjects.map(|(index, subject)| measure_scene(subject, index, settings, progress));
    Ok(Data { depth: DEPTH, scenes: scenes.collect::<Result<_, _>>()? })
}

fn measure_scene(
    subject: &'static Subject,
    index: u64,
    settings: &Settings,
    progress: &Progress,
) -> Result<SceneData, Interrupted> {
    let plan = Plan::new(subject, index, settings);
    let reference = Reference::new(&rendered(from_ref(&plan.reference), progress)?[0].films);
    let choices = measure_choices(subject, &plan.levels, &reference, progress)?;
    let depths = measure_depths(&plan.depths, progress)?;
    let rules = plan.rules.iter().map(|rules| measure_rules(rules, progress));
    let rules = rules.collect::<Result<_, _>>()?;
    let equal_time = equal_time(subject, index, settings, progress, &choices)?;
    let own = reference.own_error();
    Ok(SceneData {
        subject,
        width: reference.film.width(),
        height: reference.film.height(),
        reference: ReferenceData {
            choice: subject.best().name(),
            samples: plan.reference.samples * plan.reference.count(),
            mean: reference.mean,
            standard_error: own.radiance,
            relative_standard_error: own.relative,
        },
        choices,
        depths,
        deepest: MAX_DEPTH,
        rules,
        equal_time,
    })
}

fn measure_choices(
    subject: &Subject,
    series: &[Series],
    reference: &Reference,
    progress: &Progress,
) -> Result<Vec<ChoiceData>, Interrupted> {
    let pictures = rendered(series, progress)?;
    let choices = subject.choices();
    let counts = series.len() / choices.len();
    let levels = series.chunks(counts).zip(pictures.chunks(counts));
    let data = |(choice, (series, pictures)): (Choice, (&[Series], &[Pictures]))| {
        // the largest number of samples with enough pictures for an interval
        let largest = pictures.iter().max_by_key(|pictures| pictures.films.len().min(8));
        let brightnesses = largest.expect("a level").brightnesses();
        ChoiceData {
            choice: choice.name(),
            tracer: choice.tracer.name().to_owned(),
            sampling: choice.sampling,
            unbiased: choice.is_unbiased(),
            bias: BiasData::new(choice.name(), &brightnesses, &reference.brightnesses),
            levels: series.iter().zip(pictures).map(|(s, p)| level(s, p, reference)).collect(),
        }
    };
    Ok(choices.into_iter().zip(levels).map(data).collect())
}

fn level(series: &Series, pictures: &Pictures, reference: &Reference) -> Level {
    let [square, relative] = reference.squared_error(&pictures.films);
    let variance = reference.relative_variance(&pictures.films);
    let seconds = pictures.time.cpu;
    Level {
        samples: series.samples,
        pictures: series.count(),
        rmse: square.map(f64::sqrt),
        relative_rmse: relative.map(f64::sqrt),
        relative_variance: variance,
        picture_seconds: seconds,
        efficiency: variance.filter(|v| *v > 0.0).map(|v| 1.0 / (v * seconds)),
        disturbed: pictures.time.is_disturbed(),
    }
}

fn measure_depths(series: &[Series], progress: &Progress) -> Result<Vec<BiasData>, Interrupted> {
    let pictures = rendered(series, progress)?;
    let (deepest, others) = pictures.split_last().expect("the deepest is there");
    let deepest = deepest.brightnesses();
    let bias = |(depth, pictures): (u32, &Pictures)| {
        let name = format!("path, max_depth {depth}");
        BiasData::paired(name, &pictures.brightnesses(), &deepest)
    };
    Ok(DEPTHS.into_iter().zip(others).map(bias).collect())
}

fn measure_rules(rules: &Rules, progress: &Progress) -> Result<BiasData, Interrupted> {
    let pictures = rendered(&rules.series, progress)?;
    let name = format!("{}, normalised rule", rules.tracer.name());
    Ok(BiasData::paired(name, &pictures[1].brightnesses(), &pictures[0].brightnesses()))
}

impl Pictures {
    /// The brightness of each picture.
    fn brightnesses(&self) -> Vec<f64> {
        self.films.iter().map(brightness).collect()
    }
}

/// A picture of each choice, with as many samples as fit into the time of the best choice (the last
/// one) for 16 samples.
fn equal_time(
    subject: &Subject,
    index: u64,
    settings: &Settings,
    progress: &Progress,
    found: &[ChoiceData],
) -> Result<EqualTime, Interrupted> {
    /// Samples per pixel of the best choice.
    const SAMPLES: u32 = 16;
    /// Samples per pixel of the reference.
    const TRUE_SAMPLES: u32 = 256;
    /// The ratio of the width of these pictures to that of the others.
    const LARGER: u32 = 2;
    let longer = f64::from(LARGER * LARGER);
    let of_best = found.last().expect("every scene has choices");
    let seconds = longer * f64::from(SAMPLES) * of_best.sample_seconds();
    let fits = |choice: &ChoiceData| {
        // a square, because the sampler rounds up to a square
        let side = (seconds / (longer * choice.sample_seconds())).sqrt().round();
        let side = if side.is_finite() { side.clamp(1.0, 32.0) as u32 } else { 1 };
        side * side
    };
    let one = |which: u64, choice: Choice, samples: u32| {
        let seed = hash(&[settings.seed, index, u64::MAX, which]);
        replicas(subject.scene(choice, LARGER * settings.width), samples, 1, seed)
    };
    let truth = one(u64::MAX, subject.best(), TRUE_SAMPLES.min(settings.samples));
    let timed = (0..).zip(subject.choices()).zip(found);
    let timed = timed.map(|((which, choice), found)| one(which, choice, fits(found)));
    let series: Vec<Series> = timed.chain([truth]).collect();
    let names = found.iter().map(|choice| choice.choice.clone()).chain(["many samples".to_owned()]);
    let crop = |((series, pictures), choice): ((&Series, Pictures), String)| Crop {
        choice,
        samples: series.samples,
        film: pictures.films.into_iter().next().expect("one picture"),
        seconds: pictures.time.cpu,
    };
    let pictures = rendered(&series, progress)?;
    let crops = series.iter().zip(pictures).zip(names).map(crop).collect();
    Ok(EqualTime { seconds, crops })
}
