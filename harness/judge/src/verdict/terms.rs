//! Our picture divided into terms.
//!
//! A term is the light of one source that arrives after so many edges and that one lobe scatters to the eye, or to the
//! first hit's lobe that sends it on. The picture is their sum. A picture by a program with a wrong factor holds another
//! multiple of some of them.

use std::collections::BTreeMap;
use std::ops::Range;

use groundtruth::film::Film;
use groundtruth::math::Ray;
use groundtruth::render::{self, CameraSample};
use groundtruth::rgb::Rgb;
use groundtruth::trace::{self, Outcome, RayKind, Recorder, Term, TermSource};
use groundtruth::world::World;
use rayon::prelude::*;

/// What a term is of.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Key {
    source: Source,
    /// The lobe at the eye's hit that sent the ray along which the light arrives, if it does not come from there.
    by: Option<&'static str>,
    /// The depth of the ray that meets the light or the lit surface, at most [`DEEPEST`].
    depth: u32,
}

/// Greater depths count as this one: their light is little, and looks alike.
const DEEPEST: u32 = 3;

/// Where the light of a term comes from.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Source {
    Background,
    Emission,
    /// A light, by its index.
    Ambient(u32),
    /// A light, and the lobe that it meets.
    Direct(u32, &'static str),
}

impl Key {
    /// The source, and its light on which surfaces by which way.
    fn names(self, world: &World) -> [String; 2] {
        let light = |index: u32| {
            let light = world.lights.iter().find(|light| light.index == index);
            light.map_or("a light", |light| &light.name)
        };
        let source = match self.source {
            Source::Background => "the background".to_owned(),
            Source::Emission => "light that surfaces emit".to_owned(),
            Source::Ambient(index) => format!("ambient light of {}", light(index)),
            Source::Direct(index, _) => format!("light of {}", light(index)),
        };
        let met = match self.source {
            Source::Direct(_, lobe) => format!("{source} on {lobe} surfaces"),
            _ => source.clone(),
        };
        [source, self.by.map_or(met.clone(), |lobe| format!("{met}, by {lobe}"))]
    }
}

/// The terms of a ray so far.
type Sums = BTreeMap<Key, Rgb>;

/// Divides the radiance of a sample into terms.
#[derive(Default)]
struct Dividing {
    /// For each ray that is under way, its terms, and those of its last child.
    frames: Vec<(Sums, Sums)>,
    whole: Sums,
}

impl Recorder for Dividing {
    fn enter(&mut self, _: RayKind, _: &Ray, _: u32, _: Rgb) {
        self.frames.push((Sums::new(), Sums::new()));
    }

    fn outcome(&mut self, _: Outcome) {}

    fn term(&mut self, term: Term) {
        let (sums, child) = self.frames.last_mut().expect("a ray is under way");
        let source = match term.source {
            TermSource::Background { .. } => Source::Background,
            TermSource::Emission { .. } => Source::Emission,
            TermSource::Ambient { light, .. } => Source::Ambient(light),
            TermSource::Direct { light, lobe, .. } => Source::Direct(light, lobe.name()),
            TermSource::Traced { lobe, .. } => {
                for (key, arriving) in std::mem::take(child) {
                    let depth = DEEPEST.min(key.depth + 1);
                    let key = Key { by: Some(lobe.name()), depth, ..key };
                    *sums.entry(key).or_default() += term.weight * arriving;
                }
                return;
            }
            // of a shadow ray, whose surface has the term
            TermSource::Light { .. } => return,
        };
        *sums.entry(Key { source, by: None, depth: 0 }).or_default() += term.value;
    }

    fn leave(&mut self, transmittance: Rgb, _: Rgb) {
        let (mut sums, _) = self.frames.pop().expect("a ray is under way");
        sums.values_mut().for_each(|value| *value = transmittance * *value);
        match self.frames.last_mut() {
            Some((_, child)) => *child = sums,
            None => self.whole = sums,
        }
    }
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
    let mut films: BTreeMap<Key, Film> = BTreeMap::new();
    for seed in seeds {
        world.reseed(seed);
        let pixels: Vec<([u32; 2], Sums)> = (0..height)
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
    let term = |(key, film): (Key, Film)| {
        let [source, name] = key.names(world);
        TermFilm { source, name, depth: key.depth, film }
    };
    films.into_iter().map(term).collect()
}

/// The terms of a pixel.
fn pixel(world: &World, at: [u32; 2]) -> Sums {
    let mut total = Sums::new();
    let count = world.samples_per_pixel();
    for index in 0..count {
        let mut recorder = Dividing::default();
        let sample = render::camera_sample(world, at, index);
        let Some(CameraSample { pixel, weight, ray: Some(ray), .. }) = sample else { continue };
        trace::radiance(world, &ray, world.draws(pixel, index), &mut recorder);
        let factor = weight * world.view.exposure_time / f64::from(count);
        for (key, value) in recorder.whole {
            *total.entry(key).or_default() += factor * value;
        }
    }
    total
}
