//! Who may have made a picture: the known mistakes in all their forms, and changes in one place of the scene.

use groundtruth::film::Film;
use groundtruth::render::{self, Canvas, Renderer};
use groundtruth::rgb::Rgb;
use groundtruth::scene::Scene;
use groundtruth::world::World;
use rayon::prelude::*;

use super::{Case, Cause, Place};
use crate::mistakes::local::{self, Local};
use crate::mistakes::{self, Mistake, Mistaken, Probed};

/// One that may have made a picture.
pub(super) enum Suspect {
    Known(&'static Mistake),
    Local(Box<Local>),
}

impl Suspect {
    pub fn cause(&self) -> Cause {
        let (name, words, chapter) = match self {
            Self::Known(mistake) => (Some(mistake.name), mistake.sentence(), Some(mistake.chapter)),
            Self::Local(local) => (local.everywhere, local.words.clone(), None),
        };
        Cause { name, words, chapter, also: None }
    }

    /// Its picture of a scene with a seed; `None` if it has none, or if the search is to end.
    pub fn picture(&self, of: &Case<'_>, seed: u64) -> Option<Film> {
        match self {
            Self::Known(mistake) => {
                let mistaken = Mistaken::new(mistake, of.scene, of.folder, seed).ok()??;
                let canvas = Canvas::new(mistaken.world());
                canvas.render_until(&mistaken, of.is_over).then(|| canvas.film())
            }
            Self::Local(local) => {
                let mut changed = local.scene.clone();
                changed.image = of.scene.image.clone();
                let world = World::build_seeded(&changed, of.folder, seed).ok()?;
                let canvas = Canvas::new(&world);
                canvas.render_until(&world, of.is_over).then(|| canvas.film())
            }
        }
    }
}

/// The values of some pixels, for each of some seeds: of ours, and of each suspect who changes them.
pub(super) struct Lineup {
    /// The scene, whose image has few samples.
    pub scene: Scene,
    pub seeds: Vec<u64>,
    pub pixels: Vec<[u32; 2]>,
    pub ours: Vec<Vec<Rgb>>,
    pub suspects: Vec<(Suspect, Vec<Vec<Rgb>>)>,
}

/// Pictures have at most so many samples per pixel.
const FEW_SAMPLES: u32 = 16;

/// And at least so many, if the scene has them.
const FEWEST_SAMPLES: u32 = 4;

/// And about so many in all, if that is not fewer.
const SAMPLES: u32 = 1 << 15;

/// Between the seeds of the two pictures of a suspect.
const APART: u64 = 1 << 20;

impl Case<'_> {
    /// Some pixels of ours and of all suspects: with two seeds if there is noise. As much as there is when the search is
    /// to end.
    pub(super) fn lineup(&self, pixels: &[[u32; 2]], has_noise: bool, places: &[Place]) -> Lineup {
        let mut scene = self.scene.clone();
        if has_noise {
            let few = (SAMPLES / pixels.len() as u32).clamp(FEWEST_SAMPLES, FEW_SAMPLES);
            scene.image.samples = scene.image.samples.min(few);
        }
        let seeds = [self.seed, self.seed + APART];
        let seeds = seeds[..if has_noise { 2 } else { 1 }].to_vec();
        let (pixels, ours) = (pixels.to_vec(), Vec::new());
        let mut found = Lineup { scene, seeds, pixels, ours, suspects: Vec::new() };
        let mut tried = mistakes::forms();
        for seed in &found.seeds {
            let of = (&found.scene, self.folder, *seed);
            let known = mistakes::probed(&tried, of, &found.pixels, self.is_over);
            let Ok(Some(Probed { ours, altered })) = known else { return found };
            // one that changes the picture of one seed alone changes it by next to nothing
            tried = altered.iter().map(|(mistake, _)| *mistake).collect();
            found.ours.push(ours);
            for (mistake, values) in altered {
                let is_it = |it: &Suspect| matches!(it, Suspect::Known(known) if *known == mistake);
                match found.suspects.iter_mut().find(|(it, _)| is_it(it)) {
                    Some((_, of_seeds)) => of_seeds.push(values),
                    None => found.suspects.push((Suspect::Known(mistake), vec![values])),
                }
            }
        }
        found.suspects.retain(|(_, values)| values.len() == found.seeds.len());
        let mut changed = local::without_shadows(self.scene);
        for place in places {
            if let Some(material) = &place.material {
                changed.extend(local::in_material(self.scene, material));
            }
            if let [object] = &*place.objects {
                changed.extend(local::without(self.scene, object));
            }
        }
        self.suspect(changed, &mut found);
        found
    }

    /// Adds those of the changed scenes whose pixels are not ours.
    pub(super) fn suspect(&self, changed: Vec<Local>, lineup: &mut Lineup) {
        let of = |local: Local| {
            let of_seed = |(seed, ours): (&u64, &Vec<Rgb>)| {
                let values = self.pixels(&local.scene, *seed, lineup)?;
                (values != *ours).then_some(values)
            };
            let values: Option<Vec<Vec<Rgb>>> =
                lineup.seeds.iter().zip(&lineup.ours).map(of_seed).collect();
            Some((Suspect::Local(Box::new(local)), values?))
        };
        let more: Vec<_> = changed.into_iter().filter_map(of).collect();
        lineup.suspects.extend(more);
    }

    /// The pixels of a lineup in another scene; `None` if it has no world, or the search is to end.
    pub(super) fn pixels(&self, scene: &Scene, seed: u64, lineup: &Lineup) -> Option<Vec<Rgb>> {
        let mut scene = scene.clone();
        scene.image = lineup.scene.image.clone();
        let world = World::build_seeded(&scene, self.folder, seed).ok()?;
        let of = |at: &[u32; 2]| (!(self.is_over)()).then(|| render::pixel(&world, *at));
        lineup.pixels.par_iter().map(of).collect()
    }
}
