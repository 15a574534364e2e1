//! Pixels in which all our replicas agree, and another correct picture need not: on an edge, a rounding error decides;
//! and samples that differ may have the same mean in each of our stratified sets.

use groundtruth::film::Film;
use groundtruth::render;
use groundtruth::rgb::Rgb;
use groundtruth::trace;
use groundtruth::world::World;
use rayon::prelude::*;

use super::stored::Stored;

/// How far the rays of a renderer may be from ours by its rounding: so far our rays are moved, in pixels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RayTolerance(f64);

impl RayTolerance {
    /// Of double precision.
    pub const DOUBLE: Self = Self(1e-6);
    /// Of single precision: hits are wrong by about 1e-7 of their coordinates, and shadow rays start off the surface by
    /// 1e-4 of them.
    pub const SINGLE: Self = Self(0.03);
}

/// What says whether pictures of ours could have a picture's value in a pixel.
#[derive(Clone, Copy)]
pub struct Exclusion<'a> {
    /// The scene's world.
    pub world: &'a World,
    /// How values are stored.
    pub stored: Stored,
    /// How far the other renderer's rays may be from ours.
    pub tolerance: RayTolerance,
}

impl Exclusion<'_> {
    /// Where all replicas agree against a picture and need not, `theirs` gets our value, so that it does not count. Returns
    /// these pixels: those in which pictures of ours could have the picture's value,
    /// - because each ray is moved by the rounding of a renderer, or
    /// - because the samples of the pixel have other weights: in each of our stratified sets they have the same mean, in
    ///   others any mean from the least to the largest of them.
    pub fn exclude(&self, theirs: &mut [f32], known: &[Vec<f32>]) -> Vec<usize> {
        let (alone, is_fixed) = self.alone(theirs, known);
        let is_possible = |pixel: &usize| self.is_possible(theirs, *pixel, is_fixed);
        let excluded: Vec<usize> = alone.into_par_iter().filter(is_possible).collect();
        for pixel in &excluded {
            theirs[3 * pixel..3 * pixel + 3].copy_from_slice(&known[0][3 * pixel..3 * pixel + 3]);
        }
        excluded
    }

    /// Whether all replicas are one picture, and theirs has a value that it cannot have.
    pub(super) fn is_unlike_fixed(&self, theirs: &[f32], known: &[Vec<f32>]) -> bool {
        let (alone, is_fixed) = self.alone(theirs, known);
        is_fixed && alone.into_par_iter().any(|pixel| !self.is_possible(theirs, pixel, is_fixed))
    }

    /// The pixels in which all replicas agree against a picture, and whether they agree everywhere.
    fn alone(&self, theirs: &[f32], known: &[Vec<f32>]) -> (Vec<usize>, bool) {
        let ours = &known[0];
        let is_same = |x: f32, y: f32| {
            let [x, y] = [x, y].map(f64::from);
            (x - y).abs() <= self.stored.tolerance(x)
        };
        let is_agreed = |at: usize| known.iter().all(|it| is_same(ours[at], it[at]));
        let differs = |at: usize| !is_same(ours[at], theirs[at]) && is_agreed(at);
        let is_alone = |pixel: &usize| (3 * pixel..3 * pixel + 3).any(differs);
        let alone = (0..theirs.len() / 3).filter(is_alone).collect();
        (alone, (0..ours.len()).all(is_agreed))
    }

    /// Whether a picture of ours could have their value.
    fn is_possible(&self, theirs: &[f32], pixel: usize, is_fixed: bool) -> bool {
        let Self { world, stored, tolerance } = *self;
        let width = world.picture_size()[0] as usize;
        let at = [pixel % width, pixel / width].map(|x| x as u32);
        let is_taken = |range: Range| range.takes(&theirs[3 * pixel..][..3], world, stored);
        is_taken(Range::of_moved(world, at, tolerance))
            || !is_fixed && is_taken(Range::of_samples(world, at))
    }
}

/// The least and the largest colour that a pixel of ours can have, channel by channel, before exposure.
struct Range([Rgb; 2]);

impl Range {
    /// If each ray through the pixel is moved by itself, by the width of an edge in one of eight directions or not at
    /// all: on which side of an edge it falls, a renderer's rounding decides.
    fn of_moved(world: &World, pixel: [u32; 2], tolerance: RayTolerance) -> Self {
        let steps = [-1.0, 0.0, 1.0].into_iter().flat_map(|x| [-1.0, 0.0, 1.0].map(|y| [x, y]));
        let moved: Vec<[f64; 2]> = steps.map(|step| step.map(|x| x * tolerance.0)).collect();
        let of_sample =
            |index| Self::around(moved.iter().map(|by| sample_moved(world, pixel, index, *by)));
        let each: Vec<Self> = (0..world.samples_per_pixel()).map(of_sample).collect();
        Self([0, 1].map(|end| render::mean(each.iter().map(|range| range.0[end]))))
    }

    /// If its samples have any weights.
    fn of_samples(world: &World, pixel: [u32; 2]) -> Self {
        let samples = 0..world.samples_per_pixel();
        Self::around(samples.map(|index| sample_moved(world, pixel, index, [0.0; 2])))
    }

    fn around(colors: impl Iterator<Item = Rgb>) -> Self {
        let (mut least, mut largest) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
        for color in colors {
            for (channel, value) in color.to_array().into_iter().enumerate() {
                least[channel] = least[channel].min(value);
                largest[channel] = largest[channel].max(value);
            }
        }
        Self([least, largest].map(|[r, g, b]| Rgb::new(r, g, b)))
    }

    /// Whether all stored values of a pixel lie within, but for rounding.
    fn takes(&self, theirs: &[f32], world: &World, stored: Stored) -> bool {
        let [least, largest] = self.0.map(|color| {
            let mut film = Film::new(1, 1);
            film.set([0, 0], render::expose(world, std::iter::once(color)));
            stored.values(&film)
        });
        theirs.iter().enumerate().all(|(channel, theirs)| {
            // a rule for colours beyond 1 may exchange the two
            let ends = [least[channel], largest[channel]].map(f64::from);
            let (low, high) = (ends[0].min(ends[1]), ends[0].max(ends[1]));
            let theirs = f64::from(*theirs);
            low - stored.tolerance(low) <= theirs && theirs <= high + stored.tolerance(high)
        })
    }
}

/// The radiance of a sample of a pixel, with its film point moved by so many pixels.
fn sample_moved(world: &World, pixel: [u32; 2], index: u32, [dx, dy]: [f64; 2]) -> Rgb {
    let size = world.image.pixel_size;
    let Some((eye, _)) = world.view.eye_of_column(pixel[0], world.image.width) else {
        return Rgb::BLACK;
    };
    let Some(sample) = render::camera_sample(world, pixel, index) else { return Rgb::BLACK };
    let film = [sample.film[0] + dx * size, sample.film[1] + dy * size];
    let draws = world.draws(sample.pixel, index);
    match eye.ray(film, sample.lens.unwrap_or_default()) {
        Some(ray) => sample.weight * trace::radiance(world, &ray, draws, &mut ()),
        None => Rgb::BLACK,
    }
}
