//! Why a picture differs: which known mistake brings it to ours, or nearest to ours.
//!
//! Each mistake is first rendered twice in a part of the picture, with few samples and the random numbers of ours, so that
//! the change it makes has little noise. If nothing says how the picture encodes radiance, its values are read in each
//! usual way, and in each way with its rows, columns and channels in other orders: read as it fits a wrong picture best,
//! a mistake is hidden. The mistakes whose changes come nearest to the picture are then rendered as often as our own
//! pictures, and the picture is judged against these.

use groundtruth::film::Film;
use groundtruth::rgb::Rgb;
use groundtruth::scene::Scene;
use pictures::compare::{Change, Picture, Transfer};
use rayon::prelude::*;
use serde::Serialize;

use super::attempt::{Judge, read};
use super::evidence::finite;
use super::linear::less;
use super::numbers::Searched;
use super::share::{Share, remainder};
use super::suspects::{Lineup, Suspect};
use super::{Areas, Case, Evaluation, Evidence, Place, Pool, Replicas, Stored};
use crate::mistakes::local::Local;

/// A mistake that explains a picture.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Cause {
    /// The name of the mistake; of a change in one place, the name of that which makes the same everywhere, if there is one.
    pub name: Option<&'static str>,
    /// The picture agrees with ours if …
    pub words: String,
    /// The chapter that has the right rule; `None` for changes in one place.
    pub chapter: Option<u32>,
    /// What is also different about the picture: its orientation, or the order of its channels.
    pub also: Option<String>,
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
    /// What would explain it if its values encoded radiance in another way, which is named, and nothing says in which they
    /// do.
    pub otherwise: Vec<(String, Cause)>,
    /// Whether the search ended before everything was tried.
    pub is_unfinished: bool,
}

/// So many of the nearest mistakes are judged.
const JUDGED: usize = 5;

/// A mistake is worth judging if its change leaves at most this part of the squared difference.
const LEFT: f64 = 0.5;

/// What would explain a picture that is read in another way must leave at most this part.
const LITTLE: f64 = 0.05;

/// A number of the scene that explains this part of the difference is named.
const FITTED: f64 = 0.99;

/// Changes of two mistakes are alike if they differ by at most this part of either, squared.
const ALIKE: f64 = 0.02;

/// Changes that are so alike have the same judgement.
const EQUAL: f64 = 1e-6;

/// Mistakes are tried in about so many tiles.
const TILES: usize = 128;

/// Numbers are looked for in so many ways to read the picture.
const WAYS_WITH_NUMBERS: usize = 2;

/// A change of orientation is named beside a mistake only if it leaves this much less.
const SIMPLER: f64 = 0.5;

/// A picture that differs.
pub(super) struct Inquiry<'a, 'b, 'c> {
    pub judge: Judge<'a>,
    pub theirs: &'a Picture,
    pub replicas: &'a mut Replicas<'b, 'c>,
    /// How it was judged.
    pub judged: &'a Evaluation,
}

/// The picture read in one way.
struct Reading<'a> {
    evidence: Evidence<'a>,
    /// For each pixel, its index in the lineup.
    index: Vec<usize>,
    weights: Vec<f64>,
    noise: Vec<f64>,
    /// What is left without any change.
    before: f64,
    /// The changes that the suspects make, of each seed, over tiles.
    changes: Vec<Vec<Vec<f64>>>,
}

/// A suspect, and the reading and the orientation of the picture under which it is tested.
#[derive(Clone, Copy)]
struct Hypothesis {
    reading: usize,
    change: Change,
    suspect: usize,
    /// The weighted squares that are left of the difference.
    left: f64,
    /// The part of the difference that is explained.
    part: f64,
}

impl<'a> Inquiry<'a, '_, '_> {
    /// The mistakes that explain the picture, and the way to read it in which they do, or nearly.
    pub fn causes(&mut self, ways: &[Stored]) -> (Causes, Option<Stored>) {
        let (beside, areas) = ((self.theirs, self.judged), self.judge.areas);
        let films = &self.replicas.films;
        let of = |way: &Stored| evidence_of(beside, films, areas, *way);
        let mut evidence: Vec<Evidence<'_>> = ways.par_iter().map(of).collect();
        let scene = self.judge.scene;
        let places: Vec<Place> = evidence.iter().filter_map(|it| Place::of(it, scene)).collect();
        evidence[0].keep(TILES);
        let blocks = evidence[0].blocks.clone();
        evidence.iter_mut().for_each(|it| it.blocks.clone_from(&blocks));
        let (width, pixels) = (self.judge.areas.size[0], blocks.concat());
        let at = |pixel: &usize| [pixel % width, pixel / width].map(|along| along as u32);
        let at: Vec<[u32; 2]> = pixels.iter().map(at).collect();
        let has_noise = evidence[0].noise.iter().any(|noise| *noise > 0.0);
        let mut lineup = self.judge.lineup(&at, has_noise, &places);
        let mut readings: Vec<Reading<'_>> =
            evidence.into_par_iter().map(|it| Reading::new(it, &lineup, &pixels)).collect();
        let mut hypotheses = self.hypotheses(&readings, 0);
        let mut found = self.judged(&readings, &hypotheses, &lineup);
        let tried = lineup.suspects.len();
        for count in [1, 3] {
            if !lineup.ours.is_empty() && found.is_empty() && !(self.judge.is_over)() {
                let first = lineup.suspects.len();
                let of = |reading: &Reading<'_>| reading.numbers(&self.judge, &lineup, count);
                let numbers = readings.iter().take(WAYS_WITH_NUMBERS).flat_map(of).collect();
                self.judge.suspect(numbers, &mut lineup);
                readings.iter_mut().for_each(|it| it.add(&lineup, first));
                let more = self.hypotheses(&readings, first);
                found = self.judged(&readings, &more, &lineup);
                hypotheses.extend(more);
                hypotheses.sort_by(|a, b| b.part.total_cmp(&a.part));
            }
        }
        // a number that was fitted is not exact, and pictures without noise tell
        let is_fitted = |it: &&Hypothesis| {
            let share = || readings[it.reading].share(it, self.theirs);
            it.suspect >= tried && it.part >= FITTED && share().interval[0] >= FITTED
        };
        if found.is_empty() {
            found.extend(hypotheses.iter().find(is_fitted));
        }
        let cause = |it: &Hypothesis| it.cause(&lineup.suspects[it.suspect].0);
        let mut causes = Causes { tried, ..Causes::default() };
        if let Some(first) = found.first() {
            causes.explained_by = readings[first.reading].alike(first, &lineup);
            let transfer = |it: &Hypothesis| ways[it.reading].transfer().map(|it| it.to_string());
            causes.otherwise =
                found[1..].iter().filter_map(|it| Some((transfer(it)?, cause(it)))).collect();
        } else if let Some(best) = hypotheses.first() {
            let Share { part: share, interval } = readings[best.reading].share(best, self.theirs);
            causes.nearest = Some(Nearest { cause: cause(best), share, interval });
        }
        causes.is_unfinished = (self.judge.is_over)();
        let near = hypotheses.first().filter(|it| it.part >= 1.0 - LITTLE);
        let chosen = found.first().or(near).map(|it| ways[it.reading]);
        let way = chosen.unwrap_or(ways[0]);
        causes.place = Place::of(&evidence_of(beside, &self.replicas.films, areas, way), scene);
        (causes, chosen)
    }

    /// Who, from this suspect on, may have made the picture, read in some way, with the least left of the difference first.
    fn hypotheses(&self, readings: &[Reading<'_>], first: usize) -> Vec<Hypothesis> {
        let orders = Change::of_pixels(self.theirs.size).into_iter();
        let mut all: Vec<Hypothesis> = Vec::new();
        for change in std::iter::once(Change::Same).chain(orders) {
            let changed = change.applied(self.theirs);
            if change != Change::Same && changed.values == self.theirs.values {
                continue;
            }
            let of = |(index, reading): (usize, &Reading<'_>)| {
                let difference = reading.difference(&changed);
                let of = |(suspect, tiles): (usize, &Vec<Vec<f64>>)| {
                    let left = reading.left(&difference, tiles);
                    let part = 1.0 - left / reading.before;
                    Hypothesis { reading: index, change, suspect, left, part }
                };
                reading.changes.iter().enumerate().skip(first).map(of).collect::<Vec<Hypothesis>>()
            };
            all.par_extend(readings.par_iter().enumerate().flat_map(of));
        }
        all.retain(|it| it.part >= 1.0 - LEFT || it.change == Change::Same);
        let rank =
            |it: &Hypothesis| if it.change == Change::Same { it.left } else { it.left / SIMPLER };
        all.sort_by(|a, b| rank(a).total_cmp(&rank(b)));
        all
    }

    /// Those with which the picture agrees: the first, and what would explain it if it were read in other ways.
    fn judged(
        &mut self,
        readings: &[Reading<'_>],
        hypotheses: &[Hypothesis],
        lineup: &Lineup,
    ) -> Vec<Hypothesis> {
        let (mut found, mut tried): (Vec<Hypothesis>, Vec<Hypothesis>) = (Vec::new(), Vec::new());
        for it in hypotheses {
            if tried.len() == JUDGED || (self.judge.is_over)() {
                break;
            }
            let is_known = |other: &Hypothesis| {
                let reading = &readings[it.reading];
                (it.reading, it.change) == (other.reading, other.change)
                    && reading.are_alike(it.suspect, other.suspect, EQUAL)
            };
            let is_other = |found: &Hypothesis| {
                it.reading != found.reading
                    && it.suspect != found.suspect
                    && it.part >= 1.0 - LITTLE
            };
            // of a difference that looks like noise, the part is not certain
            let is_near = || {
                let share = || readings[it.reading].share(it, self.theirs);
                it.part >= 1.0 - LEFT || share().interval[1] >= 1.0 - LEFT
            };
            if tried.iter().any(is_known) || !found.iter().all(is_other) || !is_near() {
                continue;
            }
            tried.push(*it);
            if self.agrees(it, &lineup.suspects[it.suspect].0, readings[it.reading].evidence.stored)
            {
                found.push(*it);
            }
        }
        found
    }

    /// Whether the picture agrees with those of a mistake.
    fn agrees(&mut self, it: &Hypothesis, suspect: &Suspect, way: Stored) -> bool {
        let source = |seed| suspect.picture(&self.judge, seed);
        let judge = self.judge.reading(way);
        let mut replicas = self.replicas.of_others(&source);
        judge.agrees(&it.change.applied(self.theirs), &mut replicas) == Some(true)
    }
}

impl<'a> Reading<'a> {
    /// The picture, and the changes that the suspects make at some pixels, those of the tiles of the evidence.
    fn new(evidence: Evidence<'a>, lineup: &Lineup, pixels: &[usize]) -> Self {
        let mut index = vec![0; evidence.theirs.len() / 3];
        pixels.iter().enumerate().for_each(|(at, pixel)| index[*pixel] = at);
        let (weights, noise) = (evidence.weights(), evidence.squares_of_noise());
        let changes = Vec::new();
        let mut reading = Self { evidence, index, weights, noise, before: 0.0, changes };
        let difference = reading.evidence.difference();
        reading.before = remainder([&difference; 2], &reading.weights, &reading.noise);
        reading.add(lineup, 0);
        reading
    }

    /// The change from our pixels to others, over tiles.
    fn change(&self, colors: &[Rgb], ours: &[Rgb]) -> Vec<f64> {
        let [altered, ours] = [colors, ours].map(|colors| self.evidence.stored.of_colors(colors));
        let change = |at: usize| f64::from(altered[at]) - f64::from(ours[at]);
        self.evidence.tiles(|at| finite(change(3 * self.index[at / 3] + at % 3)))
    }

    fn add(&mut self, lineup: &Lineup, first: usize) {
        let of = |(_, values): &(Suspect, Vec<Vec<Rgb>>)| {
            let both = values.iter().zip(&lineup.ours);
            both.map(|(values, ours)| self.change(values, ours)).collect()
        };
        let more: Vec<Vec<Vec<f64>>> = lineup.suspects[first..].par_iter().map(of).collect();
        self.changes.extend(more);
    }

    /// Scenes with another number that explain most of the difference.
    fn numbers(&self, case: &Case<'_>, lineup: &Lineup, count: usize) -> Vec<Local> {
        let change = |scene: &Scene| {
            Some(self.change(&case.pixels(scene, lineup.seeds[0], lineup)?, &lineup.ours[0]))
        };
        let (scene, difference) = (&lineup.scene, &*self.evidence.difference());
        Searched { scene, change: &change, difference, weights: &self.weights }.scenes(count)
    }

    /// A picture less the mean of ours, over tiles.
    fn difference(&self, theirs: &Picture) -> Vec<f64> {
        let Evidence { stored, mean, .. } = &self.evidence;
        let values = theirs.values.as_flattened();
        self.evidence.tiles(|at| finite(f64::from(stored.read(values[at])) - mean[at]))
    }

    /// The weighted squares that changes leave of a difference.
    fn left(&self, difference: &[f64], changes: &[Vec<f64>]) -> f64 {
        let [first, last] = ends(changes).map(|change| less(difference, change));
        let left = remainder([&first, &last], &self.weights, &self.noise);
        // far below 0, the changes of the two seeds are mostly noise
        if left < -self.before { left.abs() } else { left }
    }

    fn share(&self, it: &Hypothesis, theirs: &Picture) -> Share {
        let difference = self.difference(&it.change.applied(theirs));
        let of = |change: &Vec<f64>| less(&difference, change);
        let [first, last] = ends(&self.changes[it.suspect]).map(of);
        Share::of(&difference, [&first, &last], &self.weights, &self.noise)
    }

    /// Whether the changes of two suspects are alike.
    fn are_alike(&self, a: usize, b: usize, most: f64) -> bool {
        let [a, b] = [a, b].map(|suspect| mean(&self.changes[suspect]));
        let squared = |values: &[f64]| remainder([values; 2], &self.weights, &[]);
        squared(&less(&a, &b)) <= most * squared(&a)
    }

    /// The causes that a scene cannot tell from this one, each mistake once.
    fn alike(&self, it: &Hypothesis, lineup: &Lineup) -> Vec<Cause> {
        let mut group = vec![it.cause(&lineup.suspects[it.suspect].0)];
        for (other, (suspect, _)) in lineup.suspects.iter().enumerate() {
            let cause = it.cause(suspect);
            let is_known = |known: &Cause| match cause.name {
                Some(name) => known.name == Some(name),
                None => known.words == cause.words,
            };
            if self.are_alike(it.suspect, other, ALIKE) && !group.iter().any(is_known) {
                group.push(cause);
            }
        }
        // what is the same everywhere is simpler than what is so in one place
        group.sort_by_key(|cause| cause.chapter.is_none());
        group
    }
}

/// A picture beside ours, read in one way: as it was judged, or beside the first of ours.
fn evidence_of<'a>(
    (theirs, judged): (&Picture, &Evaluation),
    films: &[Film],
    areas: &'a Areas,
    way: Stored,
) -> Evidence<'a> {
    let theirs = read(theirs, way);
    let noise = judged.ranking.noise[judged.pool.count() - 1];
    if way == judged.pool.stored {
        return Evidence::of(&judged.pool, noise, areas, &theirs);
    }
    let known = films.iter().map(|film| way.values(film));
    let pictures = known.chain([theirs.clone()]).collect();
    Evidence::of(&Pool::new(areas.size, way, pictures), noise, areas, &theirs)
}

impl Hypothesis {
    fn cause(&self, suspect: &Suspect) -> Cause {
        let also = (self.change != Change::Same)
            .then(|| self.change.words(["ours", "theirs"], Transfer::Linear));
        Cause { also, ..suspect.cause() }
    }
}

fn ends(changes: &[Vec<f64>]) -> [&Vec<f64>; 2] {
    [&changes[0], &changes[changes.len() - 1]]
}

fn mean(changes: &[Vec<f64>]) -> Vec<f64> {
    let [first, last] = ends(changes);
    first.iter().zip(last).map(|(a, b)| 0.5 * (a + b)).collect()
}
