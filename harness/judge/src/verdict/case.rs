//! One picture of a scene, from its file to what is said of it.

use std::path::Path;

use groundtruth::film::Film;
use groundtruth::scene::Scene;
use groundtruth::world::World;

use super::attempt::{Judge, better, read};
use super::finding::More;
use super::{
    Areas, DecidedBy, Decision, Finding, Progress, RayTolerance, Reference, Renders, Replicas,
    Stored, Strictness, Verdict, lossy, plausible, several, smallest_gains,
};
use crate::mistakes::IsOver;
use pictures::compare::{Picture, Transfer};

/// So many of ours are held against several pictures of theirs at least.
const AGAINST_SEVERAL: usize = 16;

/// A scene, and how strictly its pictures are judged.
#[derive(Clone, Copy)]
pub struct Case<'a> {
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
    /// The seed of the first replica.
    pub seed: u64,
    /// A mean of other pictures of ours, if one was rendered before.
    pub reference: Option<&'a Reference>,
    /// How far the rays of the other renderer may be from ours.
    pub tolerance: RayTolerance,
}

impl<'a> Case<'a> {
    /// A scene whose files are in this folder, judged as usual, whose replicas have seeds from this one on; nobody waits for
    /// what is known so far, and the search for causes has no end of its own.
    pub fn new(scene: &'a Scene, folder: &'a Path, seed: u64) -> Self {
        Self {
            scene,
            folder,
            is_over: &|| false,
            so_far: &|_| {},
            strictness: Strictness::USUAL,
            transfer: None,
            seed,
            reference: None,
            tolerance: RayTolerance::DOUBLE,
        }
    }

    /// What is to be said of a picture, or of several of one program with other seeds, of the scene's world at their size;
    /// `None` if the user interrupted before anything could be. The world's seed changes.
    pub fn verdict(
        &self,
        world: &mut World,
        theirs: &[Picture],
        renders: Renders<'_>,
    ) -> Option<Verdict> {
        let areas = Areas::of(world);
        let judge = Judge { areas: &areas, case: *self };
        let replicas = Replicas::new(world, self.seed, renders);
        match theirs {
            [only] => judge.verdict_on_one(only, replicas),
            several => judge.verdict_on_several(several, replicas),
        }
    }

    /// The ways of storing that the values of a picture leave open, the likeliest first; `films` are some of ours.
    pub(super) fn ways(&self, theirs: &Picture, films: &[Film]) -> Vec<Stored> {
        plausible(&self.candidates(theirs), theirs, films)
    }

    /// All ways in which the values of a picture may be stored.
    pub(super) fn candidates(&self, theirs: &Picture) -> Vec<Stored> {
        let image = &self.scene.image;
        Stored::candidates(theirs, self.transfer, (image.gamma, image.out_of_gamut))
    }
}

impl Judge<'_> {
    fn verdict_on_one(&self, theirs: &Picture, mut replicas: Replicas<'_, '_>) -> Option<Verdict> {
        replicas.fill(self.strictness.first);
        let independent = self.match_noise(theirs, &mut replicas);
        let mut finding = self.judged(theirs, &mut replicas)?;
        let stored = finding.judged.pool.stored;
        let mut more = More::default();
        let values = read(theirs, stored);
        if let Some(equal) = replicas.films.iter().position(|film| stored.values(film) == values) {
            more.equal_to_seed = Some(self.seed + equal as u64);
            return Some(finding.with(more, self.areas, self.strictness));
        }
        more.independent = independent;
        let is_loss = |loss: f64| lossy::agrees(theirs, loss, stored, &replicas.films);
        match finding.decision {
            Decision::Differs if theirs.loss.is_some_and(is_loss) => more.loss = theirs.loss,
            // beside that, nothing is to be explained
            Decision::Differs if finding.decided_by == Some(DecidedBy::Negative) => {}
            Decision::Differs => {
                (self.so_far)(Progress::Explaining);
                more.reason = self.reason(theirs, &mut replicas, &finding.judged);
                if let Some(way) = more.reason.way.filter(|way| *way != stored)
                    && let Some(other) = self.judged_as(theirs, way, &mut replicas, true)
                    && other.decision == Decision::Differs
                {
                    finding = other;
                }
            }
            Decision::Agrees if !finding.judged.is_fixed => {
                let judged = &finding.judged;
                more.plants = self.planted_defects(&mut replicas, judged);
                more.gains = smallest_gains(&judged.pool, self.areas, &judged.ranking);
            }
            _ => {}
        }
        Some(finding.with(more, self.areas, self.strictness))
    }

    /// Nothing is assumed of the noise of several pictures. Of a scene without random numbers each is judged by itself, and
    /// the first that does not agree is said.
    fn verdict_on_several(
        &self,
        theirs: &[Picture],
        mut replicas: Replicas<'_, '_>,
    ) -> Option<Verdict> {
        replicas.fill(self.strictness.first.max(AGAINST_SEVERAL));
        if replicas.films.len() < 3 {
            return None;
        }
        if replicas.films.windows(2).all(|two| two[0] == two[1]) {
            let mut last = None;
            for picture in theirs {
                let again = Replicas::new(replicas.world, self.seed, replicas.renders);
                let verdict = self.verdict_on_one(picture, again)?;
                if verdict.decision != Decision::Agrees {
                    return Some(verdict);
                }
                last = Some(verdict);
            }
            return last;
        }
        let films = &replicas.films;
        let found = |stored: Stored| {
            let ours = stored.all(films);
            let values: Vec<Vec<f32>> = theirs.iter().map(|it| read(it, stored)).collect();
            let tests = several(&values, &ours, self.areas);
            let subject = (stored, self.areas, self.strictness);
            let slack = stored.slack(&films[0]);
            Finding::of_several(subject, [&values, &ours], &tests, &slack, theirs)
        };
        let found = self.ways(&theirs[0], films).into_iter().map(found);
        better(found).map(|it| it.verdict(self.areas, self.strictness))
    }
}
