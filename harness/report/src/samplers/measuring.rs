//! Measures errors and times.

use rayon::prelude::*;

use super::integrands::{INTEGRANDS, Integrand, Problem};
use super::{Data, Error, IntegrandData, SamplerData};
use crate::clock;
use crate::errors::counts;
use crate::{Interrupted, Progress, Settings};
use groundtruth::math::{Pcg32, hash};
use groundtruth::samplers::{self, Key, Kind, Purpose, SampleSets};

/// The numbers of samples per pixel: at least 1 and 4.
fn samples(settings: &Settings) -> impl Iterator<Item = u32> {
    counts(settings.samples.max(4))
}

/// The number of measurements.
pub(super) fn steps(settings: &Settings) -> u64 {
    (samplers::named().len() * samples(settings).count() + INTEGRANDS.len()) as u64
}

/// A problem of each integrand for each pixel.
pub type Problems = Vec<Vec<Problem>>;

pub(super) fn measure(settings: &Settings, progress: &Progress) -> Result<Data, Interrupted> {
    let problem = |integrand: &Integrand, pixel: u32| {
        (integrand.problem)(&mut Pcg32::new(hash(&[settings.seed, pixel.into()]), 1))
    };
    let problems: Problems = INTEGRANDS
        .iter()
        .map(|integrand| (0..settings.pixels).map(|pixel| problem(integrand, pixel)).collect())
        .collect();
    let empty = |integrand| IntegrandData { integrand, samplers: Vec::new() };
    let mut data: Vec<IntegrandData> = INTEGRANDS.iter().map(empty).collect();
    for (sampler, kind) in samplers::named() {
        let mut errors = vec![Vec::new(); INTEGRANDS.len()];
        for samples in samples(settings) {
            let found = rms_errors(&kind, samples, &problems, settings);
            for (errors, rms) in errors.iter_mut().zip(found) {
                errors.push(Error { samples, rms });
            }
            progress.step()?;
        }
        for (data, errors) in data.iter_mut().zip(errors) {
            data.samplers.push(SamplerData::new(sampler.clone(), errors));
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
        let mut jobs: Vec<&mut dyn FnMut()> = jobs.iter_mut().map(|job| job as _).collect();
        let times = clock::medians(ROUNDS, &mut jobs);
        for ((found, sets), time) in data.samplers.iter_mut().zip(&all).zip(times) {
            found.disturbed = time.is_disturbed();
            found.sample_seconds = time.cpu / (f64::from(sets.per_set()) * problems.len() as f64);
        }
        progress.step()?;
    }
    Ok(())
}
