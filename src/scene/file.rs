//! Scenes as TOML text.

use std::path::Path;

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::error::Place;
use super::{Scene, SceneError};
use crate::invalid::{Invalid, Key};
use crate::world::World;

/// Larger files are no scenes: large things are procedural kinds or mesh files.
const LARGEST_FILE: u64 = 64 << 20;

/// Reads a scene file and builds its world; files it names are relative to it.
///
/// # Errors
/// [`SceneError`] with file, line, object and field.
pub fn read(path: &Path) -> Result<(Scene, World), SceneError> {
    let unreadable = |source| SceneError::Unreadable { path: path.to_owned(), source };
    let size = std::fs::metadata(path).map_err(unreadable)?.len();
    if size > LARGEST_FILE {
        let problem = format!("{size} bytes are too large for a scene (at most {LARGEST_FILE})");
        return Err(unreadable(std::io::Error::other(problem)));
    }
    let text = std::fs::read_to_string(path).map_err(unreadable)?;
    from_toml(&text, path)
}

/// The scene in a text, and its world; `path` is for error messages and for files it names.
///
/// # Errors
/// As [`read`].
pub fn from_toml(text: &str, path: &Path) -> Result<(Scene, World), SceneError> {
    let syntax = |source| SceneError::Syntax { path: path.to_owned(), source: Box::new(source) };
    let scene: Scene = toml::from_str(text).map_err(syntax)?;
    let folder = path.parent().unwrap_or(Path::new(""));
    let world = World::build_in(&scene, folder).map_err(|error| match error {
        SceneError::Invalid { invalid, .. } => {
            let place = Place::line(path, line_of(text, &invalid.path));
            SceneError::Invalid { place, invalid }
        }
        other => other,
    })?;
    Ok((scene, world))
}

/// The line (from 1) of the value at this path, or of the innermost part of the path that the text
/// has: a field with a default need not be written.
fn line_of(text: &str, path: &[Key]) -> usize {
    let Ok(document) = DeTable::parse(text) else { return 1 };
    let span = document.span();
    let mut value = &Spanned::new(span, DeValue::Table(document.into_inner()));
    let mut start = 0;
    for key in path {
        let next = match key {
            Key::Field(name) => value.as_ref().get(name.as_str()),
            Key::Item(index, _) => value.as_ref().get(*index),
        };
        let Some(next) = next else { break };
        value = next;
        start = value.span().start;
    }
    1 + text.as_bytes()[..start.min(text.len())].iter().filter(|&&byte| byte == b'\n').count()
}

/// The scene as text that reads back to the same scene, every bit of it.
///
/// # Errors
/// [`SceneError::NotPlain`] names what is of a custom kind.
pub fn to_toml(scene: &Scene) -> Result<String, SceneError> {
    all_plain(scene).map_err(|invalid| SceneError::NotPlain { invalid })?;
    toml::to_string(scene)
        .map_err(|e| SceneError::NotPlain { invalid: Invalid::new(e.to_string()) })
}

/// Whether nothing is of a user's own kind, which has no text.
fn all_plain(scene: &Scene) -> Result<(), Invalid> {
    for (i, object) in scene.objects.iter().enumerate() {
        plain(&object.shape, &["shape"], Some(("objects", i, &object.name)))?;
    }
    for (i, light) in scene.lights.iter().enumerate() {
        plain(&light.source, &["source"], Some(("lights", i, &light.name)))?;
    }
    for (i, material) in scene.materials.iter().enumerate() {
        plain(&material.recipe, &["recipe"], Some(("materials", i, &material.name)))?;
    }
    plain(&scene.camera.lens, &["camera", "lens"], None)?;
    plain(&scene.image, &["image", "sampler"], None)
}

/// Whether serde can write it: it refuses the variants of users' own kinds, which carry no data.
fn plain(
    data: &impl serde::Serialize,
    fields: &[&str],
    item: Option<(&str, usize, &str)>,
) -> Result<(), Invalid> {
    if toml::Value::try_from(data).is_ok() {
        return Ok(());
    }
    let problem = Invalid::new("is of a custom kind, which a scene file cannot say");
    let problem = fields.iter().rev().fold(problem, |e, &field| e.inside(field));
    Err(match item {
        Some((list, i, name)) => problem.inside(Key::Item(i, Some(name.to_owned()))).inside(list),
        None => problem,
    })
}
