//! Pixels in which all our replicas agree, and another correct picture need not: on an edge, a rounding error decides;
//! and samples that differ may have the same mean in each of our stratified sets.

use groundtruth::render;
use groundtruth::rgb::Rgb;
use groundtruth::trace;
use groundtruth::world::World;
use rayon::prelude::*;

use super::stored::Stored;

/// How far the rays of a renderer may be from ours by its rounding.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Edge {
    /// So far our rays are moved, in pixels.
    pub width: f64,
    /// Whether the picture must have a value between those of the moved rays. Else it is enough that these differ, as they
    /// do on an edge alone, where rays move by little.
    pub is_between: bool,
}

impl Edge {
    /// Of double precision.
    pub const DOUBLE: Self = Self { width: 1e-6, is_between: false };
    /// Of single precision: hits are wrong by about 1e-7 of their coordinates, and shadow rays start off the surface by
    /// 1e-4 of them.
    pub const SINGLE: Self = Self { width: 0.03, is_between: true };
}

/// Where all replicas agree against a picture and need not, the picture gets our value. Returns the number of such
/// pixels.
pub fn set_apart(
    theirs: &mut [f32],
    world: &World,
    known: &[Vec<f32>],
    stored: Stored,
    edge: Edge,
) -> usize {
    let width = world.picture_size()[0] as usize;
    let ours = &known[0];
    let is_same = |x: f32, y: f32| {
        let [x, y] = [x, y].map(f64::from);
        (x - y).abs() <= stored.tolerance(x)
    };
    let is_agreed = |at: usize| known.iter().all(|it| is_same(ours[at], it[at]));
    let is_fixed = (0..ours.len()).all(is_agreed);
    let differs = |at: usize| !is_same(ours[at], theirs[at]) && is_agreed(at);
    let apart: Vec<usize> =
        (0..theirs.len() / 3).filter(|pixel| (3 * pixel..3 * pixel + 3).any(differs)).collect();
    let apart: Vec<usize> = apart
        .into_par_iter()
        .filter(|pixel| {
            let at = [pixel % width, pixel / width].map(|x| x as u32);
            is_edge(world, at, (&theirs[3 * pixel..][..3], stored), edge)
                || !is_fixed && samples_differ(world, at, stored)
        })
        .collect();
    for pixel in &apart {
        theirs[3 * pixel..3 * pixel + 3].copy_from_slice(&ours[3 * pixel..3 * pixel + 3]);
    }
    apart.len()
}

/// Whether the samples of a pixel have different colours.
fn samples_differ(world: &World, pixel: [u32; 2], stored: Stored) -> bool {
    let mut samples = (0..world.samples_per_pixel())
        .map(|index| render::sample(world, pixel, index, &mut ()).to_array());
    let first = samples.next().unwrap_or_default();
    samples.any(|sample| {
        sample.into_iter().zip(first).any(|(x, y)| (x - y).abs() > stored.tolerance(y))
    })
}

/// Whether the stored colour of a pixel changes when its rays move, so that it may be `theirs`: on which side of an edge
/// such a pixel falls, a renderer's rounding decides.
fn is_edge(world: &World, pixel: [u32; 2], (theirs, stored): (&[f32], Stored), edge: Edge) -> bool {
    const AROUND: [[f64; 2]; 8] = [
        [-1.0, -1.0],
        [1.0, -1.0],
        [-1.0, 1.0],
        [1.0, 1.0],
        [0.0, 1.0],
        [0.0, -1.0],
        [1.0, 0.0],
        [-1.0, 0.0],
    ];
    let value = |color: Rgb| {
        let mut film = groundtruth::film::Film::new(1, 1);
        film.set([0, 0], color);
        stored.values(&film)
    };
    let here = value(moved(world, pixel, [0.0, 0.0]));
    let differs = |there: &Vec<f32>| {
        here.iter().zip(there).any(|(x, y)| {
            let [x, y] = [*x, *y].map(f64::from);
            (x - y).abs() > stored.tolerance(x)
        })
    };
    let mut around = AROUND
        .iter()
        .map(|direction| value(moved(world, pixel, direction.map(|along| along * edge.width))));
    if !edge.is_between {
        return around.any(|there| differs(&there));
    }
    let all: Vec<Vec<f32>> = around.chain([here.clone()]).collect();
    theirs.iter().enumerate().all(|(channel, theirs)| {
        let values = || all.iter().map(|it| f64::from(it[channel]));
        let (low, high) = (values().fold(f64::MAX, f64::min), values().fold(f64::MIN, f64::max));
        let theirs = f64::from(*theirs);
        low - stored.tolerance(low) <= theirs && theirs <= high + stored.tolerance(high)
    })
}

/// The pixel, with film points moved by so many pixels.
fn moved(world: &World, pixel: [u32; 2], [dx, dy]: [f64; 2]) -> Rgb {
    let size = world.image.pixel_size;
    let samples = (0..world.samples_per_pixel()).map(|index| {
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
    });
    render::expose(world, samples)
}
