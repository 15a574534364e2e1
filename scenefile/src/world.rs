//! Worlds of scene files, with errors by file and line.

use std::path::Path;

use groundtruth::scene::Scene;
use groundtruth::world::{DEFAULT_SEED, World};

use super::error::SceneError;
use super::file::{self, Source};

/// Reads a scene file and builds its world; files it names are relative to it.
///
/// # Errors
/// [`SceneError`] with file, line, object and field.
pub fn read(path: &Path) -> Result<(Scene, World), SceneError> {
    with_world(file::open(path)?)
}

/// The scene in a text, and its world; `path` is for error messages and for files it names.
///
/// # Errors
/// As [`read`].
pub fn from_toml(text: &str, path: &Path) -> Result<(Scene, World), SceneError> {
    with_world(file::parse(text.to_owned(), path)?)
}

fn with_world((scene, source): (Scene, Source)) -> Result<(Scene, World), SceneError> {
    let world = source.world(&scene, DEFAULT_SEED)?;
    Ok((scene, world))
}
