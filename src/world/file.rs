//! Worlds of scene files, with errors by file and line.

use std::path::Path;

use super::{DEFAULT_SEED, World};
use crate::scene::{self, Scene, SceneError, Source};

impl World {
    /// Builds a scene that was read from `source`, and may have been changed since.
    ///
    /// # Errors
    /// [`SceneError`] with file, line, object and field.
    pub fn of_source(scene: &Scene, source: &Source, seed: u64) -> Result<Self, SceneError> {
        Self::build_seeded(scene, source.folder(), seed).map_err(|error| source.located(error))
    }
}

/// Reads a scene file and builds its world; files it names are relative to it.
///
/// # Errors
/// [`SceneError`] with file, line, object and field.
pub fn read(path: &Path) -> Result<(Scene, World), SceneError> {
    with_world(scene::open(path)?)
}

/// The scene in a text, and its world; `path` is for error messages and for files it names.
///
/// # Errors
/// As [`read`].
pub fn from_toml(text: &str, path: &Path) -> Result<(Scene, World), SceneError> {
    with_world(scene::parse(text.to_owned(), path)?)
}

fn with_world((scene, source): (Scene, Source)) -> Result<(Scene, World), SceneError> {
    let world = World::of_source(&scene, &source, DEFAULT_SEED)?;
    Ok((scene, world))
}
