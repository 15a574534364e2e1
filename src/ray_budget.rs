//! How many rays a picture takes, before it is rendered: measured on some of its samples, as it depends on
//! what is seen. Glass at depth 100 may be a line of rays, or a tree of 2¹⁰⁰.

use crate::math::{Pcg32, Ray};
use crate::render;
use crate::rgb::Rgb;
use crate::trace::{Outcome, RayKind, Recorder, Term};
use crate::world::{Hit, World};

/// So many pixels are tried, one sample of each.
const PIXELS: u32 = 256;
/// When so many rays are counted, measuring ends.
pub const MOST_COUNTED: u64 = 1_000_000;

/// An estimate of the rays of a sample, shadow rays among them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RaysPerSample {
    /// The mean of the samples that were tried.
    pub mean: f64,
    /// Whether there would have been more: measuring ended before its last sample did.
    pub is_cut: bool,
}

/// A picture of more rays than this takes so long that one wants to know.
const MANY: f64 = 1e9;

impl RaysPerSample {
    /// What to tell before so many samples are rendered, if they are many rays.
    pub fn note(&self, samples: f64) -> Option<String> {
        let about = if self.is_cut { "at least" } else { "about" };
        let rays = self.mean * samples;
        (rays > MANY).then(|| format!("this will take {about} {rays:.0e} rays"))
    }
}

/// Counts the rays of samples, up to a number.
#[derive(Debug)]
pub struct RayCounter {
    rays: u64,
    most: u64,
    samples: u32,
}

impl RayCounter {
    /// Counts up to `most` rays, at most [`MOST_COUNTED`].
    pub fn up_to(most: u64) -> Self {
        Self { rays: 0, most: most.min(MOST_COUNTED), samples: 0 }
    }

    /// Counts those of a sample.
    pub fn count(&mut self, sample: impl FnOnce(&mut Self) -> Rgb) {
        self.samples += 1;
        let _ = sample(self);
    }

    /// What was counted.
    pub fn rays(&self) -> u64 {
        self.rays
    }

    /// The mean of the samples.
    pub fn estimate(&self) -> RaysPerSample {
        let mean = self.rays as f64 / f64::from(self.samples.max(1));
        RaysPerSample { mean, is_cut: self.is_full() }
    }
}

/// Measures a world's pictures: one sample each of some of its pixels.
pub fn measured(world: &World, most: u64) -> RaysPerSample {
    let mut random = Pcg32::new(world.seed, u64::from(PIXELS));
    let [width, height] = world.picture_size();
    let mut counter = RayCounter::up_to(most);
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
