//! Our picture divided into terms, and how much of each a picture holds.
//!
//! A term is the light of one source that arrives after so many edges and that one lobe scatters to the eye, or to the
//! first hit's lobe that sends it on. The picture is their sum. A picture by a program with a wrong factor holds another
//! multiple of some of them.

use std::collections::BTreeMap;
use std::f64::consts::PI;
use std::ops::Range;

use groundtruth::film::Film;
use groundtruth::math::Ray;
use groundtruth::render::{self, CameraSample};
use groundtruth::rgb::Rgb;
use groundtruth::trace::{self, Outcome, RayKind, Recorder, Term, TermSource};
use groundtruth::world::World;
use rayon::prelude::*;
use serde::Serialize;

use super::evidence::Evidence;

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
    fn name(self, world: &World) -> String {
        let light = |index: u32| {
            let light = world.lights.iter().find(|light| light.index == index);
            light.map_or("a light", |light| &light.name)
        };
        let source = match self.source {
            Source::Background => "the background".to_owned(),
            Source::Emission => "light that surfaces emit".to_owned(),
            Source::Ambient(index) => format!("ambient light of {}", light(index)),
            Source::Direct(index, lobe) => format!("light of {} on {lobe} surfaces", light(index)),
        };
        self.by.map_or(source.clone(), |lobe| format!("{source}, by {lobe}"))
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
    /// What it is of, without the depth.
    pub name: String,
    /// The depth, at most 3: greater depths count as this one.
    pub depth: u32,
    /// What it adds to each pixel.
    pub film: Film,
}

impl TermFilm {
    fn depth_name(&self) -> String {
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
    let term =
        |(key, film): (Key, Film)| TermFilm { name: key.name(world), depth: key.depth, film };
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

/// How much of a term a picture holds.
#[derive(Clone, Debug, Serialize)]
pub struct Factor {
    /// The term; several if the picture cannot tell them apart.
    pub terms: Vec<String>,
    /// How many times ours it holds.
    pub factor: f64,
    /// The standard deviation of the factor.
    pub error: f64,
    /// The part of our picture that the term is.
    pub share: f64,
}

/// Factors that mean something.
const KNOWN: [(f64, &str); 7] = [
    (0.0, "left out"),
    (0.5, "1/2"),
    (2.0, "2"),
    (PI, "π"),
    (1.0 / PI, "1/π"),
    (2.25, "1.5², the square of the index of glass"),
    (1.0 / 2.25, "1/1.5², of the index of glass"),
];

/// A factor is named if its error is at most this part of what it is called.
const CERTAIN: f64 = 0.05;

impl Factor {
    /// What the factor is, if it is known and certain enough.
    pub fn meaning(&self) -> Option<&'static str> {
        let is_it = |value: &f64| {
            let apart = (self.factor - value).abs();
            apart <= 3.0 * self.error && self.error <= CERTAIN * value.max(0.1)
        };
        KNOWN.iter().find(|(value, _)| is_it(value)).map(|(_, name)| *name)
    }

    /// Whether it is far from 1, for its error.
    pub fn is_off(&self) -> bool {
        (self.factor - 1.0).abs() > (5.0 * self.error).max(0.01)
    }
}

/// Two terms whose pictures are so alike cannot be told apart: the cosine of their angle.
const ALIKE: f64 = 0.98;

/// Terms below this part of the picture are not fitted.
const SMALLEST: f64 = 1e-4;

/// A picture is explained by factors if they leave at most this part of the squared difference.
const LEFT: f64 = 0.2;

/// The factors of the terms of which a picture is the sum, by weighted least squares over tiles. Terms of all depths have
/// one factor if that explains the picture; else all terms of a depth; else each has its own. `None` if factors do not
/// explain it.
pub fn factors(terms: &[TermFilm], evidence: &Evidence<'_>) -> Option<Vec<Factor>> {
    let tiles_of = |term: &TermFilm| {
        let values: Vec<f64> =
            term.film.pixels().iter().flat_map(|color| color.to_array()).collect();
        evidence.tiles(|at| values[at])
    };
    let tiles: Vec<Vec<f64>> = terms.iter().map(tiles_of).collect();
    let explain = |name: fn(&TermFilm) -> String| {
        let mut named: Vec<(String, Vec<f64>)> = Vec::new();
        for (term, tiles) in terms.iter().zip(&tiles) {
            match named.iter_mut().find(|(it, _)| *it == name(term)) {
                Some((_, sum)) => add(sum, tiles),
                None => named.push((name(term), tiles.clone())),
            }
        }
        fit(named, evidence)
    };
    explain(|term| term.name.clone())
        .or_else(|| explain(|term| format!("light {}", term.depth_name())))
        .or_else(|| explain(|term| format!("{}, {}", term.name, term.depth_name())))
}

/// Adds tiles to sums of tiles.
fn add(sums: &mut [f64], tiles: &[f64]) {
    sums.iter_mut().zip(tiles).for_each(|(sum, value)| *sum += value);
}

/// The factors of terms, each given by its tiles.
fn fit(terms: Vec<(String, Vec<f64>)>, evidence: &Evidence<'_>) -> Option<Vec<Factor>> {
    let weights = evidence.weights();
    let total: f64 = evidence.mean.iter().sum();
    let mut groups: Vec<(Vec<String>, Vec<f64>)> = Vec::new();
    for (name, tiles) in terms {
        if tiles.iter().sum::<f64>() < SMALLEST * total {
            continue;
        }
        match groups.iter_mut().find(|(_, group)| cosine(group, &tiles, &weights) > ALIKE) {
            Some((names, group)) => {
                names.push(name);
                add(group, &tiles);
            }
            None => groups.push((vec![name], tiles)),
        }
    }
    let finite = |value: f64| if value.is_finite() { value } else { 0.0 };
    let theirs = evidence.tiles(|at| finite(evidence.theirs[at]));
    let columns: Vec<&[f64]> = groups.iter().map(|(_, values)| &**values).collect();
    let (solution, covariance) = least_squares(&columns, &theirs, &weights)?;
    let left = |factors: &[f64]| -> f64 {
        let of = |tile: usize| {
            let ours: f64 = columns.iter().zip(factors).map(|(it, factor)| factor * it[tile]).sum();
            weights[tile] * (theirs[tile] - ours) * (theirs[tile] - ours)
        };
        (0..theirs.len()).map(of).sum()
    };
    let (before, after) = (left(&vec![1.0; columns.len()]), left(&solution));
    if after > LEFT * before {
        return None;
    }
    // what is left beyond noise makes the factors less certain
    let beyond = (after / (theirs.len() as f64 - solution.len() as f64)).max(1.0);
    let whole: f64 = columns.iter().map(|values| values.iter().sum::<f64>()).sum();
    let factor = |(index, (terms, values)): (usize, &(Vec<String>, Vec<f64>))| Factor {
        terms: terms.clone(),
        factor: solution[index],
        error: (beyond * covariance[index]).sqrt(),
        share: values.iter().sum::<f64>() / whole,
    };
    Some(groups.iter().enumerate().map(factor).collect())
}

/// The cosine of the angle between two pictures.
fn cosine(a: &[f64], b: &[f64], weights: &[f64]) -> f64 {
    product(a, b, weights) / (product(a, a, weights) * product(b, b, weights)).sqrt()
}

fn product(a: &[f64], b: &[f64], weights: &[f64]) -> f64 {
    a.iter().zip(b).zip(weights).map(|((a, b), weight)| weight * a * b).sum()
}

/// The multiples of the columns whose sum is nearest to the values, and the variance of each: the normal equations,
/// solved by Gauss and Jordan. `None` if columns depend on each other.
fn least_squares(
    columns: &[&[f64]],
    values: &[f64],
    weights: &[f64],
) -> Option<(Vec<f64>, Vec<f64>)> {
    let n = columns.len();
    let scale: Vec<f64> = columns.iter().map(|it| product(it, it, weights).sqrt()).collect();
    if n == 0 || scale.contains(&0.0) {
        return None;
    }
    // the matrix, the right side, and the identity that becomes the inverse
    let mut rows: Vec<Vec<f64>> = (0..n)
        .map(|i| {
            let matrix =
                (0..n).map(|j| product(columns[i], columns[j], weights) / scale[i] / scale[j]);
            let right = product(columns[i], values, weights) / scale[i];
            let identity = (0..n).map(|j| f64::from(u8::from(i == j)));
            matrix.chain([right]).chain(identity).collect()
        })
        .collect();
    for pivot in 0..n {
        let best =
            (pivot..n).max_by(|a, b| rows[*a][pivot].abs().total_cmp(&rows[*b][pivot].abs()))?;
        rows.swap(pivot, best);
        let divisor = rows[pivot][pivot];
        if divisor.abs() < 1e-9 {
            return None;
        }
        rows[pivot].iter_mut().for_each(|value| *value /= divisor);
        let row = rows[pivot].clone();
        for (_, other) in rows.iter_mut().enumerate().filter(|(index, _)| *index != pivot) {
            let factor = other[pivot];
            other.iter_mut().zip(&row).for_each(|(value, of_pivot)| *value -= factor * of_pivot);
        }
    }
    let solution = (0..n).map(|i| rows[i][n] / scale[i]).collect();
    let variances = (0..n).map(|i| rows[i][n + 1 + i] / (scale[i] * scale[i])).collect();
    Some((solution, variances))
}
