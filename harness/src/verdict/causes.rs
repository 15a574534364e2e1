//! Why a picture differs: which known mistake brings it to ours.
//!
//! Each mistake is first rendered once, with few samples and the random numbers of ours, so that the change it makes
//! has little noise. The mistakes whose changes come nearest to the picture are then rendered as often as our own
//! pictures, and the picture is judged against these.

use std::path::Path;

use groundtruth::film::Film;
use groundtruth::scene::Scene;
use groundtruth::world::World;
use rayon::prelude::*;
use serde::Serialize;

use super::evidence::Evidence;
use super::{Decision, Edge, Judged, Strictness, Subject, set_apart};
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

/// A scene whose mistaken pictures are rendered.
pub struct Suspects<'a> {
    /// The scene, at the size of the picture.
    pub scene: &'a Scene,
    /// Its world.
    pub world: &'a World,
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
    /// The mistakes that explain a picture.
    pub fn causes(&self, evidence: &Evidence<'_>, strictness: Strictness) -> Causes {
        let Some(films) = self.films() else { return Causes::default() };
        let weights = evidence.weights();
        let difference = evidence.tiles(|at| finite(evidence.theirs[at] - evidence.mean[at]));
        let before = squared(&difference, &weights);
        let ours = evidence.stored.values(&films.ours);
        let change = |(mistake, film): &(&'static Mistake, Film)| {
            let altered = evidence.stored.values(film);
            let tiles = evidence.tiles(|at| finite(f64::from(altered[at]) - f64::from(ours[at])));
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
            if self.explains(changes[at].mistake, evidence, strictness) {
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
        Evidence { areas, stored, theirs, .. }: &Evidence<'_>,
        strictness: Strictness,
    ) -> bool {
        let mut seed = self.seed;
        let mut replicas = || {
            seed += 1;
            let film = mistakes::replica(mistake, self.scene, self.folder, seed).ok().flatten();
            film.filter(|_| !(self.is_interrupted)()).map(|film| stored.values(&film))
        };
        let mut theirs: Vec<f32> = theirs.iter().map(|value| *value as f32).collect();
        let mut known: Vec<Vec<f32>> =
            std::iter::from_fn(&mut replicas).take(strictness.first).collect();
        if known.len() < strictness.first {
            return false;
        }
        set_apart(&mut theirs, self.world, &known, *stored, Edge::DOUBLE);
        let subject = Subject { areas, stored: *stored, reference: None };
        let judged = Judged::of(&theirs, subject, strictness, &mut known, |_| replicas());
        judged.is_some_and(|judged| judged.decision == Decision::Agrees)
    }
}

/// What is no number has no weight.
fn finite(value: f64) -> f64 {
    if value.is_finite() { value } else { 0.0 }
}

/// The weighted sum of squares.
fn squared(values: &[f64], weights: &[f64]) -> f64 {
    values.iter().zip(weights).map(|(value, weight)| weight * value * value).sum()
}

fn are_alike(a: &Change, b: &Change, weights: &[f64]) -> bool {
    let apart: Vec<f64> = a.tiles.iter().zip(&b.tiles).map(|(a, b)| a - b).collect();
    squared(&apart, weights) <= ALIKE * squared(&a.tiles, weights)
}
