//! Estimates the number of rays of a picture before it is rendered, by tracing some of its samples: glass
//! at depth 100 may be a line of rays, or a tree of 2¹⁰⁰.

use crate::math::{Pcg32, Ray};
use crate::render;
use crate::rgb::Rgb;
use crate::trace::{Outcome, RayKind, Recorder, Term};
use crate::world::{Hit, World};

/// The number of pixels that are tried, with one sample each.
const PIXELS: u32 = 256;
/// Measuring ends at this number of rays.
pub const MAX_COUNTED: u64 = 1_000_000;

/// A sample of so many rays, cut off, is one of a tree that may have no end.
const ENDLESS: u64 = MAX_COUNTED / 2;

/// An estimate of the rays of a sample, shadow rays among them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RaysPerSample {
    /// The mean of the samples that were tried.
    pub mean: f64,
    /// Whether measuring ended within a sample, so that the mean is too low.
    pub is_cut: bool,
    /// Whether measuring ended in a sample that alone has so many rays that its tree may have no end.
    pub is_endless: bool,
}

/// A picture of more rays than this takes so long that the user is told.
const MANY: f64 = 1e9;

impl RaysPerSample {
    /// A note for the user before `samples` samples are rendered, if they are many rays or a tree has no end.
    pub fn note(&self, samples: f64) -> Option<String> {
        let about = if self.is_cut { "at least" } else { "about" };
        let rays = self.mean * samples;
        (rays > MANY || self.is_endless).then(|| format!("this will take {about} {rays:.0e} rays"))
    }
}

/// Counts the rays of samples, up to a number.
#[derive(Debug)]
pub struct RayCounter {
    rays: u64,
    most: u64,
    samples: u32,
    /// The number of rays before the last sample.
    before: u64,
}

impl RayCounter {
    /// Counts up to `most` rays.
    pub fn up_to(most: u64) -> Self {
        Self { rays: 0, most, samples: 0, before: 0 }
    }

    /// Counts the rays of a sample.
    pub fn count(&mut self, sample: impl FnOnce(&mut Self) -> Rgb) {
        self.samples += 1;
        self.before = self.rays;
        let _ = sample(self);
    }

    /// The number of rays counted.
    pub fn rays(&self) -> u64 {
        self.rays
    }

    /// The mean of the samples.
    pub fn estimate(&self) -> RaysPerSample {
        let mean = self.rays as f64 / f64::from(self.samples.max(1));
        let is_endless = self.is_full() && self.rays - self.before >= ENDLESS;
        RaysPerSample { mean, is_cut: self.is_full(), is_endless }
    }
}

/// Traces one sample in each of some of a world's pixels, up to `most` rays, at most [`MAX_COUNTED`].
pub fn measured(world: &World, most: u64) -> RaysPerSample {
    let mut random = Pcg32::new(world.seed, u64::from(PIXELS));
    let [width, height] = world.picture_size();
    let mut counter = RayCounter::up_to(most.min(MAX_COUNTED));
    for _ in 0..PIXELS {
        let pixel = [random.below(width), random.below(height)];
        let index = random.below(world.samples_per_pixel());
        counter.count(|counter| render::sample(world, pixel, index, counter));
        if counter.is_full() {
            break;
        }
    }
    counter.estimate()
}

impl Recorder for RayCounter {
    fn enter(&mut self, _: RayKind, _: &Ray, _: u32, _: Rgb) {
        self.rays += 1;
    }

    fn is_full(&self) -> bool {
        self.rays >= self.most
    }

    fn outcome(&mut self, _: Outcome<&Hit<'_>>) {}
    fn term(&mut self, _: Term) {}
    fn leave(&mut self, _: Rgb, _: Rgb) {}
}
