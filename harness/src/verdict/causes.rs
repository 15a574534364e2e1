//! Why a picture differs: which known mistake brings it to ours.
//!
//! Each mistake is first rendered once, with few samples and the random numbers of ours, so that the change it makes
//! has little noise. The mistakes whose changes come nearest to the picture are then rendered as often as our own
//! pictures, and the picture is judged against these.

use std::path::Path;

use groundtruth::film::Film;
use groundtruth::scene::Scene;
use rayon::prelude::*;
use serde::Serialize;

use super::{Areas, Decision, Judged, Stored, Strictness};
use crate::mistakes::{self, Films, Mistake};

/// A mistake that explains a picture.
#[derive(Clone, Debug, Serialize)]
pub struct Cause {
    /// Its name.
    pub name: &'static str,
    /// The picture agrees with ours if …
    pub words: &'static str,
    /// The chapter that has the right rule.
    pub chapter: u32,
}

impl Cause {
    fn of(mistake: &Mistake) -> Self {
        Self { name: mistake.name, words: mistake.words, chapter: mistake.chapter }
    }
}

/// What was found of the causes of a difference.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Causes {
    /// The mistakes that explain the picture; several if the scene cannot tell them apart.
    pub explained_by: Vec<Cause>,
    /// The number of mistakes that change the picture and were tried.
    pub tried: usize,
}

/// Mistakes are first rendered with at most so many samples.
const FEW_SAMPLES: u32 = 16;

/// So many of the nearest mistakes are judged.
const JUDGED: usize = 4;

/// A mistake is worth judging if its change leaves at most this part of the squared difference.
const LEFT: f64 = 0.5;

/// Changes of two mistakes are alike if they differ by at most this part of either, squared.
const ALIKE: f64 = 0.02;

/// The level of the tiles over which changes are compared.
const LEVEL: usize = 2;

/// A scene whose mistaken pictures are rendered.
pub struct Suspects<'a> {
    /// The scene, at the size of the picture.
    pub scene: &'a Scene,
    /// Where the files are that it names.
    pub folder: &'a Path,
    /// The seed of the first replica.
    pub seed: u64,
    /// Whether the user interrupted.
    pub is_interrupted: &'a dyn Fn() -> bool,
}

/// The change that a mistake makes, over tiles.
struct Change {
    mistake: &'static Mistake,
    tiles: Vec<f64>,
    /// The part of the squared difference that it leaves.
    left: f64,
}

impl Suspects<'_> {
    /// The mistakes that explain the difference of `theirs` from `mean`, the mean of ours, whose difference has these
    /// variances: three values a pixel, as radiance.
    pub fn causes(
        &self,
        (theirs, mean, variances): (&[f32], &[f64], &[f64]),
        (areas, stored): (&Areas, Stored),
        strictness: Strictness,
    ) -> Causes {
        let Some(films) = self.films() else { return Causes::default() };
        let weights: Vec<f64> = tiles(areas, |at| variances[at]);
        let difference = tiles(areas, |at| f64::from(theirs[at]) - mean[at]);
        let before = squared(&difference, &weights);
        let ours = stored.values(&films.ours);
        let change = |(mistake, film): &(&'static Mistake, Film)| {
            let altered = stored.values(film);
            let tiles = tiles(areas, |at| f64::from(altered[at]) - f64::from(ours[at]));
            let rest: Vec<f64> = difference.iter().zip(&tiles).map(|(a, b)| a - b).collect();
            Change { mistake, left: squared(&rest, &weights) / before, tiles }
        };
        let mut changes: Vec<Change> = films.altered.par_iter().map(change).collect();
        let tried = changes.len();
        changes.retain(|change| change.left <= LEFT);
        changes.sort_by(|a, b| a.left.total_cmp(&b.left));
        for at in 0..changes.len().min(JUDGED) {
            if (self.is_interrupted)() {
                break;
            }
            if self.explains(changes[at].mistake, theirs, (areas, stored), strictness) {
                let is_alike = |other: &&Change| are_alike(&changes[at], other, &weights);
                let group = changes.iter().filter(is_alike).map(|it| Cause::of(it.mistake));
                return Causes { explained_by: group.collect(), tried };
            }
        }
        Causes { explained_by: Vec::new(), tried }
    }

    /// The pictures of all mistakes, with few samples.
    fn films(&self) -> Option<Films> {
        let mut scene = self.scene.clone();
        scene.image.samples = scene.image.samples.min(FEW_SAMPLES);
        mistakes::replicas(&scene, self.folder, self.seed).ok()
    }

    /// Whether a picture agrees with those of a mistake.
    fn explains(
        &self,
        mistake: &'static Mistake,
        theirs: &[f32],
        subject: (&Areas, Stored),
        strictness: Strictness,
    ) -> bool {
        let mut seed = self.seed;
        let replicas = || {
            seed += 1;
            let film = mistakes::replica(mistake, self.scene, self.folder, seed).ok().flatten();
            film.filter(|_| !(self.is_interrupted)()).map(|film| subject.1.values(&film))
        };
        let judged = Judged::of(theirs, subject, strictness, &mut Vec::new(), replicas);
        judged.is_some_and(|judged| judged.decision == Decision::Agrees)
    }
}

/// Sums over tiles, of each channel.
fn tiles(areas: &Areas, value: impl Fn(usize) -> f64) -> Vec<f64> {
    let level = LEVEL.min(areas.levels() - 1);
    let of = |channel: usize| {
        let pixels = (0..areas.object_of.len()).map(|pixel| value(3 * pixel + channel)).collect();
        (1..=level).fold(pixels, |sums: Vec<f64>, level| areas.coarser(&sums, level))
    };
    (0..3).flat_map(of).collect()
}

/// The sum of squares over variances; where there is no variance, the smallest counts.
fn squared(values: &[f64], variances: &[f64]) -> f64 {
    let positive = variances.iter().copied().filter(|variance| *variance > 0.0);
    let smallest = positive.fold(f64::INFINITY, f64::min);
    let floor = if smallest.is_finite() { smallest } else { 1.0 };
    values.iter().zip(variances).map(|(value, variance)| value * value / variance.max(floor)).sum()
}

fn are_alike(a: &Change, b: &Change, variances: &[f64]) -> bool {
    let apart: Vec<f64> = a.tiles.iter().zip(&b.tiles).map(|(a, b)| a - b).collect();
    squared(&apart, variances) <= ALIKE * squared(&a.tiles, variances)
}
