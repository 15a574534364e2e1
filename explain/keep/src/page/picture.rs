//! The picture of a page, small.

use groundtruth::film::Film;
use groundtruth::render::{self, RaysPerSample, Renderer};
use groundtruth::trace::RayBudget;
use rayon::prelude::*;

/// The largest width and height, in pixels.
const SIDE: u32 = 480;
/// The most rays that it takes, if one sample of each of its pixels takes no more.
const MAX_RAYS: f64 = 6e6;
/// However many rays a pixel takes, the picture's larger side has so many pixels.
const LEAST_SIDE: u32 = 48;
/// The most rays of a sample: the tree of glass in glass may have no end.
const MAX_RAYS_OF_SAMPLE: u64 = 20_000;
/// The most rays that its estimate takes.
const ESTIMATE: u64 = 100_000;

/// A picture of every n-th pixel, so that its sides are at most 480 pixels, perhaps with fewer samples.
#[derive(Clone, Debug)]
pub struct SmallPicture {
    /// Its pixels.
    pub film: Film,
    /// The samples that each pixel is the mean of.
    pub samples: u32,
    /// The samples of a pixel of the whole picture.
    pub of_samples: u32,
}

impl SmallPicture {
    /// Renders it: some seconds, also if single samples are large trees.
    pub fn rendered(renderer: &impl Renderer) -> Self {
        let world = renderer.world();
        let size = world.picture_size();
        let rays = RaysPerSample::measured(world, ESTIMATE).mean.max(1.0);
        let whole = rays * f64::from(size[0]) * f64::from(size[1]);
        // the cast saturates
        let affordable = (whole / MAX_RAYS).sqrt().ceil() as u32;
        let step = step(size).max(affordable.min(size[0].max(size[1]) / LEAST_SIDE));
        let [width, height] = size.map(|side| side.div_ceil(step));
        let of_samples = world.samples_per_pixel();
        let affordable = MAX_RAYS / (rays * f64::from(width) * f64::from(height));
        // the cast saturates
        let samples = (affordable as u32).clamp(1, of_samples);
        let color = |index: u32| {
            let pixel = [step * (index % width), step * (index / width)];
            let sample = |sample| {
                let budget = &mut RayBudget::up_to(MAX_RAYS_OF_SAMPLE);
                renderer.sample(pixel, sample, &mut (), budget)
            };
            render::expose(world, (0..samples).map(sample))
        };
        let colors: Vec<_> = (0..width * height).into_par_iter().map(color).collect();
        let mut film = Film::new(width, height);
        for (index, color) in (0..).zip(colors) {
            film.set([index % width, index / width], color);
        }
        Self { film, samples, of_samples }
    }

    /// Takes it from a whole picture.
    pub fn of(whole: &Film, of_samples: u32) -> Self {
        let size = [whole.width(), whole.height()];
        let step = step(size);
        let [width, height] = size.map(|side| side.div_ceil(step));
        let mut film = Film::new(width, height);
        for y in 0..height {
            for x in 0..width {
                film.set([x, y], whole.get([step * x, step * y]));
            }
        }
        Self { film, samples: of_samples, of_samples }
    }
}

/// Every so many pixels of a picture are shown.
fn step(size: [u32; 2]) -> u32 {
    size[0].max(size[1]).div_ceil(SIDE).max(1)
}
