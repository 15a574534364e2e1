//! Why a picture differs: which known mistake brings it to ours, or nearest to ours.
//!
//! Each mistake is first rendered twice, with few samples and the random numbers of ours, so that the change it makes
//! has little noise. The mistakes whose changes come nearest to the picture are then rendered as often as our own
//! pictures, and the picture is judged against these.

use rayon::prelude::*;
use serde::Serialize;

use super::evidence::Evidence;
use super::hopeless::{is_hopeless, steps};
use super::place::Place;
use super::share::Share;
use super::suspects::{Suspect, Suspects};
use super::{Decision, Evaluation, PoolContext, RayTolerance, Strictness, exclude};

/// A mistake that explains a picture.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Cause {
    /// The name of the mistake; of a change in one place, the name of that which makes the same everywhere, if there is one.
    pub name: Option<&'static str>,
    /// The picture agrees with ours if …
    pub words: String,
    /// The chapter that has the right rule; `None` for changes in one place.
    pub chapter: Option<u32>,
}

/// The mistake that comes nearest to a picture.
#[derive(Clone, Debug, Serialize)]
pub struct Nearest {
    /// The mistake.
    pub cause: Cause,
    /// The part of the squared difference that it explains, weighted by the noise.
    pub share: f64,
    /// The interval of that part, from 5 % to 95 %.
    pub interval: [f64; 2],
}

/// What was found of the causes of a difference.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Causes {
    /// The mistakes that explain the picture; several if the scene cannot tell them apart.
    pub explained_by: Vec<Cause>,
    /// If none explains it, the one that explains most of it.
    pub nearest: Option<Nearest>,
    /// The object or material to which the difference is confined.
    pub place: Option<Place>,
    /// The number of mistakes that change the picture and were tried.
    pub tried: usize,
}

/// So many of the nearest mistakes are judged.
const JUDGED: usize = 4;

/// A mistake is worth judging if its change leaves at most this part of the squared difference.
const LEFT: f64 = 0.5;

/// Changes of two mistakes are alike if they differ by at most this part of either, squared.
const ALIKE: f64 = 0.02;

/// Changes that are so alike have the same judgement.
const EQUAL: f64 = 1e-6;

/// The change that a mistake makes, over tiles.
struct SuspectFit {
    suspect: Suspect,
    tiles: Vec<f64>,
    /// How much of the difference it explains.
    share: Share,
}

impl Suspects<'_> {
    /// The mistakes that explain a picture.
    pub fn causes(&self, evidence: &Evidence<'_>, strictness: Strictness) -> Causes {
        let place = Place::of(evidence, self.scene);
        let weights = evidence.weights();
        let changes = self.ranked(evidence, place.as_ref(), &weights);
        let tried = changes.len();
        let mut causes = Causes { place, tried, ..Causes::default() };
        let is_near = |change: &&SuspectFit| change.share.interval[1] >= 1.0 - LEFT;
        let mut judged: Vec<&SuspectFit> = Vec::new();
        for change in changes.iter().filter(is_near) {
            if judged.len() == JUDGED || (self.is_interrupted)() {
                break;
            }
            if judged.iter().any(|other| are_alike(change, other, &weights, EQUAL)) {
                continue;
            }
            if self.explains(&change.suspect, evidence, strictness) {
                causes.explained_by = alike(change, &changes, &weights);
                return causes;
            }
            judged.push(change);
        }
        let nearest = changes.first().filter(|change| change.share.part > 0.0);
        causes.nearest = nearest.map(|SuspectFit { suspect, share, .. }| Nearest {
            cause: suspect.cause(),
            share: share.part,
            interval: share.interval,
        });
        causes
    }

    /// The changes that suspects make, those that explain most first.
    fn ranked(
        &self,
        evidence: &Evidence<'_>,
        place: Option<&Place>,
        weights: &[f64],
    ) -> Vec<SuspectFit> {
        let difference = evidence.tiles(|at| finite(evidence.theirs[at] - evidence.mean[at]));
        let noise = evidence.squares_of_noise();
        let of = |(suspect, tiles): (Suspect, Vec<Vec<f64>>)| {
            let ends = [&tiles[0], &tiles[tiles.len() - 1]];
            let [first, last] = ends.map(|change| difference_of(&difference, change));
            let share = Share::of(&difference, [&first, &last], weights, &noise);
            let mean = ends[0].iter().zip(ends[1]).map(|(a, b)| 0.5 * (a + b)).collect();
            SuspectFit { suspect, tiles: mean, share }
        };
        let changes = self.changes(evidence, place);
        let mut changes: Vec<SuspectFit> = changes.into_par_iter().map(of).collect();
        changes.sort_by(|a, b| b.share.part.total_cmp(&a.share.part));
        changes
    }

    /// Whether a picture agrees with those of a mistake.
    fn explains(
        &self,
        suspect: &Suspect,
        Evidence { areas, stored, theirs, .. }: &Evidence<'_>,
        strictness: Strictness,
    ) -> bool {
        let mut seed = self.seed;
        let mut replicas = || {
            seed += 1;
            let film = suspect.picture(self.scene, self.folder, seed);
            film.filter(|_| !(self.is_interrupted)()).map(|film| stored.values(&film))
        };
        let mut theirs: Vec<f32> = theirs.iter().map(|value| *value as f32).collect();
        let subject = PoolContext { areas, stored: *stored, reference: None };
        let (world, tolerance) = (self.world, RayTolerance::DOUBLE);
        let mut known: Vec<Vec<f32>> = Vec::new();
        let mut fill = |known: &mut Vec<Vec<f32>>, count: usize| {
            known.extend(std::iter::from_fn(&mut replicas).take(count - known.len()));
            known.len() == count
        };
        for count in steps(strictness) {
            if !fill(&mut known, count) || is_hopeless(&theirs, world, subject, &known, tolerance) {
                return false;
            }
        }
        if !fill(&mut known, strictness.first) {
            return false;
        }
        exclude(&mut theirs, world, &known, *stored, tolerance);
        let judged = Evaluation::of(&theirs, subject, strictness, &mut known, |_| replicas());
        judged.is_some_and(|judged| judged.decision == Decision::Agrees)
    }
}

/// The causes that a scene cannot tell from this one, each mistake once.
fn alike(change: &SuspectFit, changes: &[SuspectFit], weights: &[f64]) -> Vec<Cause> {
    let mut group = vec![change.suspect.cause()];
    for other in changes.iter().filter(|other| are_alike(change, other, weights, ALIKE)) {
        let cause = other.suspect.cause();
        let is_known = |known: &Cause| match cause.name {
            Some(name) => known.name == Some(name),
            None => known.words == cause.words,
        };
        if !group.iter().any(is_known) {
            group.push(cause);
        }
    }
    // what is the same everywhere is simpler than what is so in one place
    group.sort_by_key(|cause| cause.chapter.is_none());
    group
}

/// What is no number has no weight.
pub(super) fn finite(value: f64) -> f64 {
    if value.is_finite() { value } else { 0.0 }
}

/// The weighted sum of squares.
fn squared(values: &[f64], weights: &[f64]) -> f64 {
    values.iter().zip(weights).map(|(value, weight)| weight * value * value).sum()
}

fn difference_of(a: &[f64], b: &[f64]) -> Vec<f64> {
    a.iter().zip(b).map(|(a, b)| a - b).collect()
}

fn are_alike(a: &SuspectFit, b: &SuspectFit, weights: &[f64], most: f64) -> bool {
    squared(&difference_of(&a.tiles, &b.tiles), weights) <= most * squared(&a.tiles, weights)
}
