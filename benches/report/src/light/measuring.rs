//! Measures the errors of pictures by every choice, from 1 to 1024 samples.

use std::slice::from_ref;

use super::scenes::{DEPTH, LightScene, Method, SUBJECTS, set_rule};
use super::{BiasData, Choice, Crop, Data, EqualTime, MethodData, ReferenceData, SceneData};
use crate::convergence::counts;
use crate::pictures::{Pictures, Series, rendered};
use crate::reference::{Reference, brightnesses};
use crate::{Interrupted, ReportProgress, Settings};
use groundtruth::lobes::GlossyRule;
use groundtruth::math::hash;
use groundtruth::scene::{Depth, Scene, Tracer};
use groundtruth::trace::Strategy;

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
    /// The replicas of the best method.
    reference: Series,
    /// For each method, by increasing number of samples.
    levels: Vec<Series>,
    /// For each of [`DEPTHS`], and for [`MAX_DEPTH`].
    depths: Vec<Series>,
    /// The normalised and the book's rule, by whitted and path, if the scene has glossy reflection.
    rules: Vec<(Tracer, Vec<Series>)>,
}

/// Pictures of a scene with several seeds.
fn replicas(scene: Scene, samples: u32, count: u32, seed: u64) -> Series {
    Series::new(samples, [scene], (0..count).map(|replica| hash(&[seed, replica.into()])))
}

impl Plan {
    fn new(subject: &LightScene, index: u64, settings: &Settings) -> Self {
        let methods = subject.methods();
        let samples = counts(settings.samples.clamp(4, MAX_SAMPLES));
        let most = samples.clone().last().unwrap_or(1);
        // `what` and `which` identify a series: no two pictures have the same seed
        let seed = |what: u64, which: u64| hash(&[settings.seed, index, what, which]);
        let scene = |method: Method| subject.scene(method, settings.width);
        let many = settings.seeds.max(2);

        let level = |(which, method, samples): (u64, Method, u32)| {
            // at least two, to estimate their variance
            let count = (ENOUGH / samples).clamp(2, many);
            replicas(scene(method), samples, count, seed(1 + u64::from(samples), which))
        };
        let few = (most / 64).max(4);
        let depth = |max_depth: u32| {
            let deep =
                scene(Method { tracer: Tracer::Path(Depth { max_depth }), ..subject.best() });
            // one seed for all: the same paths, of different depths
            replicas(deep, few, many, seed(99, 0))
        };
        let by_rule = |tracer: Tracer| {
            let rules = [GlossyRule::Normalised, GlossyRule::Book].into_iter().map(|rule| {
                let mut scene = scene(Method { tracer, ..subject.best() });
                // one seed for both: the same directions, where they are above the surface
                set_rule(&mut scene, rule).then(|| replicas(scene, few, many, seed(100, 0)))
            });
            Some((tracer, rules.collect::<Option<_>>()?))
        };
        let compared = |tracer: &Tracer| matches!(tracer, Tracer::Whitted(_) | Tracer::Path(_));
        let mut tracers: Vec<Tracer> =
            methods.iter().map(|method| method.tracer).filter(compared).collect();
        tracers.dedup();
        let of_method = |(which, method): (u64, Method)| {
            samples.clone().map(move |samples| (which, method, samples))
        };
        Self {
            reference: replicas(scene(subject.best()), (most / 4).max(4), many, seed(0, 0)),
            levels: (0..).zip(methods).flat_map(of_method).map(level).collect(),
            depths: DEPTHS.into_iter().chain([MAX_DEPTH]).map(depth).collect(),
            rules: tracers.into_iter().filter_map(by_rule).collect(),
        }
    }

    /// The number of pictures.
    fn pictures(&self) -> u64 {
        let rules = self.rules.iter().flat_map(|(_, series)| series);
        let all = rules.chain(&self.depths).chain(&self.levels).chain([&self.reference]);
        all.map(|series| u64::from(series.count())).sum()
    }
}

/// The number of pictures.
pub fn steps(settings: &Settings) -> u64 {
    let of = |(index, subject): (u64, &LightScene)| {
        let crops = subject.methods().len() as u64 + 1;
        Plan::new(subject, index, settings).pictures() + crops
    };
    (0..).zip(&SUBJECTS).map(of).sum()
}

pub fn measure(settings: &Settings, progress: &ReportProgress) -> Result<Data, Interrupted> {
    let subjects = (0..).zip(&SUBJECTS);
    let scenes = subjects.map(|(index, subject)| measure_scene(subject, index, settings, progress));
    Ok(Data { depth: DEPTH, scenes: scenes.collect::<Result<_, _>>()? })
}

fn measure_scene(
    subject: &'static LightScene,
    index: u64,
    settings: &Settings,
    progress: &ReportProgress,
) -> Result<SceneData, Interrupted> {
    let plan = Plan::new(subject, index, settings);
    let pictures = rendered(from_ref(&plan.reference), progress)?.remove(0);
    let reference = Reference::new(&pictures.films);
    let choices = measure_choices(subject, &plan.levels, &reference, progress)?;
    let of_depth = DEPTHS.map(|depth| format!("path, max_depth {depth}"));
    let depths = biases(&plan.depths, &of_depth, progress)?;
    let rules = plan.rules.iter().map(|(tracer, series)| {
        biases(series, &[format!("{}, normalised rule", tracer.name())], progress)
    });
    let rules = rules.collect::<Result<Vec<_>, _>>()?.concat();
    let equal_time = equal_time(subject, index, settings, progress, &choices)?;
    let [standard_error, relative_standard_error] = reference.own_error();
    Ok(SceneData {
        subject,
        width: reference.film.width(),
        height: reference.film.height(),
        reference: ReferenceData {
            choice: subject.best().name(),
            samples: pictures.samples * plan.reference.count(),
            mean: reference.mean,
            standard_error,
            relative_standard_error,
        },
        choices,
        depths,
        deepest: MAX_DEPTH,
        rules,
        equal_time,
    })
}

fn measure_choices(
    subject: &LightScene,
    series: &[Series],
    reference: &Reference,
    progress: &ReportProgress,
) -> Result<Vec<Choice>, Interrupted> {
    let pictures = rendered(series, progress)?;
    let methods = subject.methods();
    let levels = pictures.chunks(series.len() / methods.len());
    let choice = |(method, pictures): (Method, &[Pictures])| {
        // the largest number of samples with enough pictures for an interval
        let largest = pictures.iter().max_by_key(|pictures| pictures.films.len().min(8));
        let brightnesses = brightnesses(&largest.expect("a level").films);
        let kind = MethodData {
            tracer: method.tracer.name(),
            sampling: method.sampling,
            // every light of these scenes is a surface
            unbiased: Strategy::of(method.tracer).is_path(),
            bias: BiasData::new(method.name(), &brightnesses, &reference.brightnesses),
        };
        Choice::new(method.name(), kind, pictures, from_ref(reference))
    };
    Ok(methods.into_iter().zip(levels).map(choice).collect())
}

/// The biases of pictures of the same seeds with these settings, compared with the last series.
fn biases(
    series: &[Series],
    names: &[String],
    progress: &ReportProgress,
) -> Result<Vec<BiasData>, Interrupted> {
    let pictures = rendered(series, progress)?;
    let (truth, others) = pictures.split_last().expect("there are at least two");
    let truth = brightnesses(&truth.films);
    let bias = |(name, pictures): (&String, &Pictures)| {
        BiasData::paired(name.clone(), &brightnesses(&pictures.films), &truth)
    };
    Ok(names.iter().zip(others).map(bias).collect())
}

/// A picture of each choice, with as many samples as fit into the time of the best choice (the last
/// one) for 16 samples.
fn equal_time(
    subject: &LightScene,
    index: u64,
    settings: &Settings,
    progress: &ReportProgress,
    found: &[Choice],
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
    let fits = |choice: &Choice| {
        // a square, because the sampler rounds up to a square
        let side = (seconds / (longer * choice.sample_seconds())).sqrt().round();
        let side = if side.is_finite() { side.clamp(1.0, 32.0) as u32 } else { 1 };
        side * side
    };
    let one = |which: u64, method: Method, samples: u32| {
        let seed = hash(&[settings.seed, index, u64::MAX, which]);
        replicas(subject.scene(method, LARGER * settings.width), samples, 1, seed)
    };
    let truth = one(u64::MAX, subject.best(), TRUE_SAMPLES.min(settings.samples));
    let timed = (0..).zip(subject.methods()).zip(found);
    let timed = timed.map(|((which, method), found)| one(which, method, fits(found)));
    let series: Vec<Series> = timed.chain([truth]).collect();
    let names = found.iter().map(|choice| choice.name.clone()).chain(["many samples".to_owned()]);
    let crop = |(pictures, choice): (Pictures, String)| Crop {
        choice,
        samples: pictures.samples,
        film: pictures.films.into_iter().next().expect("one picture"),
        seconds: pictures.time.cpu,
    };
    let crops = rendered(&series, progress)?.into_iter().zip(names).map(crop).collect();
    Ok(EqualTime { seconds, crops })
}
