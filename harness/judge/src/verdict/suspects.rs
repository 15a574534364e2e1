//! Who may have made a picture: the known mistakes in all their forms, and changes in one place of the scene.

use std::path::Path;

use groundtruth::film::Film;
use groundtruth::render;
use groundtruth::scene::Scene;
use groundtruth::world::World;
use rayon::prelude::*;

use super::causes::{Cause, finite};
use super::evidence::Evidence;
use super::place::Place;
use crate::mistakes::local::{self, Local};
use crate::mistakes::{self, Films, Mistake};

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

/// One that may have made a picture.
pub(super) enum Suspect {
    /// A known mistake.
    Known(&'static Mistake),
    /// A change in one place.
    Local(Box<Local>),
}

impl Suspect {
    /// As a cause.
    pub fn cause(&self) -> Cause {
        match self {
            Self::Known(mistake) => Cause {
                name: Some(mistake.name),
                words: mistake.sentence(),
                chapter: Some(mistake.chapter),
            },
            Self::Local(local) => {
                Cause { name: local.everywhere, words: local.words.clone(), chapter: None }
            }
        }
    }

    /// Its picture of a scene with a seed; `None` if it has none.
    pub fn picture(&self, scene: &Scene, folder: &Path, seed: u64) -> Option<Film> {
        match self {
            Self::Known(mistake) => mistakes::replica(mistake, scene, folder, seed).ok().flatten(),
            Self::Local(local) => {
                let mut changed = local.scene.clone();
                changed.image = scene.image.clone();
                Some(render::render(&World::build_seeded(&changed, folder, seed).ok()?))
            }
        }
    }
}

/// A suspect, and for each of some seeds the change that it makes of our picture, over tiles.
pub(super) type Changes = Vec<(Suspect, Vec<Vec<f64>>)>;

/// Pictures have at most so many samples per pixel.
const FEW_SAMPLES: u32 = 16;

/// And at least so many, if the scene has them.
const FEWEST_SAMPLES: u32 = 4;

/// And about so many in all, if that is not fewer.
const SAMPLES: u32 = 1 << 20;

/// Between the seeds of the two pictures of a suspect.
const APART: u64 = 1 << 20;

impl Suspects<'_> {
    /// The changes that suspects make: with two seeds if there is noise.
    pub(super) fn changes(&self, evidence: &Evidence<'_>, place: Option<&Place>) -> Changes {
        let mut scene = self.scene.clone();
        let few = SAMPLES / (scene.image.width * scene.image.height).max(1);
        let few = few.clamp(FEWEST_SAMPLES, FEW_SAMPLES);
        scene.image.samples = scene.image.samples.min(few);
        let seeds = [self.seed, self.seed + APART];
        let seeds = if evidence.has_noise { &seeds[..] } else { &seeds[..1] };
        let (mut all, mut ours): (Changes, Vec<Vec<f32>>) = (Vec::new(), Vec::new());
        let mut tried = mistakes::forms();
        for seed in seeds {
            let known = mistakes::replicas(&tried, &scene, self.folder, *seed);
            let Ok(Films { ours: film, altered, .. }) = known else { return Vec::new() };
            // one that changes the picture of one seed alone changes it by next to nothing
            tried = altered.iter().map(|(mistake, _)| *mistake).collect();
            ours.push(evidence.stored.values(&film));
            let before = &ours[ours.len() - 1];
            let tiles = |(mistake, film): (&'static Mistake, Film)| {
                (mistake, change(evidence, &film, before))
            };
            let changes: Vec<_> = altered.into_par_iter().map(tiles).collect();
            changes.into_iter().for_each(|(mistake, tiles)| add(&mut all, mistake, tiles));
        }
        for local in self.changes_in_one_place(place) {
            if (self.is_interrupted)() {
                break;
            }
            let suspect = Suspect::Local(Box::new(local));
            let of_seed = |(seed, ours): (&u64, &Vec<f32>)| {
                Some(change(evidence, &suspect.picture(&scene, self.folder, *seed)?, ours))
            };
            let tiles: Option<Vec<Vec<f64>>> = seeds.iter().zip(&ours).map(of_seed).collect();
            let is_change = |it: &Vec<Vec<f64>>| it[0].iter().any(|value| *value != 0.0);
            all.extend(tiles.filter(is_change).map(|tiles| (suspect, tiles)));
        }
        all.retain(|(_, tiles)| tiles.len() == seeds.len());
        all
    }

    fn changes_in_one_place(&self, place: Option<&Place>) -> Vec<Local> {
        let mut all = local::without_shadows(self.scene);
        if let Some(place) = place {
            if let Some(material) = &place.material {
                all.extend(local::in_material(self.scene, material));
            }
            if let [object] = &*place.objects {
                all.extend(local::without(self.scene, object));
            }
        }
        all
    }
}

/// What a film is more than ours, over tiles.
fn change(evidence: &Evidence<'_>, film: &Film, ours: &[f32]) -> Vec<f64> {
    let altered = evidence.stored.values(film);
    evidence.tiles(|at| finite(f64::from(altered[at]) - f64::from(ours[at])))
}

fn add(all: &mut Changes, mistake: &'static Mistake, tiles: Vec<f64>) {
    let is_it = |it: &Suspect| matches!(it, Suspect::Known(known) if *known == mistake);
    match all.iter_mut().find(|(it, _)| is_it(it)) {
        Some((_, of_seeds)) => of_seeds.push(tiles),
        None => all.push((Suspect::Known(mistake), vec![tiles])),
    }
}
