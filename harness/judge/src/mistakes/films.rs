//! The pictures of a world without a mistake and with each of several, in one pass.

use groundtruth::film::Film;
use groundtruth::render::{self, CameraSample};
use groundtruth::rgb::Rgb;
use groundtruth::trace;
use groundtruth::world::World;
use rayon::prelude::*;

use super::Mistake;
use super::recorder::Reweighing;

/// The pictures of a world: ours, and those of programs with mistakes.
#[derive(Clone, Debug)]
pub struct Films {
    /// Without a mistake: the picture of `render::render`, bit for bit.
    pub ours: Film,
    /// Those of the mistakes that change it.
    pub altered: Vec<(&'static Mistake, Film)>,
    /// The mistakes that change no bit of it.
    pub unchanged: Vec<&'static Mistake>,
}

/// So many rows are rendered before they are copied to their pictures.
const ROWS: usize = 32;

/// Renders the picture of a world, and that of each of the mistakes that only change terms, with the same random
/// numbers. Each picture takes 24 bytes a pixel.
pub fn films(world: &World, mistakes: &[&'static Mistake]) -> Films {
    let mistakes: Vec<&Mistake> =
        mistakes.iter().copied().filter(|mistake| mistake.is_reweighed()).collect();
    let [width, height] = world.picture_size();
    let mut ours = Film::new(width, height);
    let mut altered = vec![(Film::new(width, height), false); mistakes.len()];
    for first in (0..height).step_by(ROWS) {
        let rows = first..height.min(first + ROWS as u32);
        let pixels: Vec<([u32; 2], Vec<Rgb>)> = rows
            .into_par_iter()
            .flat_map_iter(|row| row_of_pixels(world, &mistakes, row))
            .collect();
        for (at, colors) in pixels {
            ours.set(at, colors[0]);
            for ((film, is_changed), color) in altered.iter_mut().zip(&colors[1..]) {
                film.set(at, *color);
                *is_changed |= bits(*color) != bits(colors[0]);
            }
        }
    }
    let mut films = Films { ours, altered: Vec::new(), unchanged: Vec::new() };
    for (mistake, (film, is_changed)) in mistakes.into_iter().zip(altered) {
        match is_changed {
            true => films.altered.push((mistake, film)),
            false => films.unchanged.push(mistake),
        }
    }
    films
}

fn bits(color: Rgb) -> [u64; 3] {
    color.to_array().map(f64::to_bits)
}

/// The pixels of a row, each without a mistake and with each.
fn row_of_pixels(
    world: &World,
    mistakes: &[&'static Mistake],
    row: u32,
) -> Vec<([u32; 2], Vec<Rgb>)> {
    let mut recorder = Reweighing::new(world, mistakes);
    let columns = 0..world.picture_size()[0];
    columns.map(|column| [column, row]).map(|at| (at, pixel(world, &mut recorder, at))).collect()
}

/// The exposed value of a pixel, without a mistake and with each of the recorder's.
pub fn pixel(world: &World, recorder: &mut Reweighing<'_>, at: [u32; 2]) -> Vec<Rgb> {
    let count = world.samples_per_pixel();
    let samples: Vec<Vec<Rgb>> = (0..count)
        .map(|index| {
            recorder.begin(count > 1 && index + 1 == count);
            sample(world, recorder, at, index)
        })
        .collect();
    let of = |mistake: usize| samples.iter().map(move |sample| sample[mistake]);
    (0..recorder.radiance().len()).map(|mistake| render::expose(world, of(mistake))).collect()
}

/// As [`render::sample`], without a mistake and with each.
fn sample(world: &World, recorder: &mut Reweighing<'_>, at: [u32; 2], index: u32) -> Vec<Rgb> {
    let mut weight = 1.0;
    if let Some(CameraSample { pixel, weight: its, ray: Some(ray), .. }) =
        render::camera_sample(world, at, index)
    {
        weight = its;
        trace::radiance(world, &ray, world.draws(pixel, index), recorder);
    }
    recorder.radiance().iter().map(|radiance| weight * *radiance).collect()
}
