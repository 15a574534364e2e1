//! Measures errors and times.

use rayon::prelude::*;

use super::integrands::{INTEGRANDS, Integrand, Problem};
use super::{Data, Error, IntegrandData, Interrupted, Progress, SamplerData, Settings};
use crate::clock;
use groundtruth::math::{Pcg32, hash};
use groundtruth::samplers::{self, Key, Kind, Purpose, SampleSets};

/// 1, 4, 16 … up to `max`: squares, and powers of two.
fn counts(max: u32) -> impl Iterator<Item = u32> {
    (0..=8).map(|k| 1_u32 << (2 * k)).filter(move |&n| n <= max.max(4))
}

/// How many steps of progress there are.
pub fn steps(settings: &Settings) -> u64 {
    (samplers::named().len() * counts(settings.samples).count() + INTEGRANDS.len()) as u64
}

/// A problem of each integrand for each pixel.
pub type Problems = Vec<Vec<Problem>>;

/// Measures all of it.
///
/// # Errors
/// [`Interrupted`] by the user.
pub fn measure(settings: &Settings, progress: &Progress) -> Result<Data, Interrupted> {
    let problem = |integrand: &Integrand, pixel: u32| {
        (integrand.problem)(&mut Pcg32::new(hash(&[settings.seed, pixel.into()]), 1))
    };
    let problems: Problems = INTEGRANDS
        .iter()
        .map(|integrand| (0..settings.pixels).map(|pixel| problem(integrand, pixel)).collect())
        .collect();
    let mut data: Vec<IntegrandData> = INTEGRANDS
        .iter()
        .map(|integrand| IntegrandData {
            name: integrand.name.to_owned(),
            about: integrand.about.to_owned(),
            samplers: Vec::new(),
        })
        .collect();
    for (sampler, kind) in samplers::named() {
        let mut errors = vec![Vec::new(); INTEGRANDS.len()];
        for n in counts(settings.samples) {
            for (errors, rms) in errors.iter_mut().zip(rms_errors(&kind, n, &problems, settings)) {
                errors.push(Error { samples: n, rms });
            }
            progress.step()?;
        }
        for (data, errors) in data.iter_mut().zip(errors) {
            let samples_for_one_percent = SamplerData::samples_for_one_percent(&errors);
            let (sampler, sample_seconds) = (sampler.clone(), f64::NAN);
            let mut found = SamplerData {
                sampler,
                errors,
                sample_seconds,
                disturbed: false,
                slope: None,
                samples_for_one_percent,
            };
            found.slope = found.law().map(|l| [l.exponent, l.interval[0], l.interval[1]]);
            data.samplers.push(found);
        }
    }
    time_samples(&mut data, &problems, settings, progress)?;
    Ok(Data { pixels: settings.pixels, seeds: settings.seeds, integrands: data })
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
    let key = |purpose| Key::new(seed, [pixel, 0], purpose);
    let (film, lens) = (key(Purpose::Pixel), key(Purpose::Lens));
    let value = |i| {
        let lens = if integrand.four_dimensional { sets.draw(lens, i) } else { [0.0; 2] };
        (problem.value)(sets.draw(film, i), lens)
    };
    (0..sets.per_set()).map(value).sum()
}

/// Measures the seconds for a sample of each integrand by each sampler on one thread: the median of
/// rounds that run all samplers.
fn time_samples(
    data: &mut [IntegrandData],
    problems: &Problems,
    settings: &Settings,
    progress: &Progress,
) -> Result<(), Interrupted> {
    const ROUNDS: usize = 9;
    let n = settings.samples.min(256);
    let all: Vec<SampleSets> =
        samplers::named().iter().map(|(_, kind)| sets(kind, n, settings.seed)).collect();
    for ((integrand, problems), data) in INTEGRANDS.iter().zip(problems).zip(data) {
        let job = |sets: &SampleSets| {
            let each = |(pixel, problem): (u32, &Problem)| {
                sum(integrand, problem, sets, settings.seed, pixel)
            };
            std::hint::black_box((0..).zip(problems).map(each).sum::<f64>());
        };
        let mut jobs: Vec<_> = all.iter().map(|sets| move || job(sets)).collect();
        let mut all_jobs: Vec<&mut dyn FnMut()> = Vec::new();
        jobs.iter_mut().for_each(|job| all_jobs.push(job));
        let times = clock::medians(ROUNDS, &mut all_jobs);
        for ((found, sets), time) in data.samplers.iter_mut().zip(&all).zip(times) {
            found.disturbed = time.is_disturbed();
            found.sample_seconds = time.cpu / (f64::from(sets.per_set()) * problems.len() as f64);
        }
        progress.step()?;
    }
    Ok(())
}
