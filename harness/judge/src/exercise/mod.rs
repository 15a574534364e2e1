//! An exercise for a class: pictures of programs with one mistake each, which are to be found.

mod key;
mod sheet;

use std::path::Path;

use groundtruth::invalid::Invalid;
use groundtruth::math::Pcg32;
use groundtruth::scene::Scene;
use groundtruth::world::DEFAULT_SEED;

use super::mistakes::table::sized;
use super::mistakes::{self, Beside, Mistake, MistakeInScene, is_wrong_on_purpose};

pub use key::key;
pub use sheet::sheet;

const SAMPLES: u32 = 16;

/// A picture, and the mistake that is to be found.
#[derive(Clone, Debug)]
pub struct Task {
    /// The mistake.
    pub mistake: &'static Mistake,
    /// The scene of the gallery.
    pub name: &'static str,
    /// The scene, in the size of the picture.
    pub scene: Scene,
    /// The right picture and the wrong one.
    pub pictures: Beside,
}

/// How much of a picture is wrong: the less, the harder is the mistake to find.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Difficulty {
    /// Most of it; and the sheet lists the mistakes among which they are.
    Easy,
    /// A part; with such a list, too.
    Medium,
    /// A few pixels, without a list.
    Hard,
}

impl Difficulty {
    /// The share of changed pixels that is looked for.
    fn share(self) -> f64 {
        match self {
            Self::Easy => 0.6,
            Self::Medium => 0.2,
            Self::Hard => 0.02,
        }
    }
}

/// Some tasks of a chapter, each with another mistake, in an order that follows from the seed. There are fewer than are
/// asked for if the chapter has fewer mistakes that can be seen.
///
/// # Errors
/// If a scene of the gallery has no world.
pub fn tasks(
    chapter: u32,
    level: Difficulty,
    (count, width): (usize, u32),
    seed: u64,
    finished: &mut dyn FnMut(),
) -> Result<Vec<Task>, Invalid> {
    let mut all = of_chapter(chapter);
    Pcg32::new(seed, u64::from(chapter)).shuffle(&mut all);
    let mut tasks: Vec<Task> = Vec::new();
    for mistake in all {
        if tasks.len() == count {
            break;
        }
        let used: Vec<&str> = tasks.iter().map(|task| task.name).collect();
        for name in scenes(mistake, level, &used) {
            if let Some(task) = task(mistake, name, width)? {
                tasks.push(task);
                finished();
                break;
            }
        }
    }
    Ok(tasks)
}

/// The mistakes of a chapter that a scene of the chapters up to it shows.
fn of_chapter(chapter: u32) -> Vec<&'static Mistake> {
    let is_shown = |mistake: &&Mistake| mistake.chapter == chapter && !reached(mistake).is_empty();
    mistakes::all().into_iter().filter(is_shown).collect()
}

/// The scenes of the chapters up to its own that show a mistake.
fn reached(mistake: &Mistake) -> Vec<&'static MistakeInScene> {
    let mut pairs = mistakes::scenes_that_show(mistake);
    pairs.retain(|pair| {
        !is_wrong_on_purpose(pair.scene) && chapter_of(pair.scene) <= Some(mistake.chapter)
    });
    pairs
}

/// The scenes that show a mistake to a class that has come to its chapter: those that are new first, then by the share of
/// pixels that is looked for.
fn scenes(mistake: &Mistake, level: Difficulty, used: &[&str]) -> Vec<&'static str> {
    let mut pairs = reached(mistake);
    let off = |pair: &MistakeInScene| (pair.effect.share - level.share()).abs();
    pairs.sort_by(|a, b| {
        let is_used = |pair: &MistakeInScene| used.contains(&pair.scene);
        is_used(a).cmp(&is_used(b)).then(off(a).total_cmp(&off(b)))
    });
    pairs.into_iter().map(|pair| pair.scene).collect()
}

/// The chapter of `ch28/glass-sphere`.
fn chapter_of(scene: &str) -> Option<u32> {
    scene.strip_prefix("ch")?.get(..2)?.parse().ok()
}

/// The task of this mistake in this scene; `None` if it cannot be seen there in this size.
fn task(
    mistake: &'static Mistake,
    name: &'static str,
    width: u32,
) -> Result<Option<Task>, Invalid> {
    let entry = gallery::find(name).expect("the table is of the gallery");
    let scene = sized((entry.build)(), width, SAMPLES);
    let pictures = Beside::of(mistake, &scene, Path::new(""), DEFAULT_SEED)?;
    let pictures = pictures.filter(|it| it.effect().is_shown());
    Ok(pictures.map(|pictures| Task { mistake, name, scene, pictures }))
}
