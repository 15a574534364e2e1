//! The pictures of a scene with another seed: ours, and those of mistakes.

use std::path::Path;

use groundtruth::film::Film;
use groundtruth::render;
use groundtruth::scene::{Scene, SceneError};
use groundtruth::world::World;

use super::films::{Films, films};
use super::{Mistake, Mistaken};

/// The picture of a mistake with a seed; `None` if the mistake does not apply to the scene. Files that the scene names
/// are in the folder.
///
/// # Errors
/// If the scene has no world.
pub fn replica(
    mistake: &'static Mistake,
    original: &Scene,
    folder: &Path,
    seed: u64,
) -> Result<Option<Film>, SceneError> {
    let mistaken = Mistaken::new(mistake, original, folder, seed)?;
    Ok(mistaken.map(|it| render::render(&it)))
}

/// The pictures of those of these mistakes that apply to a scene, with a seed. A mistake whose change gives no valid
/// scene does not apply.
///
/// # Errors
/// If the scene has no world.
pub fn replicas(
    mistakes: &[&'static Mistake],
    original: &Scene,
    folder: &Path,
    seed: u64,
) -> Result<Films, SceneError> {
    let world = World::build_seeded(original, folder, seed)?;
    let mut films = films(&world, mistakes);
    drop(world);
    for mistake in mistakes.iter().copied().filter(|mistake| !mistake.is_reweighed()) {
        match replica(mistake, original, folder, seed) {
            Ok(Some(film)) if film != films.ours => films.altered.push((mistake, film)),
            _ => films.unchanged.push(mistake),
        }
    }
    // as in the list of all: both sorts are stable
    films.altered.sort_by_key(|(mistake, _)| mistake.chapter);
    films.unchanged.sort_by_key(|mistake| mistake.chapter);
    Ok(films)
}
