//! One picture of a scene, from its file to what is said of it.

use std::path::Path;

use groundtruth::film::{Film, OutOfGamut};
use groundtruth::scene::Scene;
use groundtruth::world::World;

use super::attempt::{Attempt, Judge, better, read};
use super::lossy;
use super::verdict::{DifferingRegion, REGIONS, Verdict};
use super::{
    Areas, Decision, Evaluation, Map, Progress, RayTolerance, Reference, Renders, Replicas, Stored,
    Strictness, plausible, several, smallest_gains,
};
use crate::mistakes::IsOver;
use pictures::compare::{Picture, Transfer};

/// A scene, and how strictly its pictures are judged.
pub struct Case<'a> {
    /// The scene's world, at the size of the pictures.
    pub world: &'a mut World,
    /// The scene.
    pub scene: &'a Scene,
    /// Where the files are that it names.
    pub folder: &'a Path,
    /// Whether the search for causes is to end: the user interrupted, or it has taken long enough.
    pub is_over: IsOver<'a>,
    /// Is told what is known so far.
    pub so_far: &'a dyn Fn(Progress<'_>),
    /// How strictly.
    pub strictness: Strictness,
    /// The transfer function of pictures for display, if the user or the file says it.
    pub transfer: Option<Transfer>,
    /// The gamma of the scene's picture, and its rule for colours beyond 1.
    pub tone: (f64, OutOfGamut),
    /// The seed of the first replica.
    pub seed: u64,
    /// A mean of other pictures of ours, if one was rendered before.
    pub reference: Option<&'a Reference>,
    /// How far the rays of the other renderer may be from ours.
    pub tolerance: RayTolerance,
}

impl Case<'_> {
    /// What is to be said of a picture; `None` if the user interrupted before anything could be.
    pub fn verdict(&mut self, theirs: &Picture, renders: Renders<'_>) -> Option<Verdict> {
        let areas = Areas::of(self.world);
        let (strictness, seed) = (self.strictness, self.seed);
        let (transfer, tone) = (self.transfer, self.tone);
        let mut replicas = Replicas::new(self.world, seed, renders);
        replicas.fill(strictness.first);
        let (so_far, reference, tolerance) = (self.so_far, self.reference, self.tolerance);
        let Self { scene, folder, is_over, .. } = *self;
        let judge = Judge {
            areas: &areas,
            strictness,
            transfer,
            tone,
            so_far,
            reference,
            tolerance,
            scene,
            folder,
            seed,
            is_over,
        };
        let independent = judge
            .preliminary(theirs, &replicas)
            .is_some_and(|noise| judge.match_noise(theirs, &mut replicas, noise));
        let Attempt { mut judged, mut verdict, known } = judge.judged(theirs, &mut replicas)?;
        if let Some(equal) = equal_to(&replicas.films, theirs, judged.pool.stored) {
            return Some(verdict.equal(seed + equal as u64));
        }
        let is_loss = |loss: f64| lossy::agrees(theirs, loss, judged.pool.stored, &replicas.films);
        match verdict.decision {
            Decision::Differs if theirs.loss.is_some_and(is_loss) => {
                (verdict.decision, verdict.loss) = (Decision::Agrees, theirs.loss);
            }
            Decision::Differs => {
                so_far(Progress::Explaining);
                let reason = judge.reason(theirs, &mut replicas, &judged);
                let stored = judged.pool.stored;
                if let Some(way) = reason.way.filter(|way| *way != stored)
                    && let Some(attempt) = judge.judged_as(theirs, way, &mut replicas, true)
                    && attempt.verdict.decision == Decision::Differs
                {
                    (judged, verdict) = (attempt.judged, attempt.verdict);
                }
                if verdict.decided_by.is_none() {
                    let shown = verdict.shown.theirs.values.as_flattened();
                    verdict.regions = regions(&judged, &areas, shown);
                }
                verdict.explain(reason);
            }
            Decision::Agrees if !judged.is_fixed => {
                verdict.plants = judge.planted_defects(&mut replicas, &known, &judged);
                verdict.gains = smallest_gains(&judged.pool, &areas, &judged.ranking);
            }
            _ => {}
        }
        verdict.independent = independent;
        Some(verdict)
    }
}

/// So many of ours are held against several pictures of theirs at least.
const AGAINST_SEVERAL: usize = 16;

impl Case<'_> {
    /// As [`Case::verdict_on_several`], for a scene without random numbers: each picture is judged by itself, and the
    /// first that does not agree is said.
    fn verdict_on_each(&mut self, theirs: &[Picture], renders: Renders<'_>) -> Option<Verdict> {
        let mut last = None;
        for picture in theirs {
            let verdict = self.verdict(picture, renders)?;
            if verdict.decision != Decision::Agrees {
                return Some(verdict);
            }
            last = Some(verdict);
        }
        last
    }

    /// What is to be said of several pictures of one program with other seeds: nothing is assumed of their noise.
    /// `None` if the user interrupted before anything could be.
    pub fn verdict_on_several(
        &mut self,
        theirs: &[Picture],
        renders: Renders<'_>,
    ) -> Option<Verdict> {
        let areas = Areas::of(self.world);
        let (strictness, seed) = (self.strictness, self.seed);
        let (transfer, tone) = (self.transfer, self.tone);
        let mut replicas = Replicas::new(self.world, seed, renders);
        replicas.fill(strictness.first.max(AGAINST_SEVERAL));
        if replicas.films.len() < 3 {
            return None;
        }
        if replicas.films.windows(2).all(|two| two[0] == two[1]) {
            let renders = replicas.renders;
            return self.verdict_on_each(theirs, renders);
        }
        let candidates = Stored::candidates(&theirs[0], transfer, tone);
        let films = &replicas.films;
        let verdict = |stored: Stored| {
            let mut pictures: Vec<Vec<f32>> =
                films.iter().map(|film| stored.values(film)).collect();
            let ours = pictures.len();
            pictures.extend(theirs.iter().map(|picture| read(picture, stored)));
            let tests = several(&pictures[ours..], &pictures[..ours], &areas);
            let (subject, slack) = ((stored, &areas, strictness), stored.slack(&films[0]));
            Verdict::of_several(subject, (&pictures, ours), theirs, &tests, &slack)
        };
        let ways = plausible(&candidates, &theirs[0], films);
        better(ways.into_iter().map(verdict), |verdict| verdict.decision)
    }
}

/// The seed, counted from the first, of a replica that has the same bits.
fn equal_to(films: &[Film], theirs: &Picture, stored: Stored) -> Option<usize> {
    let theirs = read(theirs, stored);
    films.iter().position(|film| stored.values(film) == theirs)
}

/// Where the picture differs, the farthest out first; no two regions share a pixel.
fn regions(judged: &Evaluation, areas: &Areas, shown: &[f32]) -> Vec<DifferingRegion> {
    let theirs = judged.pool.count() - 1;
    let map = Map::of(&judged.pool, areas, theirs, judged.ranking.noise[theirs]);
    let mut taken = vec![false; areas.object_of.len()];
    let mut regions = Vec::new();
    let outliers: Vec<usize> = map.outliers().collect();
    if judged.is_fixed && !outliers.is_empty() {
        regions.push(DifferingRegion::of_pixels(&judged.pool, areas, &outliers, shown));
    }
    for difference in judged.ranking.differences(&judged.pool, areas, theirs) {
        let pixels = areas.pixels(difference.area);
        if regions.len() == REGIONS || pixels.iter().any(|pixel| taken[*pixel]) {
            continue;
        }
        pixels.iter().for_each(|pixel| taken[*pixel] = true);
        regions.push(DifferingRegion::of_area(&judged.pool, areas, &map, (difference, shown)));
    }
    if regions.is_empty() && !outliers.is_empty() {
        regions.push(DifferingRegion::of_pixels(&judged.pool, areas, &outliers, shown));
    }
    regions
}
