//! From a world to pixels.
//!
//! A sample is a pure function of world (with its seed), pixel and index: a whole picture, one
//! pixel of it, and any number of threads agree bit for bit. Users count pixels from the top left;
//! the book's rows count up, only here.

mod canvas;
mod estimate;
mod watched;

use std::sync::atomic::{AtomicBool, Ordering};

use crate::film::Film;
use crate::math::{Ray, maps};
use crate::rgb::Rgb;
use crate::samplers::{Draws, Purpose};
use crate::scene::Image;
use crate::trace::{self, Budget, Recorder, Unlimited, UntilStopped};
use crate::world::World;

pub use canvas::{Canvas, Crop, Partial, Pause};
pub use estimate::{MAX_COUNTED, RaysPerSample};
pub use watched::watched;

/// The result of filter and camera for one pixel sample.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CameraSample {
    /// The pixel of its eye's image: for all but stereo pairs, that of the picture.
    pub pixel: [u32; 2],
    /// The point on the film, in world units from its centre.
    pub film: [f64; 2],
    /// The point on the lens, in the unit disk; `None` if the camera has no lens.
    pub lens: Option<[f64; 2]>,
    /// The factor of its radiance, from the filter.
    pub weight: f64,
    /// Its ray, with a unit direction; `None` where the camera sees nothing, and the picture is
    /// black.
    pub ray: Option<Ray>,
}

/// The camera ray of one pixel sample; `None` in the gap of a stereo pair. Both eyes of a pair draw
/// the same samples, because these belong to the pixel of the eye's image.
pub fn camera_sample(world: &World, pixel: [u32; 2], index: u32) -> Option<CameraSample> {
    camera_sample_and_draws(world, pixel, index).map(|(sample, _)| sample)
}

/// As [`camera_sample`], with the sample's draws, whose name is hashed once.
#[inline]
fn camera_sample_and_draws(
    world: &World,
    [column, row]: [u32; 2],
    index: u32,
) -> Option<(CameraSample, Draws<'_>)> {
    let (eye, column) = world.view.eye_of_column(column, world.image.width)?;
    let pixel = [column, row];
    let draws = world.draws(pixel, index);
    let [(x, weight_x), (y, weight_y)] = draws.draw(Purpose::Pixel).map(|u| world.filter.draw(u));
    let film = film_point(&world.image, pixel, [x, y]);
    let lens = world.view.has_lens().then(|| maps::disk(draws.draw(Purpose::Lens)));
    let ray = eye.ray(film, lens.unwrap_or_default());
    Some((CameraSample { pixel, film, lens, weight: weight_x * weight_y, ray }, draws))
}

/// The point of the view plane for a point in or around a pixel, given in pixels from the pixel's
/// lower left corner.
pub fn film_point(image: &Image, pixel: [u32; 2], [sx, sy]: [f64; 2]) -> [f64; 2] {
    let (column, row) = (f64::from(pixel[0]), f64::from(image.height - 1 - pixel[1]));
    // half as a real number: an integer half would shift pictures of odd size
    let x = image.pixel_size * (column - 0.5 * f64::from(image.width) + sx);
    let y = image.pixel_size * (row - 0.5 * f64::from(image.height) + sy);
    [x, y]
}

/// The point in the image of an eye for a point of the view plane, in pixels from the top left
/// corner, x right, y down: the centre of the pixel [0, 0] is [0.5, 0.5].
pub fn image_point(image: &Image, [x, y]: [f64; 2]) -> [f64; 2] {
    let [width, height] = [image.width, image.height].map(f64::from);
    [0.5 * width + x / image.pixel_size, 0.5 * height - y / image.pixel_size]
}

/// The radiance of one sample of one pixel (x right, y down, from 0 at the top left), weighed by
/// the filter.
pub fn sample<R: Recorder>(world: &World, pixel: [u32; 2], index: u32, recorder: &mut R) -> Rgb {
    world.sample(pixel, index, recorder, &mut Unlimited)
}

/// What finds the radiance of samples: a world, or what stands before one and alters what it finds.
pub trait Renderer: Sync {
    /// The world.
    fn world(&self) -> &World;

    /// The radiance that arrives along a camera's ray, with the draws of its sample.
    fn radiance<R: Recorder, B: Budget>(
        &self,
        ray: &Ray,
        draws: Draws<'_>,
        recorder: &mut R,
        budget: &mut B,
    ) -> Rgb;

    /// The radiance of one sample, as [`sample`], within a budget of rays; those beyond it are
    /// black.
    fn sample<R: Recorder, B: Budget>(
        &self,
        pixel: [u32; 2],
        index: u32,
        recorder: &mut R,
        budget: &mut B,
    ) -> Rgb {
        match camera_sample_and_draws(self.world(), pixel, index) {
            Some((CameraSample { weight, ray: Some(ray), .. }, draws)) => {
                weight * self.radiance(&ray, draws, recorder, budget)
            }
            _ => Rgb::BLACK,
        }
    }

    /// A pixel: the mean of its samples times the exposure time; `None` if it was stopped.
    fn pixel(&self, at: [u32; 2], stop: &AtomicBool) -> Option<Rgb> {
        mean_of_samples(self, at, stop)
    }
}

impl Renderer for World {
    fn world(&self) -> &World {
        self
    }

    fn radiance<R: Recorder, B: Budget>(
        &self,
        ray: &Ray,
        draws: Draws<'_>,
        recorder: &mut R,
        budget: &mut B,
    ) -> Rgb {
        trace::radiance_within(self, ray, draws, recorder, budget)
    }

    /// The same, but not generic: compiled once, beside the small functions it calls, instead of in
    /// each program that renders.
    fn pixel(&self, at: [u32; 2], stop: &AtomicBool) -> Option<Rgb> {
        mean_of_samples(self, at, stop)
    }
}

fn mean_of_samples(
    renderer: &(impl Renderer + ?Sized),
    at: [u32; 2],
    stop: &AtomicBool,
) -> Option<Rgb> {
    let world = renderer.world();
    let samples = (0..world.samples_per_pixel())
        .map(|index| renderer.sample(at, index, &mut (), &mut UntilStopped(stop)));
    let color = expose(world, samples);
    (!stop.load(Ordering::Relaxed)).then_some(color)
}

/// A pixel: the mean of its samples times the exposure time.
pub fn pixel(renderer: &impl Renderer, at: [u32; 2]) -> Rgb {
    renderer.pixel(at, &AtomicBool::new(false)).expect("nothing stops it")
}

/// The mean of the samples of a pixel, in their order, times the exposure time.
pub fn expose(world: &World, samples: impl Iterator<Item = Rgb>) -> Rgb {
    world.view.exposure_time * mean(samples)
}

/// The mean, by compensated summation (Neumaier 1974), whose error does not grow with their number.
pub fn mean(samples: impl Iterator<Item = Rgb>) -> Rgb {
    let (mut sums, mut errors, mut count) = ([0.0_f64; 3], [0.0; 3], 0_u32);
    for sample in samples {
        count += 1;
        for (channel, value) in sample.to_array().into_iter().enumerate() {
            let (sum, error) = (&mut sums[channel], &mut errors[channel]);
            let next = *sum + value;
            *error += if sum.abs() >= value.abs() {
                (*sum - next) + value
            } else {
                (value - next) + *sum
            };
            *sum = next;
        }
    }
    let total = |i: usize| (sums[i] + errors[i]) / f64::from(count);
    Rgb::new(total(0), total(1), total(2))
}

/// Renders a whole picture on the current rayon pool.
pub fn render(renderer: &impl Renderer) -> Film {
    let canvas = Canvas::new(renderer.world());
    canvas.render(renderer);
    canvas.film()
}

/// The images of the left and the right eye of a whole picture of a stereo pair; `None` if the
/// world has one eye, or the film is not its whole picture.
pub fn eye_images(world: &World, film: &Film) -> Option<[Film; 2]> {
    let first_columns = world.view.stereo()?.first_columns(world.image.width);
    let whole = [film.width(), film.height()] == world.picture_size();
    whole.then(|| first_columns.map(|first| film.columns(first, world.image.width)))
}
