//! Our picture divided into terms ([`layers::TermKey`]).
//!
//! The picture is their sum. A picture by a program with a wrong factor holds another
//! multiple of some of them.

use std::collections::BTreeMap;
use std::ops::Range;

use groundtruth::film::Film;
use groundtruth::render::{self, CameraSample};
use groundtruth::trace;
use groundtruth::world::World;
use layers::{Dividing, LightSource, TermKey, Terms};
use rayon::prelude::*;

/// Greater depths count as this one: their light is little, and looks alike.
const DEEPEST: u32 = 3;

/// The source of a term, and its light on which surfaces by which way.
fn names(key: TermKey, world: &World) -> [String; 2] {
    let light = |index: u32| {
        let light = world.lights.iter().find(|light| light.index == index);
        light.map_or("a light", |light| &light.name)
    };
    let source = match key.source {
        LightSource::Background => "the background".to_owned(),
        LightSource::Emission => "light that surfaces emit".to_owned(),
        LightSource::Ambient(index) => format!("ambient light of {}", light(index)),
        LightSource::Direct(index, _) => format!("light of {}", light(index)),
    };
    let met = match key.source {
        LightSource::Direct(_, lobe) => format!("{source} on {lobe} surfaces"),
        _ => source.clone(),
    };
    [source, key.by.map_or(met.clone(), |lobe| format!("{met}, by {lobe}"))]
}

/// The film of a term.
pub struct TermFilm {
    /// Where its light comes from.
    pub source: String,
    /// What it is of, without the depth.
    pub name: String,
    /// The depth, at most 3: greater depths count as this one.
    pub depth: u32,
    /// What it adds to each pixel.
    pub film: Film,
}

impl TermFilm {
    /// The depth in words.
    pub(super) fn depth_name(&self) -> String {
        let more = if self.depth == DEEPEST { " or more" } else { "" };
        format!("at depth {}{more}", self.depth)
    }
}

/// The terms of a world's pictures with these seeds, each as the mean of films; their sum is the mean of the pictures.
pub fn terms(world: &mut World, seeds: Range<u64>) -> Vec<TermFilm> {
    let [width, height] = world.picture_size();
    let part = 1.0 / (seeds.end - seeds.start) as f64;
    let mut films: BTreeMap<TermKey, Film> = BTreeMap::new();
    for seed in seeds {
        world.reseed(seed);
        let pixels: Vec<([u32; 2], Terms)> = (0..height)
            .into_par_iter()
            .flat_map_iter(|y| (0..width).map(move |x| [x, y]))
            .map(|at| (at, pixel(world, at)))
            .collect();
        for (at, sums) in pixels {
            for (key, value) in sums {
                let film = films.entry(key).or_insert_with(|| Film::new(width, height));
                film.set(at, film.get(at) + part * value);
            }
        }
    }
    let term = |(key, film): (TermKey, Film)| {
        let [source, name] = names(key, world);
        TermFilm { source, name, depth: key.depth, film }
    };
    films.into_iter().map(term).collect()
}

/// The terms of a pixel.
fn pixel(world: &World, at: [u32; 2]) -> Terms {
    let mut total = Terms::new();
    let count = world.samples_per_pixel();
    for index in 0..count {
        let mut recorder = Dividing::down_to(DEEPEST);
        let sample = render::camera_sample(world, at, index);
        let Some(CameraSample { pixel, weight, ray: Some(ray), .. }) = sample else { continue };
        trace::radiance(world, &ray, world.draws(pixel, index), &mut recorder);
        let factor = weight * world.view.exposure_time / f64::from(count);
        for (key, value) in recorder.into_terms() {
            *total.entry(key).or_default() += factor * value;
        }
    }
    total
}
