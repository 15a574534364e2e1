//! Estimates judged by replicas: the same view, computed repeatedly with independent random choices.

use groundtruth::samplers;

use super::stage::{built, ray};
use super::statistics::moments;
use crate::prelude::*;

/// The number of independently seeded replicas: more than the 16 that a t test of nearly normal values needs.
pub const REPLICAS: u64 = 24;

/// The probability that any of the means of one law raises a false alarm, for seeds chosen at
/// random.
pub const LEVEL: f64 = 1e-6;

/// The relative error of an estimate without variance is rounding only: some hundred products and sums.
const ROUNDING: f64 = 5e-13;

/// Gives each pixel so many multi-jittered samples.
pub fn with_samples(mut scene: Scene, samples: u32) -> Scene {
    scene.image.samples = samples;
    scene.image.sampler = Some(samplers::MultiJittered {}.into());
    scene
}

/// The radiance along a ray: the mean over a pixel's samples.
pub fn view(world: &World, origin: Point, direction: Vector) -> Rgb {
    let n = world.samples_per_pixel();
    let ray = ray(origin, direction);
    let sample = |i| radiance(world, &ray, world.draws([0, 0], i), &mut ());
    groundtruth::render::mean((0..n).map(sample))
}

/// A quantity of the scene, once for each replica.
pub fn replicas<T>(scene: &Scene, of: impl Fn(&World) -> T) -> Vec<T> {
    let mut world = built(scene);
    let mut one = |seed| {
        world.reseed(2007 + seed);
        of(&world)
    };
    (0..REPLICAS).map(&mut one).collect()
}

/// The seeds over which [`variance`] is taken, and how far from the true one it may be, as a share of that: five standard
/// deviations `√(2/n)` of the variance of so many nearly normal values.
const SEEDS: u64 = 2048;
pub const VARIANCE_ERROR: f64 = 5.0 * 0.03125;

/// The variance of a quantity of the scene, with so many samples per pixel of this sampler.
pub fn variance(
    scene: &Scene,
    sampler: impl Into<samplers::Kind>,
    samples: u32,
    of: impl Fn(&World) -> f64,
) -> f64 {
    let mut scene = scene.clone();
    (scene.image.samples, scene.image.sampler) = (samples, Some(sampler.into()));
    let mut world = built(&scene);
    let one = |seed| {
        world.reseed(seed);
        of(&world)
    };
    moments(&(0..SEEDS).map(one).collect::<Vec<_>>()).1
}

/// The mean of the values, and its standard error as estimated by them.
pub fn mean_and_error(values: &[f64]) -> (f64, f64) {
    let (mean, variance) = moments(values);
    (mean, (variance / values.len() as f64).sqrt())
}

/// Fails if the mean of the values is too imprecise for a useful test: its standard error is above `power`
/// times the mean.
pub fn assert_known(what: &str, values: &[f64], power: f64) {
    let (mean, error) = mean_and_error(values);
    assert!(error <= power * mean.abs(), "{what}: the mean {mean} is known to {error:e} only");
}

/// Fails if the means of two sets of replicas differ significantly, as one of so many tests (Welch's t).
pub fn assert_agree(what: &str, a: &[f64], b: &[f64], tests: usize) {
    let p = means::two_samples(a, b);
    let [(a, e), (b, f)] = [a, b].map(mean_and_error);
    assert!(p > sidak(LEVEL, tests), "{what}: {a} ± {e:e} and {b} ± {f:e}, p = {p:e}");
}

/// Fails if the mean of the values differs significantly from what is expected, as one of so many tests; or
/// if it is too imprecise to judge: its standard error is above `power` times the expected value.
pub fn assert_mean(what: &str, values: &[f64], expected: f64, tests: usize, power: f64) {
    let (mean, error) = mean_and_error(values);
    let apart = (mean - expected).abs();
    if error <= ROUNDING * mean.abs() {
        assert!(
            apart <= 2.0 * ROUNDING * expected.abs(),
            "{what}: every replica gives {mean}, expected {expected}: {apart:e} apart"
        );
        return;
    }
    let p = means::one_sample(values, expected);
    assert!(
        p > sidak(LEVEL, tests),
        "{what}: the mean is {mean} ± {error:e}, expected {expected}: {:.1} standard errors apart, \
         p = {p:e}",
        apart / error
    );
    assert!(
        error <= power * expected.abs(),
        "{what}: the mean {mean} is known to {error:e} only, too imprecise to judge {expected}"
    );
}

/// Like [`assert_mean`], in each channel.
pub fn assert_color(what: &str, values: &[Rgb], expected: Rgb, tests: usize, power: f64) {
    for (channel, expected) in expected.to_array().into_iter().enumerate() {
        let values: Vec<f64> = values.iter().map(|value| value.to_array()[channel]).collect();
        assert_mean(&format!("{what}, channel {channel}"), &values, expected, 3 * tests, power);
    }
}
