//! Estimates the number of rays of a picture before it is rendered, by tracing some of its samples.

use super::Renderer;
use crate::math::Pcg32;
use crate::trace::RayBudget;
use crate::world::World;

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
    /// Whether measuring ended in a sample that alone has so many rays that its tree may have no
    /// end.
    pub is_endless: bool,
}

/// A picture of more rays than this takes so long that the user is told.
const MANY: f64 = 1e9;

impl RaysPerSample {
    /// A note for the user before `samples` samples are rendered, if they are many rays or a tree
    /// has no end.
    pub fn note(&self, samples: f64) -> Option<String> {
        let about = if self.is_cut { "at least" } else { "about" };
        let rays = self.mean * samples;
        (rays > MANY || self.is_endless).then(|| format!("this will take {about} {rays:.0e} rays"))
    }

    /// Traces one sample in each of some of a world's pixels, up to `most` rays, at most
    /// [`MAX_COUNTED`].
    pub fn measured(world: &World, most: u64) -> Self {
        let mut random = Pcg32::new(world.seed, u64::from(PIXELS));
        let [width, height] = world.picture_size();
        let mut budget = RayBudget::up_to(most.min(MAX_COUNTED));
        let (mut samples, mut of_last) = (0, 0);
        while samples < PIXELS && !budget.is_exceeded() {
            let pixel = [random.below(width), random.below(height)];
            let index = random.below(world.samples_per_pixel());
            let before = budget.spent();
            world.sample(pixel, index, &mut (), &mut budget);
            (samples, of_last) = (samples + 1, budget.spent() - before);
        }
        let mean = budget.spent() as f64 / f64::from(samples.max(1));
        let is_cut = budget.is_exceeded();
        Self { mean, is_cut, is_endless: is_cut && of_last >= ENDLESS }
    }
}
