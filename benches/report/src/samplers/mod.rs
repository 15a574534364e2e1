//! Page 3: samplers, error against number of samples.

mod drawing;
pub mod integrands;

use std::hint::black_box;

use rayon::prelude::*;
use serde::Serialize;

use self::integrands::{INTEGRANDS, Integrand, Problem};
use super::clock::{Time, medians};
use super::convergence::{counts, slope};
use super::{Findings, Interrupted, Page, ReportProgress, Settings};
use groundtruth::math::{Pcg32, exp, hash, ln};
use groundtruth::samplers::{self, Kind, Purpose, SampleSets, SetKey};

/// Compares samplers by error and time, on integrands whose mean is known.
pub const PAGE: Page = Page {
    name: "samplers",
    title: "Samplers: error against number of samples",
    question: "Which sampler has the smallest error, with how many samples, in how much time?",
    // one for each sampler and number of samples, and one for the times of each integrand
    steps: |settings| {
        (samplers::named().len() * samples(settings).count() + INTEGRANDS.len()) as u64
    },
    measure: |settings, progress| Ok(Findings::new(&measure(settings, progress)?, drawing::page)),
};

/// The data of the page.
#[derive(Serialize)]
struct Data {
    /// The number of pixels over which errors are averaged.
    pixels: u32,
    /// The number of seeds over which errors are averaged.
    seeds: u32,
    integrands: Vec<IntegrandData>,
}

/// One integrand.
#[derive(Serialize)]
struct IntegrandData {
    /// Its name and description.
    #[serde(flatten)]
    integrand: &'static Integrand,
    samplers: Vec<SamplerData>,
}

/// One sampler on one integrand.
#[derive(Serialize)]
struct SamplerData {
    sampler: String,
    /// The errors, by increasing number of samples.
    errors: Vec<Error>,
    /// The time to draw one sample and evaluate the integrand, on one thread.
    sample_seconds: f64,
    /// Whether other programs disturbed the measurement of `sample_seconds`.
    disturbed: bool,
    /// The slope of log error over log samples, from 16 samples on, and its interval of 95 %
    /// confidence; `None` if some error is 0.
    slope: Option<[f64; 3]>,
    /// The number of samples for an error of 1 %, by linear interpolation of the logarithms; `None`
    /// if the largest measured number is not enough.
    samples_for_one_percent: Option<f64>,
}

/// The error for a number of samples.
#[derive(Clone, Copy, Serialize)]
struct Error {
    samples: u32,
    /// The root mean square of `(estimate − exact)/scale`.
    rms: f64,
}

/// The error for which the tables give the number of samples.
const ONE_PERCENT: f64 = 0.01;
/// Slopes are fitted from this number of samples on.
const FITTED_FROM: u32 = 16;

impl SamplerData {
    fn new(sampler: String, errors: Vec<Error>, time: Time) -> Self {
        let far = errors.iter().filter(|e| e.samples >= FITTED_FROM);
        Self {
            sampler,
            sample_seconds: time.cpu,
            disturbed: time.is_disturbed(),
            slope: slope(far.map(|e| (e.samples, e.rms))),
            samples_for_one_percent: samples_for_one_percent(&errors),
            errors,
        }
    }

    /// The error with this number of samples.
    fn error(&self, samples: u32) -> Option<f64> {
        Some(self.errors.iter().find(|e| e.samples == samples)?.rms)
    }
}

/// The number of samples from which on the error is at most 1 %.
fn samples_for_one_percent(errors: &[Error]) -> Option<f64> {
    let last = errors.iter().rposition(|e| e.rms > ONE_PERCENT);
    let Some(before) = last else { return errors.first().map(|e| f64::from(e.samples)) };
    let (a, b) = (errors[before], errors.get(before + 1)?);
    if b.rms == 0.0 {
        return Some(f64::from(b.samples));
    }
    let [(x_a, y_a), (x_b, y_b)] = [a, *b].map(|e| (ln(f64::from(e.samples)), ln(e.rms)));
    let t = (y_a - ln(ONE_PERCENT)) / (y_a - y_b);
    Some(exp(x_a + t * (x_b - x_a)))
}

/// The numbers of samples per pixel: at least 1 and 4.
fn samples(settings: &Settings) -> impl Iterator<Item = u32> {
    counts(settings.samples.max(4))
}

/// A problem of each integrand for each pixel.
pub type Problems = Vec<Vec<Problem>>;

fn measure(settings: &Settings, progress: &ReportProgress) -> Result<Data, Interrupted> {
    let problem = |integrand: &Integrand, pixel: u32| {
        (integrand.problem)(&mut Pcg32::new(hash(&[settings.seed, pixel.into()]), 1))
    };
    let problems: Problems = INTEGRANDS
        .iter()
        .map(|integrand| (0..settings.pixels).map(|pixel| problem(integrand, pixel)).collect())
        .collect();
    let samplers = samplers::named();
    // for each sampler: the numbers of samples, and the error of each integrand
    let mut errors: Vec<Vec<(u32, Vec<f64>)>> = Vec::new();
    for (_, kind) in &samplers {
        let error = |n| {
            let found = rms_errors(kind, n, &problems, settings);
            progress.step().map(|()| (n, found))
        };
        errors.push(samples(settings).map(error).collect::<Result<_, _>>()?);
    }
    let timed = settings.samples.min(256);
    let all: Vec<SampleSets> =
        samplers.iter().map(|(_, kind)| sets(kind, timed, settings.seed)).collect();
    let of_integrand = |(i, integrand): (usize, &'static Integrand)| {
        let times = sample_times(integrand, &problems[i], &all, settings.seed);
        let samplers = samplers.iter().zip(&errors).zip(times);
        let samplers = samplers.map(|(((name, _), errors), time)| {
            let errors =
                errors.iter().map(|(samples, rms)| Error { samples: *samples, rms: rms[i] });
            SamplerData::new(name.clone(), errors.collect(), time)
        });
        let samplers = samplers.collect();
        progress.step().map(|()| IntegrandData { integrand, samplers })
    };
    let integrands = INTEGRANDS.iter().enumerate().map(of_integrand).collect::<Result<_, _>>()?;
    Ok(Data { pixels: settings.pixels, seeds: settings.seeds, integrands })
}

fn sets(kind: &Kind, n: u32, seed: u64) -> SampleSets {
    let sampler = kind.build(&mut ()).expect("specimens are valid");
    SampleSets::new(&*sampler, n, seed)
}

/// The root mean square error of each integrand with `n` samples, over pixels and seeds.
pub fn rms_errors(kind: &Kind, n: u32, problems: &Problems, settings: &Settings) -> Vec<f64> {
    let of_seed = |seed: u64| -> Vec<f64> {
        let sets = sets(kind, n, seed);
        let squares = |(integrand, problems): (&Integrand, &Vec<Problem>)| {
            let error = |(pixel, problem): (u32, &Problem)| {
                let mean = sum(integrand, problem, &sets, seed, pixel) / f64::from(sets.per_set());
                (mean - problem.exact) / problem.scale
            };
            (0..).zip(problems).map(error).map(|e| e * e).sum()
        };
        INTEGRANDS.iter().zip(problems).map(squares).collect()
    };
    // in the order of the seeds, so that the sum does not depend on the number of threads
    let seeds: Vec<Vec<f64>> = (0..u64::from(settings.seeds))
        .into_par_iter()
        .map(|i| of_seed(hash(&[settings.seed, i])))
        .collect();
    let count = f64::from(settings.seeds) * f64::from(settings.pixels);
    let of_integrand = |i: usize| seeds.iter().map(|squares| squares[i]).sum::<f64>();
    (0..INTEGRANDS.len()).map(|i| (of_integrand(i) / count).sqrt()).collect()
}

/// The sum over the samples of a pixel, drawn as in a renderer.
fn sum(integrand: &Integrand, problem: &Problem, sets: &SampleSets, seed: u64, pixel: u32) -> f64 {
    let key = |purpose| SetKey::new(seed, [pixel, 0], purpose);
    let (film, lens) = (key(Purpose::Pixel), key(Purpose::Lens));
    let value = |i| {
        let lens = if integrand.four_dimensional { sets.draw(lens, i) } else { [0.0; 2] };
        (problem.value)(sets.draw(film, i), lens)
    };
    (0..sets.per_set()).map(value).sum()
}

/// The time for a sample of an integrand by each sampler on one thread: the median of rounds that
/// run all samplers.
fn sample_times(
    integrand: &Integrand,
    problems: &[Problem],
    all: &[SampleSets],
    seed: u64,
) -> Vec<Time> {
    const ROUNDS: usize = 9;
    let job = |sets: &SampleSets| {
        let each = |(pixel, problem)| sum(integrand, problem, sets, seed, pixel);
        black_box((0..).zip(problems).map(each).sum::<f64>());
    };
    let mut jobs: Vec<_> = all.iter().map(|sets| move || job(sets)).collect();
    let mut jobs: Vec<&mut dyn FnMut()> = jobs.iter_mut().map(|job| job as _).collect();
    let of_sample = |(sets, time): (&SampleSets, Time)| {
        let samples = f64::from(sets.per_set()) * problems.len() as f64;
        Time { cpu: time.cpu / samples, wall: time.wall / samples }
    };
    all.iter().zip(medians(ROUNDS, &mut jobs)).map(of_sample).collect()
}
